//! The report of a run, for people and programs.

use std::fmt;

use hdrhistogram::Histogram;
use midi::sound::SoundReport;
use serde::{Deserialize, Serialize};

use engine::voice::AuditReport;

mod board_line;
mod fidelity;
mod link_line;
mod note_report;
mod overload;
mod step_counts;
mod verdict;

pub use board_line::BoardLine;
pub(crate) use board_line::{
    key_names, late_periods_words, misplaced_words, muted_keys, softened_words, stage_words,
    unproven_words,
};
pub use fidelity::{ChosenFidelity, RefusedFidelity};
pub use link_line::LinkLine;
pub(crate) use link_line::wire_words;
pub use note_report::{
    ErrorQuantiles, NoteCut, NoteDeviation, NoteReport, NoteShortfall, UnplayedNotes,
};
pub use overload::{LeftOut, OverloadReport};
pub use step_counts::StepCounts;

/// The report of `letoff run`, as `--json` prints it.
#[derive(Clone, Debug, Serialize)]
pub struct RunReport {
    pub scene: String,
    #[serde(flatten)]
    pub extent: RunExtent,
    pub realtime: Realtime,
    pub deadline: Deadline,
    /// Quality of the performance; `None` without a pianist.
    pub notes: Option<NoteReport>,
    #[serde(flatten)]
    pub totals: VoiceTotals,
    /// Exchange with the boards, summed over them.
    pub links: LinkReport,
    pub boards: Vec<BoardLine>,
    pub lines: Vec<LinkLine>,
    /// Energy audit of all voices (J).
    pub energy_audit: AuditReport,
    pub midi: MidiReport,
    pub recording: Option<RecordingReport>,
    pub overload: OverloadReport,
    /// The first 1000 gaps of ticks, in order. A note that was played there may be missing.
    pub pauses: Vec<LostTicks>,
    /// Fidelity of the key ranges that left it to the host.
    pub fidelity: Vec<ChosenFidelity>,
}

/// Voices, ticks and threads of a run, and its length.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct RunExtent {
    pub voices: usize,
    pub tick_hz: u32,
    pub ticks: u64,
    /// Ticks that never ran; `deadline` counts them as missed.
    pub skipped: u64,
    pub duration_s: f64,
    /// `true` if `letoff stop` ended it: its boards render no force until they are restarted.
    pub stopped: bool,
    pub lanes: usize,
}

/// Events, faults and work of all voices.
#[derive(Clone, Debug, Serialize)]
pub struct VoiceTotals {
    /// Reset maps applied by all models.
    pub events: u64,
    pub strikes: u64,
    pub faults: u64,
    /// Keys muted because they generated energy or failed repeatedly.
    pub muted: Vec<String>,
    /// Key events for which a ring had no room.
    pub dropped: u64,
    pub work: Evaluations,
    /// Steps by certainty of their crossings.
    pub steps: StepCounts,
}

/// The outcome of a recording.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize)]
pub struct RecordingReport {
    pub file: String,
    pub files: u64,
    pub messages: u64,
    pub bytes: u64,
    /// Reason of an early end; a sentence.
    pub trouble: Option<String>,
}

impl RunReport {
    /// Returns a sentence on each faulty link and board; none after `letoff stop`.
    pub fn board_troubles(&self) -> Vec<String> {
        let faults = self.lines.iter().filter_map(|line| line.fault.clone());
        let boards = self.boards.iter().filter(|_| !self.extent.stopped);
        faults.chain(boards.flat_map(BoardLine::troubles)).collect()
    }

    /// Returns `true` if a board or a key was not played as intended, or only softly, or a link
    /// is down for good.
    pub fn has_failed_board(&self) -> bool {
        let has_fault = self.lines.iter().any(|line| line.fault.is_some());
        let has_failed = self.boards.iter().any(BoardLine::has_failed);
        has_fault || 0 < self.extent.ticks && !self.extent.stopped && has_failed
    }
}

/// The rights that the system granted.
#[derive(Clone, Debug, Serialize)]
pub struct Realtime {
    /// Scheduling policy of the tick, or `virtual time`.
    pub policy: String,
    /// `true` if memory cannot be paged out.
    pub memory_locked: bool,
    /// `true` if processors are kept from deep sleep.
    pub latency_held: bool,
    pub advice: Vec<String>,
}

