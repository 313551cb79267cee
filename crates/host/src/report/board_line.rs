use std::fmt;

use boards::identity::ClaimedKeys;
use boards::keybed::BoardReport;
use boards::refusal::{burst_words, clock_words, late_words, reason_words, restart_words};
use boards::rt::board_supervisor::{ArmLockout, ArmState, SlowSamples};
use boards::rt::key_fault::KeyFault;
use firmware_protocol::key::{KeyIndex, MOST_KEYS};
use serde::Serialize;

/// Part of a report about one board.
#[derive(Clone, Debug, Serialize)]
pub struct BoardLine {
    pub link: String,
    pub number: u8,
    pub keys: String,
    #[serde(flatten)]
    pub frames: BoardFrames,
    #[serde(flatten)]
    pub clock: BoardClock,
    /// Declined requests other than forces: gestures, pings.
    pub declined: u64,
    pub rearmed: u64,
    /// `armed`, or the reason why it renders no force.
    pub state: String,
    /// `true` if its keys are calibrated by a file, not by the board's own description.
    pub calibrated: bool,
    #[serde(flatten)]
    pub guarded: GuardedKeys,
    #[serde(flatten)]
    pub timing: SampleTiming,
    /// Number of restarts and the reason of the last one.
    pub restarts: u64,
    pub reset_reason: u8,
    /// Hottest temperature of its motors (°C).
    pub hottest_c: Option<f64>,
    pub counted: Option<Counted>,
}

/// Frames that a board and the host exchanged.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct BoardFrames {
    /// Received samples per second (1/s).
    pub samples_hz: f64,
    /// Forces that the link accepted per second (1/s).
    pub forces_hz: f64,
    pub frames: u64,
    /// Jumps of their numbers.
    pub gaps: u64,
    /// Frames that those jumps skipped.
    pub missing: u64,
    /// Frames that arrived again or after newer ones.
    pub repeated_or_overtaken: u64,
    pub refused: u64,
    /// Forces that the link rejected.
    pub unsent: u64,
}

/// A board's clock, estimated from its answers.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct BoardClock {
    pub round_trip_us: Option<RoundTrips>,
    pub drift_ppm: f64,
    pub clock_jumps: u64,
}

/// Keys whose samples or forces the guards changed.
#[derive(Clone, Debug, Serialize)]
pub struct GuardedKeys {
    /// Discarded readings at positions that no key can reach.
    pub implausible: u64,
    /// Keys that are no longer played, with the reason.
    pub muted: Vec<MutedKey>,
    /// Keys at half their force after they shook.
    pub softened: Vec<String>,
    /// Keys that never came to rest, so their motors were not proven.
    pub unproven: Vec<String>,
    /// Omitted readings that left the key's trend and returned to it.
    pub glitches: u64,
    /// Forces that rose less than the model asked.
    pub limited_rises: u64,
    /// Forces that continued from the last one after a gap instead of stepping.
    pub blended: u64,
}

/// Times of the taking and arrival of samples, at the end of a run.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct SampleTiming {
    /// Interval of samples by the board's clock: median and 90 % (us).
    pub sample_interval_us: Option<[u16; 2]>,
    /// Interval of bursts of samples (ms), if they arrived in bursts.
    pub bursts_ms: Option<f64>,
    /// Delay since arming (sample periods), if too large.
    pub late_periods: Option<f64>,
}

/// A key that is not played, since its sensor or motor cannot be trusted.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct MutedKey {
    pub key: String,
    pub reason: &'static str,
    pub remedy: &'static str,
}

/// Round trips of requests (us).
#[derive(Clone, Copy, Debug, Serialize)]
pub struct RoundTrips {
    pub p50: u32,
    pub p99: u32,
    pub max: u32,
}

/// A board's counters since it was switched on.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Counted {
    pub forces: u32,
    /// Whole frames that were invalid or meant for others.
    pub refused: u32,
    /// Receptions that were no frame.
    pub corrupt: u32,
    pub stale: u32,
    pub unanswered: u32,
    /// Age of the oldest samples behind a rendered force (ms).
    pub oldest_ms: f64,
    pub trips: u16,
}

