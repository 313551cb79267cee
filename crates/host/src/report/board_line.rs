//! What a report says of one board.

use std::fmt;

use hardware::keybed::BoardReport;
use hardware::refusal::{KeyRange, reason_words};
use hardware::rt::steward::{Bar, Stage};
use serde::Serialize;

/// One board of a run.
#[derive(Clone, Debug, Serialize)]
pub struct BoardLine {
    /// The link it is on.
    pub link: String,
    /// Its number there.
    pub number: u8,
    /// The keys that it carries.
    pub keys: String,
    /// Samples that came, a second [1/s].
    pub samples_hz: f64,
    /// Forces that the link took, a second [1/s].
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
    /// How much faster than the host's its clock runs [1e-6].
    pub drift_ppm: f64,
    /// Times that its clock jumped.
    pub clock_jumps: u64,
    /// Requests beside the forces that it declined: gestures, pings.
    pub declined: u64,
    /// Times that it was armed again.
    pub rearmed: u64,
    /// Whether it renders forces, or why not.
    pub state: String,
    /// What the board itself has counted, a second before the end.
    pub counted: Option<Counted>,
}

/// Round trips of requests [us].
#[derive(Clone, Copy, Debug, Serialize)]
pub struct RoundTrips {
    /// Half are shorter.
    pub p50: u32,
    /// 99 of a hundred are shorter.
    pub p99: u32,
    /// The longest.
    pub max: u32,
}

/// What a board has counted since it was switched on.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Counted {
    /// Forces that it rendered.
    pub forces: u32,
    /// What came and was no frame.
    pub corrupt: u32,
    /// Forces that were stale, and not rendered.
    pub stale: u32,
    /// Oldest samples that forces which it rendered answered [ms].
    pub oldest_ms: f64,
    /// Times that forces expired.
    pub trips: u16,
}

impl BoardLine {
    /// Of `report`, after `seconds`.
    pub fn new(report: &BoardReport, seconds: f64) -> Self {
        let BoardReport { name, place, statistics, exchanged: (came, went), condition } = report;
        let keys = KeyRange {
            first: place.first_key.number(),
            n: u8::try_from(place.n_keys).unwrap_or(u8::MAX),
        };
        let rate = |count: u64| count as f64 / seconds.max(1e-9);
        let samples = statistics.samples;
        Self {
            link: name.line.clone(),
            number: name.number,
            keys: keys.to_string(),
            samples_hz: rate(*came),
            forces_hz: rate(*went),
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
            state: stage_words(condition.stage),
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

/// How far a board has been brought up, in words.
pub(crate) fn stage_words(stage: Stage) -> String {
    match stage {
        Stage::Armed => "armed".into(),
        Stage::Greeting => "silent".into(),
        Stage::Streaming | Stage::Disarming | Stage::Arming { .. } => "being brought up".into(),
        Stage::Barred(Bar::Latched(reason)) => reason_words(reason).into(),
        Stage::Barred(Bar::Declined(asked, _)) => format!("it declined {asked:?}"),
        Stage::Barred(Bar::Exchanged) => "another board is in its place".into(),
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
        )
    }
}
