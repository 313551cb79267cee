//! A column of numbers with the extremes of each block: drawing reads few rows and loses no spike.

use std::ops::Range;

pub(crate) const BLOCK: usize = 64;

/// A column of numbers, one for each row.
#[derive(Clone, Debug, Default)]
pub(crate) struct Column {
    values: Vec<f32>,
    lows: Vec<f32>,
    highs: Vec<f32>,
    has_holes: Vec<bool>,
}

impl Column {
    pub(crate) fn push(&mut self, value: f32) {
        if self.values.len().is_multiple_of(BLOCK) {
            self.lows.push(f32::INFINITY);
            self.highs.push(f32::NEG_INFINITY);
            self.has_holes.push(false);
        }
        self.values.push(value);
        let last = self.lows.len() - 1;
        if value.is_finite() {
            self.lows[last] = self.lows[last].min(value);
            self.highs[last] = self.highs[last].max(value);
        } else {
            self.has_holes[last] = true;
        }
    }

    pub(crate) fn forget(&mut self, blocks: usize) {
        let blocks = blocks.min(self.values.len() / BLOCK);
        self.values.drain(..blocks * BLOCK);
        self.lows.drain(..blocks);
        self.highs.drain(..blocks);
        self.has_holes.drain(..blocks);
    }

    pub(crate) fn values(&self) -> &[f32] {
        &self.values
    }

    /// Returns the longest stretches of finite values among the rows `from..to`.
    pub(crate) fn runs(&self, from: usize, to: usize) -> Vec<Range<usize>> {
        let to = to.min(self.values.len());
        let mut runs: Vec<Range<usize>> = Vec::new();
        let mut at = from;
        while at < to {
            let is_whole = !self.has_holes[at / BLOCK];
            let end = if is_whole { ((at / BLOCK + 1) * BLOCK).min(to) } else { at + 1 };
            if is_whole || self.values[at].is_finite() {
                match runs.last_mut() {
                    Some(last) if last.end == at => last.end = end,
                    Some(_) | None => runs.push(at..end),
                }
            }
            at = end;
        }
        runs
    }

    /// Returns the smallest and the largest finite value of the rows `from..to`.
    pub(crate) fn range(&self, from: usize, to: usize) -> Option<(f32, f32)> {
        let to = to.min(self.values.len());
        if to <= from {
            return None;
        }
        let (first, last) = (from.div_ceil(BLOCK), to / BLOCK);
        let mut range = (f32::INFINITY, f32::NEG_INFINITY);
        if first < last {
            widen(&mut range, &self.values[from..first * BLOCK], &self.values[from..first * BLOCK]);
            widen(&mut range, &self.lows[first..last], &self.highs[first..last]);
            widen(&mut range, &self.values[last * BLOCK..to], &self.values[last * BLOCK..to]);
        } else {
            widen(&mut range, &self.values[from..to], &self.values[from..to]);
        }
        (range.0 <= range.1).then_some(range)
    }
}

fn widen(range: &mut (f32, f32), lows: &[f32], highs: &[f32]) {
    let finite = |values: &'_ [f32], f: fn(f32, f32) -> f32, start| {
        values.iter().copied().filter(|it| it.is_finite()).fold(start, f)
    };
    *range = (finite(lows, f32::min, range.0), finite(highs, f32::max, range.1));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_is_that_of_its_rows() {
        let mut column = Column::default();
        let value = |i: usize| ((i * 7919) % 1009) as f32;
        (0..1000).for_each(|i| column.push(value(i)));
        for (from, to) in [(0, 1000), (3, 61), (63, 65), (64, 128), (5, 900), (999, 1000)] {
            let rows: Vec<f32> = (from..to).map(value).collect();
            let low = rows.iter().copied().fold(f32::INFINITY, f32::min);
            let high = rows.iter().copied().fold(f32::NEG_INFINITY, f32::max);
            assert_eq!(column.range(from, to), Some((low, high)), "{from}..{to}");
        }
        assert_eq!(column.range(10, 10), None);
    }

    #[test]
    fn one_row_among_many_is_not_lost() {
        let mut column = Column::default();
        (0..100_000).for_each(|i| column.push(if i == 54_321 { 9.0 } else { 0.0 }));
        assert_eq!(column.range(0, 100_000), Some((0.0, 9.0)));
        column.forget(2);
        assert_eq!(column.values().len(), 100_000 - 2 * BLOCK);
        assert_eq!(column.range(54_321 - 2 * BLOCK, 54_322 - 2 * BLOCK), Some((9.0, 9.0)));
    }

    #[test]
    fn what_is_no_number_is_passed_over() {
        let mut column = Column::default();
        for value in [f32::NAN, 1.0, f32::INFINITY, -2.0] {
            column.push(value);
        }
        assert_eq!(column.range(0, 4), Some((-2.0, 1.0)));
        assert_eq!(column.range(0, 1), None);
        assert_eq!(column.runs(0, 4), [1..2, 3..4]);
        (0..300).for_each(|i| column.push(if i == 200 { f32::NAN } else { 0.0 }));
        assert_eq!(column.runs(3, 304), [3..204, 205..304]);
    }
}
