//! One key, tick by tick: columns with a cap on memory.

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

/// The rows of one key.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    ticks: Vec<u64>,
    columns: Vec<Column>,
    modes: Vec<u8>,
    epochs: Vec<Epoch>,
    revision: u32,
}

impl Trace {
    /// Appends a block's rows and fills the ticks in which the key rested.
    ///
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
                self.fill(tick, period);
                self.push(block, row, tick, period);
            }
        }
    }

    /// Repeats the last row just before `tick`, if ticks are missing.
    fn fill(&mut self, tick: u64, period: f64) {
        let (Some(last), Some(row)) = (self.ticks.last(), self.ticks.len().checked_sub(1)) else {
            return;
        };
        if last.saturating_add(1) < tick {
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

    /// Forgets the oldest rows until at most `bytes` are in use.
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

    /// Returns the voice of the newest row.
    pub fn revision(&self) -> u32 {
        self.revision
    }

    /// Returns the row that holds at `tick`: the last one up to it.
    pub fn row_at(&self, tick: u64) -> Option<usize> {
        self.ticks.partition_point(|row| *row <= tick).checked_sub(1)
    }

    /// Returns the value of `column` at `tick`, as of the last row up to it.
    pub fn value_at(&self, column: usize, tick: u64) -> Option<f32> {
        let row = self.row_at(tick)?;
        self.values(column).get(row).copied()
    }

    /// Returns points of `column` to draw between two ticks: `[tick, value]`. About four at most
    /// for each of `buckets`, among them the smallest and the largest value of each.
    pub fn points(&self, column: usize, from: u64, to: u64, buckets: usize) -> Vec<[f64; 2]> {
        let first = self.row_at(from).unwrap_or(0);
        let last = (self.ticks.partition_point(|row| *row <= to) + 1).min(self.ticks.len());
        let Some(values) = self.columns.get(column) else { return Vec::new() };
        if last <= first {
            return Vec::new();
        }
        if last - first <= 4 * buckets {
            let rows = first..last;
            return rows.map(|i| [self.ticks[i] as f64, values.values()[i].into()]).collect();
        }
        self.banded(values, first, last, buckets)
    }

    /// Returns for each bucket of ticks the first, the smallest, the largest and the last value.
    fn banded(&self, values: &Column, first: usize, last: usize, buckets: usize) -> Vec<[f64; 2]> {
        let ticks = &self.ticks[..last];
        let most = u64::try_from(buckets.max(1)).unwrap_or(u64::MAX);
        // Buckets begin at the same ticks however far the view has moved: nothing flickers.
        let size = (ticks[last - 1] - ticks[first]).div_ceil(most).max(1);
        let size = size.checked_next_power_of_two().unwrap_or(size);
        let mut points = Vec::with_capacity(4 * buckets + 8);
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

/// Returns the number of rows that every column has.
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
        let points = trace.points(2, 0, 50_000, 400);
        assert!(points.len() <= 1640, "{}", points.len());
        assert!(points.iter().any(|[_, force]| *force < -6.9));
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
