//! The part of a report about one board.

use std::fmt;

use firmware_protocol::key::{KeyIndex, MOST_KEYS};
use hardware::identity::ClaimedKeys;
use hardware::keybed::BoardReport;
use hardware::refusal::{clock_words, late_words, reason_words};
use hardware::rt::board_supervisor::{ArmLockout, ArmState};
use hardware::rt::plausible::Implausible;
use serde::Serialize;

/// One board of a run.
#[derive(Clone, Debug, Serialize)]
pub struct BoardLine {
    /// The link it is on.
    pub link: String,
    pub number: u8,
    /// The keys that it carries.
    pub keys: String,
    /// Samples that came, a second (1/s).
    pub samples_hz: f64,
    /// Forces that the link took, a second (1/s).
    pub forces_hz: f64,
    /// Frames of samples that came.
    pub frames: u64,
    /// Times that their numbers jumped.
    pub gaps: u64,
    /// Frames that those jumps passed over.
    pub missing: u64,
    /// Frames that came again or after newer ones.
    pub repeated_or_overtaken: u64,
    /// Frames that were refused.
    pub refused: u64,
    /// Forces that the link did not take.
    pub unsent: u64,
    /// Round trips, if there were any.
    pub round_trip_us: Option<RoundTrips>,
    /// The drift of its clock against the host's (1e-6).
    pub drift_ppm: f64,
    /// Times that its clock jumped.
    pub clock_jumps: u64,
    /// Requests beside the forces that it declined: gestures, pings.
    pub declined: u64,
    /// Times that it was armed again.
    pub rearmed: u64,
    /// Whether it renders forces, or why not.
    pub state: String,
    /// Whether its keys are calibrated by its file, and not by its own description.
    pub calibrated: bool,
    /// Readings of keys that were not used, since no key can be there.
    pub implausible: u64,
    /// Keys that are not played any more since their readings cannot be trusted.
    pub muted: Vec<MutedKey>,
    /// The board's own counters, a second before the end.
    pub counted: Option<Counted>,
}

/// A key whose readings cannot be trusted.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct MutedKey {
    /// Its name, as C4.
    pub key: String,
    /// The fault of its readings.
    pub reason: &'static str,
}

/// Round trips of requests (us).
#[derive(Clone, Copy, Debug, Serialize)]
pub struct RoundTrips {
    pub p50: u32,
    /// 99 of a hundred are shorter.
    pub p99: u32,
    pub max: u32,
}

/// A board's counters since it was switched on.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Counted {
    /// Forces that it rendered.
    pub forces: u32,
    /// Receptions that were no frame.
    pub corrupt: u32,
    /// Forces that were stale, and not rendered.
    pub stale: u32,
    /// Oldest samples that forces which it rendered answered (ms).
    pub oldest_ms: f64,
    /// Times that forces expired.
    pub trips: u16,
}

impl BoardLine {
    /// Returns the line of `report`, after `seconds`.
    pub fn new(report: &BoardReport, seconds: f64) -> Self {
        let BoardReport { name, place, statistics, .. } = report;
        let (condition, (came, went)) = (&report.condition, report.exchanged);
        let keys = ClaimedKeys {
            first: place.first_key.number(),
            n: u8::try_from(place.n_keys).unwrap_or(u8::MAX),
        };
        let rate = |count: u64| count as f64 / seconds.max(1e-9);
        let samples = statistics.samples;
        Self {
            link: name.line.clone(),
            number: name.number,
            keys: keys.to_string(),
            samples_hz: rate(came),
            forces_hz: rate(went),
            frames: samples.frames,
            gaps: samples.gaps,
            missing: samples.missing,
            repeated_or_overtaken: samples.repeated + samples.overtaken,
            refused: statistics.refused,
            unsent: statistics.unsent,
            round_trip_us: condition.round_trips_us.map(|[p50, p99, max]| RoundTrips {
                p50,
                p99,
                max,
            }),
            drift_ppm: condition.drift_ppm,
            clock_jumps: condition.jumps,
            declined: condition.declined,
            rearmed: condition.armings.saturating_sub(1),
            state: stage_words(condition.state),
            calibrated: report.is_calibrated,
            implausible: statistics.implausible,
            muted: muted_keys(place.first_key.number(), &statistics.muted),
            counted: condition.counters.map(|it| Counted {
                forces: it.forces,
                corrupt: it.corrupt,
                stale: it.stale,
                oldest_ms: f64::from(it.oldest_us) * 1e-3,
                trips: it.trips,
            }),
        }
    }
}

