//! One key, tick by tick: columns with a cap on memory.

use std::ops::Range;

use telemetry::KeyBlock;

use super::column::{BLOCK, Column};
use crate::number;

/// Rows over which speed is the difference of positions.
const SPEED_ROWS: usize = 4;

/// Columns that every key has, before its model's signals.
pub const OWN: [(&str, &str); 4] =
    [("position", "m"), ("speed", "m/s"), ("force", "N"), ("sent", "N")];

/// Ticks in which the model stayed in one mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Epoch {
    pub tick: u64,
    pub mode: u8,
}

/// Unknown ticks between two rows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Gap {
    /// Tick of the last row before.
    pub last: u64,
    /// Tick of the first row after.
    pub next: u64,
}

/// The rows of one key.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    ticks: Vec<u64>,
    columns: Vec<Column>,
    modes: Vec<u8>,
    epochs: Vec<Epoch>,
    gaps: Vec<Gap>,
    rests: bool,
    revision: u32,
}

impl Trace {
    /// Appends a block's rows and fills the ticks in which the key rested.
    ///
    /// Ticks after a row that is not asleep, and ticks before a row with flag 8, are unknown.
    /// Rows older than the newest are ignored. Columns are read up to the shortest.
    pub(super) fn append(&mut self, block: &KeyBlock, period: f64) {
        let rows = rows(block);
        let width = block.signals.len().checked_div(block.after.len()).unwrap_or(0);
        if self.columns.len() != OWN.len() + width {
            *self = Self { columns: vec![Column::default(); OWN.len() + width], ..Self::default() };
        }
        for row in 0..rows {
            let tick = block.tick.saturating_add(block.after[row].into());
            let is_next = self.ticks.last().is_none_or(|last| *last < tick);
            if is_next && tick <= super::LAST_TICK {
                let flags = block.flags.get(row).copied().unwrap_or(KeyBlock::ASLEEP);
                self.fill(tick, flags, period);
                self.push(block, row, tick, period);
                self.rests = flags & KeyBlock::STATE == KeyBlock::ASLEEP;
            }
        }
    }

    /// Repeats the last row just before `tick`, with `flags`, if ticks are missing, or notes a gap.
    fn fill(&mut self, tick: u64, flags: u8, period: f64) {
        let Some(row) = self.ticks.len().checked_sub(1) else { return };
        let last = self.ticks[row];
        if tick <= last.saturating_add(1) {
            return;
        }
        if flags & KeyBlock::MISSING != 0 || !self.rests {
            self.gaps.push(Gap { last, next: tick });
        } else {
            let values: Vec<f32> = self.columns.iter().map(|column| column.values()[row]).collect();
            let mode = self.modes[row];
            self.enter(tick - 1, &values, mode, period);
        }
    }

    fn push(&mut self, block: &KeyBlock, row: usize, tick: u64, period: f64) {
        let width = self.columns.len() - OWN.len();
        let position = number::f32(block.position[row]);
        let forces = [number::f32(block.force[row]), number::f32(block.sent[row])];
        let mut values = vec![position, 0.0, forces[0], forces[1]];
        values.extend_from_slice(&block.signals[row * width..(row + 1) * width]);
        self.revision = block.revision.get(row).copied().unwrap_or(self.revision);
        self.enter(tick, &values, block.mode[row], period);
    }

    fn enter(&mut self, tick: u64, values: &[f32], mode: u8, period: f64) {
        self.ticks.push(tick);
        self.modes.push(mode);
        if self.epochs.last().is_none_or(|epoch| epoch.mode != mode) {
            self.epochs.push(Epoch { tick, mode });
        }
        let speed = self.speed(values[0], tick, period);
        for (i, column) in self.columns.iter_mut().enumerate() {
            column.push(if i == 1 { speed } else { values[i] });
        }
    }

    /// Returns the mean speed over the last [`SPEED_ROWS`] rows (m/s).
    fn speed(&self, position: f32, tick: u64, period: f64) -> f32 {
        // The tick of this row is in already, its position is not.
        let Some(row) = self.columns[0].values().len().checked_sub(SPEED_ROWS) else { return 0.0 };
        let before = self.columns[0].values()[row];
        let ticks = tick.saturating_sub(self.ticks[row]);
        if ticks == 0 {
            return 0.0;
        }
        number::f32(f64::from(position - before) / (ticks as f64 * period))
    }