/// Lost share of samples or forces that is reported, and makes a run a failure.
const LOSS_TO_REPORT: f64 = 0.05;
const LOSS_TO_FAIL: f64 = 0.25;

fn percent_words(share: f64, what: &str) -> String {
    format!("{:.0} % of its samples were {what}: see to its link", 1e2 * share)
}

impl BoardLine {
    /// Returns the line of `report` after `seconds` of run time.
    pub fn new(report: &BoardReport, seconds: f64) -> Self {
        let BoardReport { name, place, statistics, .. } = report;
        let (condition, (came, went)) = (&report.condition, report.exchanged);
        let first = place.first_key.number();
        let keys = ClaimedKeys { first, n: u8::try_from(place.n_keys).unwrap_or(u8::MAX) };
        let trips = condition.round_trips_us;
        let round_trip_us = trips.map(|[p50, p99, max]| RoundTrips { p50, p99, max });
        let rate = |count: u64| count as f64 / seconds.max(1e-9);
        let samples = statistics.samples;
        Self {
            link: name.line.clone(),
            number: name.number,
            keys: keys.to_string(),
            frames: BoardFrames {
                samples_hz: rate(came),
                forces_hz: rate(went),
                frames: samples.frames,
                gaps: samples.gaps,
                missing: samples.missing,
                repeated_or_overtaken: samples.repeated + samples.overtaken,
                refused: statistics.refused,
                unsent: statistics.unsent,
            },
            clock: BoardClock {
                round_trip_us,
                drift_ppm: condition.drift_ppm,
                clock_jumps: condition.jumps,
            },
            declined: condition.declined,
            rearmed: condition.armings.saturating_sub(1),
            state: stage_words(condition.state),
            calibrated: report.is_calibrated,
            guarded: GuardedKeys {
                implausible: statistics.implausible,
                muted: muted_keys(first, &statistics.keys.muted),
                softened: key_names(first, statistics.keys.softened),
                unproven: key_names(first, statistics.keys.unproven),
                glitches: statistics.keys.glitches,
                limited_rises: statistics.keys.limited,
                blended: statistics.keys.blended,
            },
            timing: SampleTiming {
                sample_interval_us: statistics.intervals.map(|it| [it.median_us, it.p90_us]),
                bursts_ms: condition.burst_us.map(|it| it as f64 * 1e-3),
                late_periods: condition.late,
            },
            restarts: condition.restarts,
            reset_reason: condition.reset_reason,
            hottest_c: condition.hottest.map(|it| 0.1 * f64::from(it)),
            counted: condition.counters.map(|it| Counted {
                forces: it.forces,
                refused: it.refused,
                corrupt: it.corrupt,
                stale: it.stale,
                unanswered: it.unanswered,
                oldest_ms: f64::from(it.oldest_us) * 1e-3,
                trips: it.trips,
            }),
        }
    }
}

pub(crate) fn stage_words(stage: ArmState) -> String {
    match stage {
        ArmState::Armed => "armed".into(),
        ArmState::Greeting => "silent".into(),
        ArmState::Checking
        | ArmState::Streaming
        | ArmState::Measuring
        | ArmState::Disarming
        | ArmState::Arming { .. }
        | ArmState::Confirming => "being brought up".into(),
        ArmState::Barred(bar) => bar_words(bar),
    }
}