/// Deadlines and the measurements around them.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Deadline {
    /// Ticks with late forces, or that never ran.
    pub missed: u64,
    pub missed_own_work: u64,
    /// Those with no more evaluations than a tick in time, so no model took that time.
    pub own_work_unexplained: u64,
    /// Ticks without time because simulated keys made up for skipped ticks.
    pub by_simulated_keys: u64,
    pub missed_woken_late: u64,
    pub missed_preempted: u64,
    /// Wake-ups of the bare timer later than the usual tick's spare time; `None` in virtual time.
    pub timer_stops: Option<u64>,
    /// Time that a hypervisor took from all processors (s); `None` if the kernel does not count it.
    pub stolen_s: Option<f64>,
    pub lateness_us: Quantiles,
    /// CPU time of a tick.
    pub work_us: Quantiles,
    /// Time from samples in to forces out.
    pub turnaround_us: Quantiles,
    /// Lateness of a bare timer thread of equal priority.
    pub timer_baseline_us: Quantiles,
}

/// Consecutive ticks that never ran.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct LostTicks {
    /// Due time of the first (s).
    pub at_s: f64,
    pub ticks: u64,
}

/// Quantiles of a distribution (us).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the names say it")]
pub struct Quantiles {
    pub p50: f64,
    pub p99: f64,
    pub p99_9: f64,
    pub max: f64,
}

impl Quantiles {
    /// Returns the quantiles of a histogram of nanoseconds.
    pub fn of(histogram: &Histogram<u64>) -> Self {
        let at = |q: f64| histogram.value_at_quantile(q) as f64 * 1e-3;
        Self { p50: at(0.5), p99: at(0.99), p99_9: at(0.999), max: histogram.max() as f64 * 1e-3 }
    }
}

/// Evaluations, independent of the machine.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Evaluations {
    pub derivatives: u64,
    pub guards: u64,
}

/// Exchange on all links to the boards.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct LinkReport {
    pub frames: u64,
    pub gaps: u64,
    pub refused: u64,
    /// Times that boards were rearmed after their watchdogs had removed the forces.
    pub rearmed: u64,
}

/// The outcome of the MIDI output.
#[derive(Clone, Debug, Default, Serialize)]
pub struct MidiReport {
    pub output: String,
    /// Time from strike to hand-over, in real time.
    pub handover_us: Option<Quantiles>,
    /// Time from hand-over through the MIDI guardian to the port.
    pub passed_on_us: Option<Quantiles>,
    /// Silences of the host so long that the guardian ended its notes.
    pub interruptions: u64,
    pub failed: u64,
    /// Sound and picture beside the output; `None` if there is neither.
    pub sound: Option<String>,
    pub callbacks: Option<SoundReport>,
    pub trouble: Option<String>,
}

impl fmt::Display for RunReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let RunExtent { voices, tick_hz, ticks, skipped, duration_s, lanes, .. } = self.extent;
        writeln!(
            f,
            "{}: {voices} voices, {ticks} ticks at {tick_hz} Hz ({duration_s:.1} s) on {lanes} lane(s)",
            self.scene
        )?;
        if self.extent.stopped {
            writeln!(f, "  STOPPED     boards render no force until they are started anew")?;
        }
        writeln!(f, "  result      {}", self.verdict())?;
        let locked = if self.realtime.memory_locked { "locked" } else { "not locked" };
        writeln!(f, "  real time   {}, memory {locked}", self.realtime.policy)?;
        for advice in &self.realtime.advice {
            writeln!(f, "              {advice}")?;
        }
        self.deadline.fmt_lines(f, skipped)?;
        self.fmt_pauses(f)?;
        self.overload.fmt_lines(f)?;
        if let Some(notes) = &self.notes {
            notes.fmt_lines(f)?;
        }
        let VoiceTotals { events, strikes, faults, muted, work, steps, .. } = &self.totals;
        writeln!(
            f,
            "  models      {events} events, {strikes} strikes, {faults} faults; {:.1} derivatives and {:.1} guards per tick",
            work.derivatives as f64 / ticks.max(1) as f64,
            work.guards as f64 / ticks.max(1) as f64,
        )?;
        steps.fmt_lines(f)?;
        if !muted.is_empty() {
            let keys = muted.join(", ");
            writeln!(f, "  muted       {keys}: they made energy, or failed again and again")?;
        }
        let e = &self.energy_audit;
        writeln!(
            f,
            "  energy      supplied {:.4} J, dissipated {:.4} J, impacts {:.4} J, sampling {:.4} J, integration {:.1e} J, stored {:.4} J",
            e.supplied, e.dissipated, e.jumps, e.sampling, e.integration, e.stored
        )?;
        writeln!(
            f,
            "  boards      {} frames, {} gaps, {} refused",
            self.links.frames, self.links.gaps, self.links.refused
        )?;
        board_line::fmt_table(&self.boards, f)?;
        link_line::fmt_table(&self.lines, f)?;
        self.midi.fmt_line(f)
    }
}