    pub(super) fn cap(&mut self, bytes: usize) {
        let most = bytes / self.row_bytes();
        // A quarter at a time, so that a row is moved four times at most.
        if self.ticks.len() <= most + most / 4 {
            return;
        }
        let blocks = (self.ticks.len() - most) / BLOCK;
        let rows = blocks * BLOCK;
        self.ticks.drain(..rows);
        self.modes.drain(..rows);
        self.columns.iter_mut().for_each(|column| column.forget(blocks));
        let oldest = self.ticks.first().copied().unwrap_or(0);
        let gone = self.epochs.partition_point(|epoch| epoch.tick <= oldest).saturating_sub(1);
        self.epochs.drain(..gone);
        let gone = self.gaps.partition_point(|gap| gap.next <= oldest);
        self.gaps.drain(..gone);
    }

    fn row_bytes(&self) -> usize {
        8 + 1 + 4 * self.columns.len().max(1)
    }

    /// Returns the approximate size of the rows (B).
    pub fn bytes(&self) -> usize {
        self.ticks.len() * self.row_bytes()
    }

    pub fn ticks(&self) -> &[u64] {
        &self.ticks
    }

    /// Returns the values of a column: those of [`OWN`], then the model's signals.
    pub fn values(&self, column: usize) -> &[f32] {
        self.columns.get(column).map_or(&[], Column::values)
    }

    pub fn width(&self) -> usize {
        self.columns.len()
    }

    pub fn modes(&self) -> &[u8] {
        &self.modes
    }

    /// Returns the epochs, oldest first; each lasts until the next.
    pub fn epochs(&self) -> &[Epoch] {
        &self.epochs
    }

    /// Returns the gaps between two ticks, oldest first.
    pub fn gaps(&self, from: u64, to: u64) -> &[Gap] {
        let first = self.gaps.partition_point(|gap| gap.next <= from);
        let last = self.gaps.partition_point(|gap| gap.last < to);
        &self.gaps[first..last.max(first)]
    }

    /// Returns `true` if the newest row holds until the next one.
    pub fn rests(&self) -> bool {
        self.rests
    }

    pub fn revision(&self) -> u32 {
        self.revision
    }

    /// Returns the row that holds at `tick`: the last one up to it.
    pub fn row_at(&self, tick: u64) -> Option<usize> {
        self.ticks.partition_point(|row| *row <= tick).checked_sub(1)
    }

    /// Returns the value of `column` at `tick`, as of the last row up to it; `None` in a gap.
    pub fn value_at(&self, column: usize, tick: u64) -> Option<f32> {
        let row = self.row_at(tick)?;
        let is_known = self.gaps(tick, tick).is_empty();
        self.values(column).get(row).copied().filter(|_| is_known)
    }

    /// Returns the curve of `column` between two ticks as segments of points `[tick, value]`, with
    /// a break at each gap and each value that is not finite.
    ///
    /// Each of `buckets` has about eight points at most, among them its smallest and largest value.
    /// Only segments less than a bucket apart are joined, if there are more of them than buckets.
    pub fn segments(
        &self,
        column: usize,
        from: u64,
        to: u64,
        buckets: usize,
    ) -> Vec<Vec<[f64; 2]>> {
        let first = self.row_at(from).unwrap_or(0);
        let last = (self.ticks.partition_point(|row| *row <= to) + 1).min(self.ticks.len());
        let Some(values) = self.columns.get(column) else { return Vec::new() };
        if last <= first {
            return Vec::new();
        }
        let most = u64::try_from(buckets.max(1)).unwrap_or(u64::MAX);
        // Buckets begin at the same ticks however far the view has moved: nothing flickers.
        let size = (self.ticks[last - 1] - self.ticks[first]).div_ceil(most).max(1);
        let size = size.checked_next_power_of_two().unwrap_or(size);
        let mut runs = self.runs(values, first, last);
        if buckets < runs.len() {
            runs = self.joined(runs, size);
        }
        let is_exact = last - first <= 4 * buckets;
        let segment = |run: Range<usize>| {
            let mut points = if is_exact {
                run.map(|i| [self.ticks[i] as f64, values.values()[i].into()]).collect()
            } else {
                self.banded(values, run.start, run.end, size)
            };
            points.retain(|point: &[f64; 2]| point[1].is_finite());
            points
        };
        runs.into_iter().map(segment).collect()
    }

