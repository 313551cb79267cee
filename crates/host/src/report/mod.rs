//! The report of a run, for people and for programs.

use std::fmt;

use hdrhistogram::Histogram;
use serde::{Deserialize, Serialize};

use engine::voice::AuditReport;

mod board_line;
mod fidelity;
mod link_line;
mod note_report;
mod overload;
mod step_counts;

pub use board_line::BoardLine;
pub(crate) use board_line::{
    key_names, late_periods_words, misplaced_words, muted_keys, softened_words, stage_words,
    unproven_words,
};
pub use fidelity::{ChosenFidelity, RefusedFidelity};
pub use link_line::LinkLine;
pub(crate) use link_line::wire_words;
pub use note_report::{ErrorQuantiles, NoteDeviation, NoteReport, NoteShortfall, UnplayedNotes};
pub use overload::{LeftOut, OverloadReport};
pub use step_counts::StepCounts;

/// The report of `letoff run`, as `--json` prints it.
#[derive(Clone, Debug, Serialize)]
pub struct RunReport {
    pub scene: String,
    #[serde(flatten)]
    pub extent: RunExtent,
    /// Rights that the system granted.
    pub realtime: Realtime,
    pub deadline: Deadline,
    /// Quality of the performance; `None` without a pianist.
    pub notes: Option<NoteReport>,
    #[serde(flatten)]
    pub totals: VoiceTotals,
    /// Exchange with the boards, summed over them.
    pub links: LinkReport,
    /// Each board, if there are real ones.
    pub boards: Vec<BoardLine>,
    /// Each link to them.
    pub lines: Vec<LinkLine>,
    /// Energy audit of all voices (J).
    pub energy_audit: AuditReport,
    pub midi: MidiReport,
    pub recording: Option<RecordingReport>,
    /// Work that was left out since ticks had more of it than time.
    pub overload: OverloadReport,
    /// The first 1000 places where ticks were never run, in order. A note that was played there may
    /// be missing.
    pub pauses: Vec<LostTicks>,
    /// Fidelity of the key ranges that left it to the host.
    pub fidelity: Vec<ChosenFidelity>,
}

/// Voices, ticks and threads of a run, and its length.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct RunExtent {
    /// Keys with a voice.
    pub voices: usize,
    pub tick_hz: u32,
    /// Ticks that were run.
    pub ticks: u64,
    /// Ticks that were never run; `deadline` counts them as missed.
    pub skipped: u64,
    /// Length of the run (s).
    pub duration_s: f64,
    /// `true` if `letoff stop` ended it: its boards render no force until they are restarted.
    pub stopped: bool,
    /// Threads that shared the tick.
    pub lanes: usize,
}

/// Events, faults and work, summed over all voices.
#[derive(Clone, Debug, Serialize)]
pub struct VoiceTotals {
    /// Reset maps applied by all models.
    pub events: u64,
    /// Hammers that met their string.
    pub strikes: u64,
    /// Turns that ended in a fault.
    pub faults: u64,
    /// Keys that were muted, because they made energy or failed again and again.
    pub muted: Vec<String>,
    /// Key events for which a ring had no room.
    pub dropped: u64,
    pub work: Evaluations,
    /// Steps, by whether a crossing can have been missed in them.
    pub steps: StepCounts,
}

/// The outcome of a recording.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize)]
pub struct RecordingReport {
    pub file: String,
    /// Files that it takes.
    pub files: u64,
    pub messages: u64,
    /// Bytes of all files.
    pub bytes: u64,
    /// The reason why it ended early, in a sentence.
    pub trouble: Option<String>,
}

impl RunReport {
    /// Returns what is wrong with links and boards when all is over, a sentence on each; nothing
    /// after `letoff stop`, which is why boards render no force then.
    pub fn board_troubles(&self) -> Vec<String> {
        let faults = self.lines.iter().filter_map(|line| line.fault.clone());
        let boards = self.boards.iter().filter(|_| !self.extent.stopped);
        faults.chain(boards.flat_map(BoardLine::troubles)).collect()
    }

    /// Returns whether a board or a key that was to be played was not, or only softly, or a link is
    /// down for good.
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
    /// Whether memory cannot be paged out.
    pub memory_locked: bool,
    /// Whether processors are kept from falling deeply asleep.
    pub latency_held: bool,
    /// The steps to get more rights, a sentence each.
    pub advice: Vec<String>,
}

/// Deadlines and what was measured around them.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Deadline {
    /// Ticks whose forces were out too late, or that were never run.
    pub missed: u64,
    /// Of these, because the voices took too long.
    pub missed_own_work: u64,
    /// Of these, with no more evaluations than a tick that was in time: no model took that time.
    pub own_work_unexplained: u64,
    /// Ticks that had no time since simulated keys made up for ticks that were skipped.
    pub by_simulated_keys: u64,
    /// Of the missed, because the system woke the tick too late.
    pub missed_woken_late: u64,
    /// Of these, because the system took the processor away.
    pub missed_preempted: u64,
    /// How often the bare timer was woken later than what a usual tick has to spare; none in virtual
    /// time.
    pub timer_stops: Option<u64>,
    /// Time that a hypervisor took from all processors during the run, as the kernel counts it
    /// (s); none where it does not.
    pub stolen_s: Option<f64>,
    pub lateness_us: Quantiles,
    /// CPU time of a tick.
    pub work_us: Quantiles,
    /// Samples in → forces out.
    pub turnaround_us: Quantiles,
    /// Lateness of a bare timer thread of the same priority, beside.
    pub timer_baseline_us: Quantiles,
}

/// Ticks in a row that were never run.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct LostTicks {
    /// When the first of them was due (s).
    pub at_s: f64,
    pub ticks: u64,
}

/// Quantiles of a distribution, in microseconds.
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

/// The exchange on the links to the boards.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct LinkReport {
    pub frames: u64,
    /// Frames that are known to be missing.
    pub gaps: u64,
    /// Bytes or frames that were refused.
    pub refused: u64,
    /// Times that boards were armed again after their watchdogs had taken the forces away.
    pub rearmed: u64,
}

/// The outcome of the MIDI output.
#[derive(Clone, Debug, Default, Serialize)]
pub struct MidiReport {
    pub output: String,
    /// Handed over − happened, in real time.
    pub handover_us: Option<Quantiles>,
    /// From there through the MIDI guardian to the port.
    pub passed_on_us: Option<Quantiles>,
    /// How often the host was silent for so long that the guardian ended its notes.
    pub interruptions: u64,
    /// Messages that could not be sent.
    pub failed: u64,
    /// The first reason, a sentence.
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

/// Pauses that are printed, the longest of a run.
const SHOWN_PAUSES: usize = 5;

impl RunReport {
    /// Prints where the longest pauses were.
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
    /// Returns the output in words, or why there is none.
    pub(crate) fn words(&self) -> String {
        let Self { output, trouble, .. } = self;
        trouble.as_ref().map_or_else(|| output.clone(), |why| format!("none, since {why}"))
    }

    fn fmt_line(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "  midi        {}", self.output)?;
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