fn bar_words(bar: ArmLockout) -> String {
    match bar {
        ArmLockout::Latched(reason) => reason_words(reason).into(),
        ArmLockout::Declined(asked, _) => format!("it declined {asked:?}"),
        ArmLockout::Exchanged => "another board is in its place".into(),
        ArmLockout::Clock(ppm) => format!("disarmed: {}", clock_words(ppm)),
        ArmLockout::NoSamples => {
            "left alone: it says that it is armed, and sends no samples".into()
        }
        ArmLockout::Unreadable => {
            "left alone: it says that it is armed, and its samples cannot be read".into()
        }
        ArmLockout::NotHomed(slots) => format!(
            "left alone: its encoders do not know where {} of its keys are",
            slots.count_ones()
        ),
        ArmLockout::Late(ms) => format!("left alone: {}", late_words(ms)),
        ArmLockout::Slow(SlowSamples { median_us, agreed_us }) => format!(
            "left alone: it confirmed a sample every {:.2} ms, and sends one every {:.2} ms",
            f64::from(agreed_us) * 1e-3,
            f64::from(median_us) * 1e-3
        ),
        ArmLockout::Bursts(us) => format!("left alone: {}", burst_words(f64::from(us))),
        ArmLockout::Restarting { times, reason } => {
            format!("left off: {}", restart_words(times, reason))
        }
        ArmLockout::StaysSafe => {
            "left alone: it says that it is armed, and renders no force".into()
        }
    }
}

pub(crate) fn late_periods_words(periods: f64) -> String {
    format!(
        "its samples come {periods:.1} periods later than when it was armed, so it gets less force: \
         see what holds its link up"
    )
}

pub(crate) fn misplaced_words(keys: &str) -> String {
    format!(
        "{keys} stands still at neither its rest nor its bottom: unless a hand holds it, counts \
         were lost; calibrate it"
    )
}

pub(crate) fn softened_words(keys: &str) -> String {
    format!("half of the force for {keys}, since it went to and fro: take a scene that is softer")
}

pub(crate) fn unproven_words(keys: &str) -> String {
    format!(
        "1 N at most for {keys} until it has come to rest and its motor is proven: a hand holds \
         it, or its motor pushes by itself (then cut its supply)"
    )
}

pub(crate) fn key_names(first_key: u8, slots: u16) -> Vec<String> {
    let keys = (first_key..).map_while(KeyIndex::new).take(MOST_KEYS).enumerate();
    let keys = keys.filter(|(slot, _)| slots >> slot & 1 == 1);
    keys.map(|(_, key)| key.to_string()).collect()
}

pub(crate) fn muted_keys(first_key: u8, muted: &[Option<KeyFault>; MOST_KEYS]) -> Vec<MutedKey> {
    let keys = (first_key..).map_while(KeyIndex::new).zip(muted);
    let key = |(key, muted): (KeyIndex, &Option<KeyFault>)| {
        let fault = (*muted)?;
        Some(MutedKey { key: key.to_string(), reason: fault.words(), remedy: fault.remedy() })
    };
    keys.filter_map(key).collect()
}

impl fmt::Display for MutedKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { key, reason, remedy } = self;
        write!(f, "{key} is muted: {reason}; {remedy}, then restart its board")
    }
}

pub(super) fn fmt_table(boards: &[BoardLine], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if boards.is_empty() {
        return Ok(());
    }
    writeln!(
        f,
        "              board                keys        up/s down/s  gaps  lost  p50us  p99us    ppm oldest stale trips"
    )?;
    boards.iter().try_for_each(|board| board.fmt_row(f))
}

impl BoardLine {
    /// Returns a sentence on each fault at the end of the run.
    pub fn troubles(&self) -> Vec<String> {
        let name = format!("board {} on {}", self.number, self.link);
        let state = (self.state != "armed").then(|| self.state.clone());
        let never = self.was_never_heard().then(|| "it sent no sample in the run".to_owned());
        let bursts = self.timing.bursts_ms.map(|ms| burst_words(1e3 * ms));
        let restarts = (0 < self.restarts).then(|| {
            restart_words(u8::try_from(self.restarts).unwrap_or(u8::MAX), self.reset_reason)
        });
        let list = |keys: &[String], words: fn(&str) -> String| {
            (!keys.is_empty()).then(|| words(&keys.join(", ")))
        };
        let softened = list(&self.guarded.softened, softened_words);
        let unproven =
            list(&self.guarded.unproven, unproven_words).filter(|_| self.state == "armed");
        let late = self.timing.late_periods.map(late_periods_words);
        let lost = LOSS_TO_REPORT < self.lost();
        let lost = lost.then(|| percent_words(self.lost(), "lost on the way"));
        let unanswered = LOSS_TO_REPORT < self.unanswered();
        let unanswered = unanswered.then(|| percent_words(self.unanswered(), "never answered"));
        let link = [never, self.untaken(), bursts, late, lost, unanswered];
        let board = [state, restarts, softened, unproven];
        let whole = board.into_iter().chain(link);
        // Without accepted forces, no motor could move its key.
        let muted = self.guarded.muted.iter().filter(|_| self.untaken().is_none());
        let muted = muted.map(ToString::to_string);
        let all = whole.flatten().chain(muted);
        all.map(|it| format!("{name}: {it}")).collect()
    }