    fn runs(&self, values: &Column, first: usize, last: usize) -> Vec<Range<usize>> {
        let gaps = self.gaps(self.ticks[first], self.ticks[last - 1]).iter();
        let begins = gaps.map(|gap| self.ticks.partition_point(|tick| *tick < gap.next));
        let mut at = first;
        let mut runs = Vec::new();
        for end in begins.chain([last]) {
            runs.extend(values.runs(at, end));
            at = end;
        }
        runs
    }

    fn joined(&self, runs: Vec<Range<usize>>, size: u64) -> Vec<Range<usize>> {
        let mut joined: Vec<Range<usize>> = Vec::new();
        for run in runs {
            match joined.last_mut() {
                Some(last) if self.ticks[run.start] - self.ticks[last.end - 1] < size => {
                    last.end = run.end;
                }
                Some(_) | None => joined.push(run),
            }
        }
        joined
    }

    /// Returns for each `size` ticks the first, the smallest, the largest and the last value.
    fn banded(&self, values: &Column, first: usize, last: usize, size: u64) -> Vec<[f64; 2]> {
        let ticks = &self.ticks[..last];
        let mut points = Vec::new();
        let mut at = first;
        while at < last {
            let next = (ticks[at] / size).saturating_add(1).saturating_mul(size);
            // After the last tick there is no next one.
            let end = at + ticks[at..].partition_point(|tick| *tick < next).max(1);
            let (begin, done) = (ticks[at] as f64, ticks[end - 1] as f64);
            let ends = [values.values()[at], values.values()[end - 1]];
            points.push([begin, ends[0].into()]);
            if let Some((low, high)) = values.range(at, end) {
                let middle = f64::midpoint(begin, done);
                // A monotonic stretch needs its ends only.
                let beyond = [low, high].into_iter().filter(|it| !within(*it, ends));
                points.extend(beyond.map(|it| [middle, it.into()]));
            }
            if at + 1 < end {
                points.push([done, ends[1].into()]);
            }
            at = end;
        }
        points
    }
}

fn within(x: f32, [a, b]: [f32; 2]) -> bool {
    (a.min(b)..=a.max(b)).contains(&x)
}