const SHOWN_PAUSES: usize = 5;

impl RunReport {
    /// Returns the run in a sentence.
    pub fn sentence(&self) -> String {
        let VoiceTotals { strikes, faults, .. } = self.totals;
        match &self.notes {
            Some(notes) => {
                let NoteReport { struck, played, .. } = notes;
                format!("{struck} of {played} notes were struck; voices failed in {faults} turns.")
            }
            None => format!("{strikes} strikes; voices failed in {faults} turns."),
        }
    }

    fn fmt_pauses(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut longest: Vec<_> = self.pauses.iter().filter(|it| 1 < it.ticks).collect();
        if longest.is_empty() {
            return Ok(());
        }
        longest.sort_by_key(|it| std::cmp::Reverse(it.ticks));
        let shown = longest.iter().take(SHOWN_PAUSES);
        let shown: Vec<_> = shown.map(|it| format!("{} at {:.3} s", it.ticks, it.at_s)).collect();
        let more = if SHOWN_PAUSES < longest.len() { ", …" } else { "" };
        writeln!(f, "              ticks lost in a row: {}{more}", shown.join(", "))
    }
}

impl Deadline {
    fn fmt_lines(&self, f: &mut fmt::Formatter<'_>, skipped: u64) -> fmt::Result {
        writeln!(
            f,
            "  deadlines   {} missed: {} own work, {} woken late, {} preempted; {skipped} of these never run",
            self.missed, self.missed_own_work, self.missed_woken_late, self.missed_preempted
        )?;
        if 0 < self.own_work_unexplained {
            writeln!(
                f,
                "              {} of own work with no more evaluations than a tick in time",
                self.own_work_unexplained
            )?;
        }
        if 0 < self.by_simulated_keys {
            writeln!(
                f,
                "              {} as simulated keys made up for skipped ticks, which real ones do not",
                self.by_simulated_keys
            )?;
        }
        if let Some(stops) = self.timer_stops.filter(|stops| 0 < *stops) {
            writeln!(
                f,
                "              {stops} times the bare timer was later than a usual tick has to spare"
            )?;
        }
        if let Some(stolen) = self.stolen_s {
            writeln!(
                f,
                "              {stolen:.2} s were stolen from the processors, by the kernel's count"
            )?;
        }
        writeln!(f, "              [us]        p50      p99    p99.9      max")?;
        for (name, q) in [
            ("lateness", &self.lateness_us),
            ("bare timer", &self.timer_baseline_us),
            ("work", &self.work_us),
            ("turnaround", &self.turnaround_us),
        ] {
            writeln!(
                f,
                "              {name:10}{:9.1}{:9.1}{:9.1}{:9.1}",
                q.p50, q.p99, q.p99_9, q.max
            )?;
        }
        Ok(())
    }
}

impl MidiReport {
    /// Returns the name of the output, or the reason for its absence.
    pub(crate) fn words(&self) -> String {
        let Self { output, trouble, .. } = self;
        let port =
            trouble.as_ref().map_or_else(|| output.clone(), |why| format!("none, since {why}"));
        self.sound.as_ref().map_or_else(|| port.clone(), |sound| format!("{port}; {sound}"))
    }

    fn fmt_line(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "  midi        {}", self.output)?;
        if let Some(sound) = &self.sound {
            write!(f, "; {sound}")?;
        }
        if let Some(SoundReport { callbacks, long, late }) = self.callbacks {
            write!(f, ", {long} of {callbacks} periods took more than half their time, ")?;
            write!(f, "{late} messages were late")?;
        }
        if let Some(q) = &self.handover_us {
            write!(f, "; handed over after p50 {:.0} p99 {:.0} max {:.0} us", q.p50, q.p99, q.max)?;
        }
        if let Some(q) = &self.passed_on_us {
            write!(
                f,
                ", and by the guardian after p50 {:.0} p99 {:.0} max {:.0} us",
                q.p50, q.p99, q.max
            )?;
        }
        if 0 < self.interruptions {
            write!(f, "; notes ended {} times as the host was silent", self.interruptions)?;
        }
        match &self.trouble {
            Some(trouble) if self.failed > 0 => {
                writeln!(f, "; {} messages failed: {trouble}", self.failed)
            }
            Some(notice) => writeln!(f, "\n              {notice}"),
            None => writeln!(f),
        }
    }
}