    fn lost(&self) -> f64 {
        let BoardFrames { frames, missing, .. } = self.frames;
        missing as f64 / (frames + missing).max(1) as f64
    }

    /// Returns the share of its samples without answer, except those before the first force.
    fn unanswered(&self) -> f64 {
        /// Samples that a board sends before the first force, and forces that make a share.
        const BEFORE: u32 = 300;
        const ENOUGH: u32 = 2_000;
        let counted = self.counted.filter(|it| ENOUGH <= it.forces);
        counted.map_or(0.0, |it| {
            let unanswered = f64::from(it.unanswered.saturating_sub(BEFORE));
            unanswered / (unanswered + f64::from(it.forces))
        })
    }

    fn untaken(&self) -> Option<String> {
        /// Rejected forces that are no accident of a start.
        const MANY: u64 = 200;
        let Counted { forces, refused, corrupt, stale, unanswered, .. } = self.counted?;
        let in_vain = [refused, corrupt, stale, unanswered].map(u64::from).iter().sum::<u64>();
        if 0 < forces || in_vain < MANY {
            return None;
        }
        Some(format!(
            "it rendered no force: {refused} frames were refused, {stale} were stale, {corrupt} \
             pieces were no frames"
        ))
    }

    /// Returns `true` if the board or one of its keys was not played as intended.
    pub fn has_failed(&self) -> bool {
        self.state != "armed"
            || self.was_never_heard()
            || self.untaken().is_some()
            || !self.guarded.muted.is_empty()
            || !self.guarded.softened.is_empty()
            || !self.guarded.unproven.is_empty()
            || self.timing.bursts_ms.is_some()
            || self.timing.late_periods.is_some()
            || LOSS_TO_FAIL < self.lost().max(self.unanswered())
    }

    fn was_never_heard(&self) -> bool {
        self.frames.samples_hz <= 0.0
    }

    fn fmt_row(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = format!("{} {}", self.link, self.number);
        let trip = |value: fn(&RoundTrips) -> u32| {
            self.clock.round_trip_us.as_ref().map_or_else(|| "-".into(), |it| value(it).to_string())
        };
        let counted =
            |value: fn(&Counted) -> String| self.counted.as_ref().map_or_else(|| "-".into(), value);
        writeln!(
            f,
            "              {name:20} {:9} {:6.0} {:6.0} {:5} {:5} {:>6} {:>6} {:6.0} {:>6} {:>5} {:>5}{}",
            self.keys,
            self.frames.samples_hz,
            self.frames.forces_hz,
            self.frames.gaps,
            self.frames.missing,
            trip(|it| it.p50),
            trip(|it| it.p99),
            self.clock.drift_ppm,
            counted(|it| format!("{:.1}", it.oldest_ms)),
            counted(|it| it.stale.to_string()),
            counted(|it| it.trips.to_string()),
            if self.state == "armed" { String::new() } else { format!("  {}", self.state) },
        )?;
        if !self.calibrated {
            writeln!(f, "                {name} has no calibration file")?;
        }
        self.guarded
            .muted
            .iter()
            .try_for_each(|muted| writeln!(f, "                {name}: {muted}"))
    }
}