fn rows(block: &KeyBlock) -> usize {
    let lengths = [block.position.len(), block.force.len(), block.sent.len(), block.mode.len()];
    lengths.into_iter().fold(block.after.len(), usize::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: f64 = 1e-3;

    fn block(tick: u64, after: &[u32], mode: u8) -> KeyBlock {
        let rows = after.len();
        let position = after.iter().map(|after| f64::from(*after) * 1e-3).collect();
        KeyBlock {
            tick,
            after: after.to_vec(),
            position,
            force: vec![1.0; rows],
            sent: vec![2.0; rows],
            mode: vec![mode; rows],
            signals: vec![3.0; 2 * rows],
            ..KeyBlock::default()
        }
    }

    #[test]
    fn a_key_lies_still_between_rows() {
        let mut trace = Trace::default();
        trace.append(&block(100, &[0, 1, 50], 0), PERIOD);
        assert_eq!(trace.ticks(), [100, 101, 149, 150]);
        assert_eq!(trace.values(0), [0.0, 0.001, 0.001, 0.05]);
        assert_eq!(trace.value_at(0, 120), Some(0.001));
        assert_eq!(trace.value_at(4, 150), Some(3.0));
        assert_eq!(trace.value_at(0, 99), None);
    }

    #[test]
    fn speed_is_the_slope_of_position() {
        let mut trace = Trace::default();
        trace.append(&block(0, &(0..20).collect::<Vec<_>>(), 0), PERIOD);
        assert!((trace.values(1)[19] - 1.0).abs() < 1e-4, "{:?}", trace.values(1));
    }

    #[test]
    fn an_epoch_lasts_until_the_next() {
        let mut trace = Trace::default();
        for (tick, mode) in [(0, 0), (10, 0), (20, 1), (30, 0)] {
            trace.append(&block(tick, &[0], mode), PERIOD);
        }
        let epochs: Vec<_> = trace.epochs().iter().map(|epoch| (epoch.tick, epoch.mode)).collect();
        assert_eq!(epochs, [(0, 0), (20, 1), (30, 0)]);
    }

    #[test]
    fn memory_stays_below_its_cap() {
        let mut trace = Trace::default();
        let after: Vec<u32> = (0..1000).collect();
        for i in 0..100 {
            trace.append(&block(i * 1000, &after, u8::from(i % 2 == 0)), PERIOD);
            trace.cap(200_000);
        }
        assert!(trace.bytes() <= 250_000 + 64 * trace.row_bytes(), "{}", trace.bytes());
        assert_eq!(trace.ticks().last(), Some(&99_999));
        assert_eq!(trace.ticks().len(), trace.modes().len());
        assert_eq!(trace.ticks().len(), trace.values(5).len());
    }

    #[test]
    fn a_long_stretch_keeps_its_spikes() {
        let mut trace = Trace::default();
        let mut long = block(0, &(0..50_000).collect::<Vec<_>>(), 0);
        long.force[31_415] = -7.0;
        trace.append(&long, PERIOD);
        let [points] = &trace.segments(2, 0, 50_000, 400)[..] else { panic!("a break") };
        assert!(points.len() <= 1640, "{}", points.len());
        assert!(points.iter().any(|[_, force]| *force < -6.9));
    }

    fn ends(trace: &Trace, column: usize, buckets: usize) -> Vec<(f64, f64)> {
        let segments = trace.segments(column, 0, u64::MAX, buckets);
        segments.iter().map(|points| (points[0][0], points[points.len() - 1][0])).collect()
    }

    #[test]
    fn a_curve_breaks_where_there_are_no_values() {
        let mut trace = Trace::default();
        let mut torn = block(0, &(0..1000).collect::<Vec<_>>(), 0);
        for row in 400..600 {
            torn.signals[2 * row] = f32::NAN;
        }
        torn.force[700] = f64::INFINITY;
        trace.append(&torn, PERIOD);
        for buckets in [20, 400] {
            assert_eq!(ends(&trace, 4, buckets), [(0.0, 399.0), (600.0, 999.0)], "{buckets}");
            assert_eq!(ends(&trace, 2, buckets), [(0.0, 699.0), (701.0, 999.0)], "{buckets}");
            assert_eq!(ends(&trace, 5, buckets), [(0.0, 999.0)], "{buckets}");
        }
    }

    #[test]
    fn only_a_key_at_rest_is_as_the_row_before() {
        let mut trace = Trace::default();
        let flagged = |tick, flags: &[u8]| KeyBlock {
            flags: flags.to_vec(),
            ..block(tick, &(0..10).collect::<Vec<_>>()[..flags.len()], 0)
        };
        // Rests from 1 on, is awake at 101, and rests from 201 on; rows before 301 are missing.
        trace.append(&flagged(0, &[0, 1]), PERIOD);
        trace.append(&flagged(100, &[1, 0]), PERIOD);
        trace.append(&flagged(200, &[0, 1]), PERIOD);
        trace.append(&flagged(300, &[9, 1]), PERIOD);
        assert_eq!(ends(&trace, 2, 100), [(0.0, 101.0), (200.0, 201.0), (300.0, 301.0)]);
        for (tick, is_known) in [(50, true), (101, true), (102, false), (199, false), (200, true)] {
            assert_eq!(trace.value_at(2, tick).is_some(), is_known, "{tick}");
        }
        assert!(trace.value_at(2, 250).is_none() && trace.value_at(2, 5000).is_some());
    }

    #[test]
    fn a_curve_with_many_breaks_is_bounded() {
        let mut trace = Trace::default();
        let mut torn = block(0, &(0..50_000).collect::<Vec<_>>(), 0);
        torn.force.iter_mut().step_by(2).for_each(|it| *it = f64::NAN);
        trace.append(&torn, PERIOD);
        let points: usize = trace.segments(2, 0, 50_000, 100).iter().map(Vec::len).sum();
        assert!(0 < points && points <= 800, "{points}");
    }

    #[test]
    fn a_block_with_short_columns_is_taken_as_far_as_it_goes() {
        let mut trace = Trace::default();
        let mut torn = block(0, &[0, 1, 2], 0);
        torn.force.truncate(2);
        trace.append(&torn, PERIOD);
        assert_eq!(trace.ticks(), [0, 1]);
        trace.append(&KeyBlock::default(), PERIOD);
    }
}