/// Returns how far a board has been brought up, in words.
pub(crate) fn stage_words(stage: ArmState) -> String {
    match stage {
        ArmState::Armed => "armed".into(),
        ArmState::Greeting => "silent".into(),
        ArmState::Checking
        | ArmState::Streaming
        | ArmState::Disarming
        | ArmState::Arming { .. }
        | ArmState::Confirming => "being brought up".into(),
        ArmState::Barred(bar) => bar_words(bar),
    }
}

/// Returns why a board may not be armed, in words.
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
        ArmLockout::StaysSafe => {
            "left alone: it says that it is armed, and renders no force".into()
        }
    }
}

/// Returns the keys of a board from `first_key` on that were muted.
pub(crate) fn muted_keys(first_key: u8, muted: &[Option<Implausible>; MOST_KEYS]) -> Vec<MutedKey> {
    let keys = (first_key..).map_while(KeyIndex::new).zip(muted);
    let key = |(key, muted): (KeyIndex, &Option<Implausible>)| {
        let reason = match (*muted)? {
            Implausible::Beyond => "its readings lie far beyond its rest and its bottom",
            Implausible::Jumping => "its readings jump farther than a key can move",
            Implausible::FalseSpeed => "the speeds that its board says are not those of the key",
            Implausible::Noisy => "its readings go to and fro faster than a key can",
        };
        Some(MutedKey { key: key.to_string(), reason })
    };
    keys.filter_map(key).collect()
}

impl fmt::Display for MutedKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { key, reason } = self;
        write!(f, "{key} is muted: {reason}; see to its sensor, then start its board anew")
    }
}

/// Prints the table of all boards, if there are any.
pub(super) fn fmt_table(boards: &[BoardLine], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if boards.is_empty() {
        return Ok(());
    }
    writeln!(
        f,
        "              {:20} {:9} {:>6} {:>6} {:>5} {:>5} {:>6} {:>6} {:>6} {:>6} {:>5} {:>5}",
        "board",
        "keys",
        "up/s",
        "down/s",
        "gaps",
        "lost",
        "p50us",
        "p99us",
        "ppm",
        "oldest",
        "stale",
        "trips",
    )?;
    boards.iter().try_for_each(|board| board.fmt_row(f))
}

impl BoardLine {
    /// Returns what is wrong with it in the end, a sentence on each.
    pub fn troubles(&self) -> Vec<String> {
        let name = format!("board {} on {}", self.number, self.link);
        let state = (self.state != "armed").then(|| format!("{name}: {}", self.state));
        let never = self.was_never_heard().then(|| format!("{name} sent no sample in the run"));
        let muted = self.muted.iter().map(|it| format!("{name}: {it}"));
        state.into_iter().chain(never).chain(muted).collect()
    }

    /// Returns whether no sample of it came in the run.
    pub fn was_never_heard(&self) -> bool {
        self.samples_hz <= 0.0
    }

    fn fmt_row(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = format!("{} {}", self.link, self.number);
        let trip = |value: fn(&RoundTrips) -> u32| {
            self.round_trip_us.as_ref().map_or_else(|| "-".into(), |it| value(it).to_string())
        };
        let counted =
            |value: fn(&Counted) -> String| self.counted.as_ref().map_or_else(|| "-".into(), value);
        writeln!(
            f,
            "              {name:20} {:9} {:6.0} {:6.0} {:5} {:5} {:>6} {:>6} {:6.0} {:>6} {:>5} {:>5}{}",
            self.keys,
            self.samples_hz,
            self.forces_hz,
            self.gaps,
            self.missing,
            trip(|it| it.p50),
            trip(|it| it.p99),
            self.drift_ppm,
            counted(|it| format!("{:.1}", it.oldest_ms)),
            counted(|it| it.stale.to_string()),
            counted(|it| it.trips.to_string()),
            if self.state == "armed" { String::new() } else { format!("  {}", self.state) },
        )?;
        if !self.calibrated {
            writeln!(f, "                {name} has no calibration file")?;
        }
        self.muted.iter().try_for_each(|muted| writeln!(f, "                {name}: {muted}"))
    }
}
