//! Bars and tempo of a written file.

/// Longest tick of a written file (s), if its division allows it.
const MAX_TICK: f64 = 50e-6;

/// Largest division that the header of a file can express.
const MAX_DIVISION: u16 = 0x7FFF;

/// Length of a quarter note before the first tempo (µs): 120 a minute.
const QUARTER_US: u32 = 500_000;

/// Longest bar that precedes a piece as a whole (s).
const MAX_BAR: f64 = 15.0;

/// Numbers of meta events.
pub mod meta {
    #![expect(missing_docs, reason = "the names say it")]
    pub const TEXT: u8 = 0x01;
    pub const NAME: u8 = 0x03;
    pub const MARKER: u8 = 0x06;
    pub const CUE: u8 = 0x07;
    pub const END: u8 = 0x2F;
    pub const TEMPO: u8 = 0x51;
    pub const TIME_SIGNATURE: u8 = 0x58;
    pub const KEY_SIGNATURE: u8 = 0x59;
}

/// Meta event of a performance file that a recording of the performance repeats.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct ScoreMark {
    /// Ticks since the start of the piece.
    pub tick: u64,
    /// Number of the meta event: one of [`meta`].
    pub kind: u8,
    pub data: Vec<u8>,
}

/// Division, tempo map, signatures and names of a performance file, for a recording whose bars meet
/// those of the piece.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ScoreTiming {
    /// Ticks per quarter note of the piece.
    division: u16,
    /// Ticks of the piece by which it begins later in the recording.
    lead_in: u64,
    /// In order of ticks.
    marks: Vec<ScoreMark>,
}

impl Default for ScoreTiming {
    /// Returns 120 quarter notes a minute of 10 080 ticks.
    fn default() -> Self {
        Self { division: 10_080, lead_in: 0, marks: Vec::new() }
    }
}

impl ScoreTiming {
    /// Returns the timing of a piece with `division` ticks per quarter note, above 0.
    pub fn new(division: u16, mut marks: Vec<ScoreMark>) -> Self {
        // In order of the file: of several tempi at one tick the last one holds.
        marks.sort_by_key(|mark| (mark.tick, mark.kind));
        marks.dedup();
        Self { division: division.clamp(1, MAX_DIVISION), lead_in: 0, marks }
    }

    /// Begins the piece later by the least number of whole bars that takes `least` (s), with the
    /// tempo and time signature of its start; returns their length (s). A bar that is longer than
    /// 15 s, or no whole number of ticks, is not waited for.
    #[must_use]
    pub fn begin_after(&mut self, least: f64) -> f64 {
        let tick = f64::from(self.first_tempo()) * 1e-6 / f64::from(self.division);
        let bar = self.first_bar().filter(|ticks| *ticks as f64 * tick <= MAX_BAR).unwrap_or(1);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a tick has 1 us over 32767 at least"
        )]
        let bars = (least / (bar as f64 * tick) - 1e-9).ceil() as u64;
        self.lead_in = bars.saturating_mul(bar);
        self.lead_in as f64 * tick
    }

    fn first(&self, kind: u8) -> Option<&[u8]> {
        let at_start = self.marks.iter().take_while(|mark| mark.tick == 0);
        at_start.filter(|mark| mark.kind == kind).last().map(|mark| mark.data.as_slice())
    }

    fn first_tempo(&self) -> u32 {
        self.first(meta::TEMPO).and_then(tempo).unwrap_or(QUARTER_US)
    }

    /// Returns the ticks of the first bar; `None` if they are no whole number.
    fn first_bar(&self) -> Option<u64> {
        let (beats, power) = match self.first(meta::TIME_SIGNATURE) {
            Some(&[beats, power, ..]) => (beats, power),
            Some(_) | None => (4, 2),
        };
        let ticks = 4 * u64::from(self.division) * u64::from(beats);
        let parts = 1_u64.checked_shl(power.into())?;
        (0 < ticks && ticks.is_multiple_of(parts)).then_some(ticks / parts)
    }

    /// Returns the map of the recording, with ticks of at most 50 µs where possible.
    pub(super) fn tempo_map(&self) -> TempoMap {
        let tempi = self.marks.iter().filter(|mark| mark.kind == meta::TEMPO);
        let changes = tempi.filter_map(|mark| Some((mark.tick, tempo(&mark.data)?)));
        let changes: Vec<_> = changes.collect();
        let first = self.first_tempo();
        let slowest = changes.iter().map(|(_, us)| *us).chain([first]).max().unwrap_or(first);
        let wanted = f64::from(slowest) * 1e-6 / (f64::from(self.division) * MAX_TICK);
        let possible = MAX_DIVISION / self.division;
        let is_enough = |factor: &u16| wanted <= f64::from(*factor);
        let factor = (1..possible).find(is_enough).unwrap_or(possible);
        let mut map = TempoMap {
            division: self.division * factor,
            factor: factor.into(),
            lead_in: self.lead_in,
            first,
            segments: Vec::new(),
        };
        map.change(0, first);
        for (tick, us) in changes.into_iter().filter(|(tick, _)| 0 < *tick) {
            map.change(map.written(tick), us);
        }
        map
    }

    /// Returns the marks with their ticks in the recording: those at the start of the piece are at
    /// the start of the recording, except for markers.
    pub(super) fn written_marks(&self, map: &TempoMap) -> impl Iterator<Item = (u64, u8, &[u8])> {
        self.marks.iter().map(|mark| {
            let stays = mark.tick == 0 && !matches!(mark.kind, meta::MARKER | meta::CUE);
            (if stays { 0 } else { map.written(mark.tick) }, mark.kind, mark.data.as_slice())
        })
    }
}

/// Returns the length of a quarter note (µs) of a tempo event; `None` for zero, after which all
/// events would be at one time.
pub fn tempo(data: &[u8]) -> Option<u32> {
    let [high, middle, low] = *data.first_chunk::<3>()?;
    Some(u32::from_be_bytes([0, high, middle, low])).filter(|us| 0 < *us)
}

/// Ticks of a recording as a function of time.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct TempoMap {
    pub(super) division: u16,
    /// Ticks of the recording in one of the piece.
    factor: u64,
    lead_in: u64,
    /// Length of the first quarter notes (µs).
    pub(super) first: u32,
    /// First tick, its time (s), and the length of a tick from there on (s).
    segments: Vec<(u64, f64, f64)>,
}

impl TempoMap {
    fn written(&self, tick: u64) -> u64 {
        tick.saturating_add(self.lead_in).saturating_mul(self.factor)
    }

    fn change(&mut self, tick: u64, us: u32) {
        let at = match self.segments.last() {
            Some(&(from, at, length)) => at + (tick - from) as f64 * length,
            None => 0.0,
        };
        self.segments.push((tick, at, f64::from(us) * 1e-6 / f64::from(self.division)));
    }

    /// Converts `at` (s) to ticks; a time before the start becomes the start.
    pub(super) fn ticks(&self, at: f64) -> u64 {
        let index = self.segments.partition_point(|(_, from, _)| *from <= at).saturating_sub(1);
        let Some((tick, from, length)) = self.segments.get(index) else { return 0 };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "negative times become 0, and no host runs for 10 million years"
        )]
        let more = ((at - from) / length).round() as u64;
        tick + more
    }
}
