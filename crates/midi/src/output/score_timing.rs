//! Bars and tempo of a written file.

/// Longest tick of a written file (s), if its division allows it.
const MAX_TICK: f64 = 50e-6;

/// Largest division that the header of a file can express.
const MAX_DIVISION: u16 = 0x7FFF;

/// Length of a quarter note before the first tempo: 500 000 us, 120 a minute.
const QUARTER: [u8; 3] = [0x07, 0xA1, 0x20];

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

/// Division, tempo map, signatures and names of a performance file, for a recording in its bars.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ScoreTiming {
    /// Ticks per quarter note of the piece.
    division: u16,
    /// Ticks of the piece by which it begins later in the recording.
    lead_in: u64,
    /// In order of ticks, with a tempo at the start.
    marks: Vec<ScoreMark>,
}

impl Default for ScoreTiming {
    /// Returns 120 quarter notes a minute of 10 080 ticks.
    fn default() -> Self {
        Self::new(10_080, Vec::new())
    }
}

impl ScoreTiming {
    /// Returns the timing of a piece with `division` ticks per quarter note, above 0.
    pub fn new(division: u16, mut marks: Vec<ScoreMark>) -> Self {
        if !marks.iter().any(|mark| (mark.tick, mark.kind) == (0, meta::TEMPO)) {
            marks.push(ScoreMark { tick: 0, kind: meta::TEMPO, data: QUARTER.to_vec() });
        }
        // In order of the file: of several tempi at one tick the last one holds.
        marks.sort_by_key(|mark| (mark.tick, mark.kind));
        marks.dedup();
        Self { division: division.clamp(1, MAX_DIVISION), lead_in: 0, marks }
    }

    /// Begins the piece later by the fewest bars that take `least` (s), as at its start; returns
    /// their length (s). A bar of more than 15 s, or of fractional ticks, is not waited for.
    #[must_use]
    pub fn begin_after(&mut self, least: f64) -> f64 {
        let tick =
            self.first(meta::TEMPO).and_then(quarter).unwrap_or(0.5) / f64::from(self.division);
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

    /// Returns the ticks of the first bar; `None` if they are no whole number.
    fn first_bar(&self) -> Option<u64> {
        let Some(&[beats, power, ..]) = self.first(meta::TIME_SIGNATURE).or(Some(&[4, 2])) else {
            return None;
        };
        let ticks = 4 * u64::from(self.division) * u64::from(beats);
        let parts = 1_u64.checked_shl(power.into())?;
        (0 < ticks && ticks.is_multiple_of(parts)).then_some(ticks / parts)
    }

    /// Returns the map of the recording, with ticks of at most 50 us where possible.
    pub(super) fn tempo_map(&self) -> TempoMap {
        let quarters = self.marks.iter().filter(|mark| mark.kind == meta::TEMPO);
        let quarters = quarters.filter_map(|mark| Some((mark, quarter(&mark.data)?)));
        let slowest = quarters.clone().map(|(_, length)| length).fold(0.0, f64::max);
        let possible = MAX_DIVISION / self.division;
        let is_enough = |factor: &u16| slowest <= f64::from(self.division * factor) * MAX_TICK;
        let factor = (1..possible).find(is_enough).unwrap_or(possible);
        let division = self.division * factor;
        let mut segments: Vec<(u64, f64, f64)> = Vec::new();
        for (mark, length) in quarters {
            let tick = self.written_tick(mark).saturating_mul(factor.into());
            let at = segments.last().map_or(0.0, |(from, at, it)| at + (tick - from) as f64 * it);
            segments.push((tick, at, length / f64::from(division)));
        }
        TempoMap { division, factor, segments }
    }

    /// Returns the tick of `mark` in a recording with the division of the piece: marks at the start
    /// of the piece are at the start of the recording, except for markers.
    fn written_tick(&self, mark: &ScoreMark) -> u64 {
        let stays = mark.tick == 0 && !matches!(mark.kind, meta::MARKER | meta::CUE);
        if stays { 0 } else { mark.tick.saturating_add(self.lead_in) }
    }

    /// Returns the marks with their ticks in the recording.
    pub(super) fn written_marks(&self, map: &TempoMap) -> impl Iterator<Item = (u64, &ScoreMark)> {
        let factor = map.factor.into();
        self.marks.iter().map(move |it| (self.written_tick(it).saturating_mul(factor), it))
    }
}

/// Returns the length of a quarter note (s) of a tempo event; `None` for zero, which stops time.
pub fn quarter(data: &[u8]) -> Option<f64> {
    let [high, middle, low] = *data.first_chunk::<3>()?;
    let us = u32::from_be_bytes([0, high, middle, low]);
    (0 < us).then(|| f64::from(us) * 1e-6)
}

/// Ticks of a recording as a function of time.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct TempoMap {
    pub(super) division: u16,
    /// Ticks of the recording in one of the piece.
    factor: u16,
    /// First tick, its time (s), and the length of a tick from there on (s).
    segments: Vec<(u64, f64, f64)>,
}

impl TempoMap {
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
