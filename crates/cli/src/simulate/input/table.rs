//! An input given as samples, reconstructed between them.
//!
//! Each interval is one cubic s(t) = c0 + d (c1 + d (c2 + d c3)), d = t − ti, so its rates are
//! exact derivatives. Outside the table the end values hold, at rest.

use std::path::Path;

use csv::{ReaderBuilder, StringRecord, Trim};
use documents::open_input;
use pode::Motion;

use super::super::args::Reconstruct;
use super::{HeldInput, InputMistake, NAME};

const MOST_MISTAKES: usize = 10;

/// Samples of s with their reconstruction.
#[derive(Clone, PartialEq, Debug)]
pub struct InputTable {
    /// Start (s) and coefficients of each interval.
    pieces: Vec<(f64, [f64; 4])>,
    /// First and last sample: (t, s).
    ends: [(f64, f64); 2],
    /// Times of the samples (s).
    samples: Vec<f64>,
}

impl InputTable {
    /// Reads a CSV file with the header `t,s`; returns every mistake in it.
    pub(super) fn read(path: &Path, how: Reconstruct) -> Result<Self, Vec<InputMistake>> {
        let fail = |cause| vec![InputMistake::Read { path: path.to_owned(), cause }];
        let mut reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(Trim::All)
            .from_reader(open_input(path).map_err(|cause| fail(cause.into()))?);
        let mut scan = TableScan { path, samples: Vec::new(), mistakes: Vec::new() };
        for (row, record) in reader.records().enumerate() {
            let record = record.map_err(fail)?;
            if row == 0 { scan.header(&record) } else { scan.row(&record) }
        }
        Ok(Self::through(&scan.finish()?, how))
    }

    /// Reconstructs `samples` (t, s), at least two with increasing t.
    pub fn through(samples: &[(f64, f64)], how: Reconstruct) -> Self {
        let knots = Knots::new(samples);
        let mut pieces: Vec<_> = match how {
            Reconstruct::Hold => samples.iter().map(|(t, s)| (*t, [*s, 0.0, 0.0, 0.0])).collect(),
            Reconstruct::Linear => knots.pieces(|i| [knots.m[i], 0.0, 0.0]),
            Reconstruct::Quadratic => knots.pieces(|i| knots.parabola(i)),
            Reconstruct::Hermite => knots.hermite(&knots.central_slopes()),
            Reconstruct::Spline => knots.hermite(&knots.spline_slopes()),
        };
        pieces.shrink_to_fit();
        let ends = [samples[0], samples[samples.len() - 1]];
        Self { pieces, ends, samples: samples.iter().map(|(t, _)| *t).collect() }
    }

    /// Returns s and its rates at `t` (s).
    pub fn at(&self, t: f64) -> Motion {
        let (start, piece) = self.piece_at(t);
        motion(piece, t - start)
    }

    /// Returns the times of held end values in a run from 0 to `until` (s), but for a rounding.
    pub(super) fn held(&self, until: f64) -> Vec<HeldInput> {
        let [(first, start), (last, end)] = self.ends;
        let before = HeldInput { from: 0.0, to: first.min(until), s: start };
        let after = HeldInput { from: last.max(0.0), to: until, s: end };
        let lasts = |it: &HeldInput| it.to - it.from > CRUMB * until;
        [before, after].into_iter().filter(lasts).collect()
    }

    /// Returns the interval at `t` (s): its start (s) and coefficients.
    fn piece_at(&self, t: f64) -> (f64, [f64; 4]) {
        let [first, last] = self.ends;
        let held = |(start, position)| (start, [position, 0.0, 0.0, 0.0]);
        if t < first.0 {
            return held(first);
        }
        if t > last.0 {
            return held(last);
        }
        let next = self.pieces.partition_point(|(start, _)| *start <= t);
        self.pieces.get(next.saturating_sub(1)).copied().unwrap_or_else(|| held((t, f64::NAN)))
    }

    /// Returns the largest magnitudes of s and its rates from `from` to `to` (s); `None` if a
    /// sample is between. A quantity that jumps at an end has a rate without a bound.
    pub(super) fn bound(&self, from: f64, to: f64) -> Option<Motion> {
        let crumb = CRUMB * (to - from);
        let later = self.samples.partition_point(|t| *t <= from + crumb);
        if self.samples.get(later).is_some_and(|t| *t < to - crumb) {
            return None;
        }
        let (start, piece) = self.piece_at(0.5 * (from + to));
        let size = self.size(later, piece, (from - start).abs().max((to - start).abs()));
        let most = motion(piece, from - start).bound_over(to - from);
        Some([from, to].into_iter().fold(most, |most, end| {
            let jump = Jump::between(&motion(piece, end - start), &self.at(end), &size);
            jump.within(most)
        }))
    }
}

impl InputTable {
    /// Returns the size of the terms of a motion up to `d` (s) into the interval before the sample
    /// `later`: an interval's rates are differences over its length.
    fn size(&self, later: usize, piece: [f64; 4], d: f64) -> Motion {
        let size = motion(piece.map(f64::abs), d);
        let ends = later.checked_sub(1).and_then(|it| self.samples.get(it..=later));
        let per_second = ends.map_or(0.0, |ends| 1.0 / (ends[1] - ends[0]));
        let rate = size.rate + size.position * per_second;
        Motion { rate, acceleration: size.acceleration + rate * per_second, ..size }
    }
}

/// Share of a time within which a sample at its end differs by rounding only.
const CRUMB: f64 = 1e-9;

/// Returns the motion `d` (s) after the start of an interval.
const fn motion([c0, c1, c2, c3]: [f64; 4], d: f64) -> Motion {
    Motion {
        position: c0 + d * (c1 + d * (c2 + d * c3)),
        rate: c1 + d * (2.0 * c2 + d * 3.0 * c3),
        acceleration: 2.0 * c2 + d * 6.0 * c3,
        jerk: 6.0 * c3,
    }
}

/// Discontinuous entries of a motion at an instant.
struct Jump {
    position: bool,
    rate: bool,
    acceleration: bool,
}

impl Jump {
    /// Compares the two sides `a` and `b`, with terms of the size `size`.
    fn between(a: &Motion, b: &Motion, size: &Motion) -> Self {
        let jumps = |a: f64, b: f64, size: f64| (a - b).abs() > 16.0 * f64::EPSILON * size;
        Self {
            position: jumps(a.position, b.position, size.position),
            rate: jumps(a.rate, b.rate, size.rate),
            acceleration: jumps(a.acceleration, b.acceleration, size.acceleration),
        }
    }

    fn within(&self, most: Motion) -> Motion {
        let or = |jumps: bool, most: f64| if jumps { f64::INFINITY } else { most };
        Motion {
            position: most.position,
            rate: or(self.position, most.rate),
            acceleration: or(self.position || self.rate, most.acceleration),
            jerk: or(self.position || self.rate || self.acceleration, most.jerk),
        }
    }
}

struct TableScan<'a> {
    path: &'a Path,
    samples: Vec<(f64, f64)>,
    mistakes: Vec<InputMistake>,
}

impl TableScan<'_> {
    fn mistake(&mut self, record: &StringRecord, column: usize, problem: String) {
        let line = record.position().map_or(0, csv::Position::line);
        self.mistakes.push(InputMistake::Cell {
            path: self.path.to_owned(),
            line,
            column,
            problem,
        });
    }

    fn header(&mut self, record: &StringRecord) {
        for (index, wanted) in ["t", NAME].into_iter().enumerate() {
            let got = record.get(index).unwrap_or_default();
            if got != wanted {
                let problem = format!("the header must be t,s: expected `{wanted}`, not `{got}`");
                self.mistake(record, index + 1, problem);
            }
        }
        self.width(record);
    }

    fn row(&mut self, record: &StringRecord) {
        self.width(record);
        let [t, s] = [0, 1].map(|index| self.number(record, index));
        let (Some(t), Some(s)) = (t, s) else { return };
        if let Some((before, _)) = self.samples.last().filter(|(before, _)| *before >= t) {
            let problem = format!("t = {t:?} is not after {before:?}: times must increase");
            self.mistake(record, 1, problem);
        } else {
            self.samples.push((t, s));
        }
    }

    fn width(&mut self, record: &StringRecord) {
        if record.len() > 2 {
            self.mistake(record, 3, format!("{} columns: a row is t,s", record.len()));
        }
    }

    fn number(&mut self, record: &StringRecord, index: usize) -> Option<f64> {
        let name = ["t", NAME][index];
        let Some(text) = record.get(index) else {
            self.mistake(record, index + 1, format!("{name} is missing"));
            return None;
        };
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        if number.is_none() {
            self.mistake(record, index + 1, format!("{name} = `{text}` is not a finite number"));
        }
        number
    }

    fn finish(mut self) -> Result<Vec<(f64, f64)>, Vec<InputMistake>> {
        let path = || self.path.to_owned();
        if self.mistakes.len() > MOST_MISTAKES {
            let more = self.mistakes.len() - MOST_MISTAKES;
            self.mistakes.truncate(MOST_MISTAKES);
            self.mistakes.push(InputMistake::More { path: path(), more });
        } else if self.mistakes.is_empty() && self.samples.len() < 2 {
            let rows = self.samples.len();
            self.mistakes.push(InputMistake::TooShort { path: path(), rows });
        }
        if self.mistakes.is_empty() { Ok(self.samples) } else { Err(self.mistakes) }
    }
}

struct Knots<'a> {
    samples: &'a [(f64, f64)],
    /// Lengths of the intervals (s).
    h: Vec<f64>,
    /// Slopes of their chords.
    m: Vec<f64>,
}

impl<'a> Knots<'a> {
    fn new(samples: &'a [(f64, f64)]) -> Self {
        let pairs = samples.windows(2);
        let h: Vec<_> = pairs.map(|pair| pair[1].0 - pair[0].0).collect();
        let pairs = samples.windows(2).zip(&h);
        let m = pairs.map(|(pair, h)| (pair[1].1 - pair[0].1) / h).collect();
        Self { samples, h, m }
    }

    /// Returns one cubic per interval, from the samples and `[c1, c2, c3]`.
    fn pieces(&self, coefficients: impl Fn(usize) -> [f64; 3]) -> Vec<(f64, [f64; 4])> {
        let intervals = self.samples.iter().enumerate().take(self.h.len());
        intervals
            .map(|(i, (t, s))| {
                let [c1, c2, c3] = coefficients(i);
                (*t, [*s, c1, c2, c3])
            })
            .collect()
    }

    /// Returns half the second derivative of the parabola about the inner knot `i`.
    fn bend(&self, i: usize) -> f64 {
        (self.m[i] - self.m[i - 1]) / (self.h[i - 1] + self.h[i])
    }

    /// Returns the parabola of interval `i`: through its ends and the sample before.
    fn parabola(&self, i: usize) -> [f64; 3] {
        if self.h.len() < 2 {
            return [self.m[i], 0.0, 0.0];
        }
        let bend = self.bend(i.max(1));
        [self.m[i] - bend * self.h[i], bend, 0.0]
    }

    fn hermite(&self, slopes: &[f64]) -> Vec<(f64, [f64; 4])> {
        self.pieces(|i| {
            let (h, m, d0, d1) = (self.h[i], self.m[i], slopes[i], slopes[i + 1]);
            [d0, (3.0 * m - 2.0 * d0 - d1) / h, (d0 + d1 - 2.0 * m) / (h * h)]
        })
    }

    /// Returns the slopes of the parabolas through each sample and its neighbours.
    fn central_slopes(&self) -> Vec<f64> {
        let n = self.h.len();
        if n < 2 {
            return vec![self.m[0]; 2];
        }
        let mut slopes = vec![self.m[0] - self.bend(1) * self.h[0]];
        slopes.extend((1..n).map(|i| self.m[i] - self.bend(i) * self.h[i]));
        slopes.push(self.m[n - 1] + self.bend(n - 1) * self.h[n - 1]);
        slopes
    }

    /// Returns the slopes of the not-a-knot cubic spline; of the parabola through three samples,
    /// the line through two. `[dB78]` chapter IV, eq. 7 and 13: the end conditions leave the system
    /// tridiagonal.
    fn spline_slopes(&self) -> Vec<f64> {
        let n = self.h.len();
        if n < 3 {
            return self.central_slopes();
        }
        let (h, m) = (&self.h, &self.m);
        let mut rows = Vec::with_capacity(n + 1);
        let wide = h[0] + h[1];
        let right = ((h[0] + 2.0 * wide) * h[1] * m[0] + h[0] * h[0] * m[1]) / wide;
        rows.push([0.0, h[1], wide, right]);
        rows.extend((1..n).map(|i| {
            let right = 3.0 * (h[i] * m[i - 1] + h[i - 1] * m[i]);
            [h[i], 2.0 * (h[i - 1] + h[i]), h[i - 1], right]
        }));
        let (last, before) = (h[n - 1], h[n - 2]);
        let wide = last + before;
        let right = (last * last * m[n - 2] + (2.0 * wide + last) * before * m[n - 1]) / wide;
        rows.push([wide, before, 0.0, right]);
        solve_tridiagonal(rows)
    }
}

/// Solves rows of [below, on, above the diagonal, right-hand side] by elimination.
fn solve_tridiagonal(mut rows: Vec<[f64; 4]>) -> Vec<f64> {
    for i in 1..rows.len() {
        let [_, on, above, right] = rows[i - 1];
        let factor = rows[i][0] / on;
        rows[i][1] -= factor * above;
        rows[i][3] -= factor * right;
    }
    let mut next = 0.0;
    let mut solution: Vec<_> = rows
        .iter()
        .rev()
        .map(|[_, on, above, right]| {
            next = (right - above * next) / on;
            next
        })
        .collect();
    solution.reverse();
    solution
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns s = sin t, sampled every `h` (s) on average, every second interval a third longer.
    fn sine(h: f64) -> Vec<(f64, f64)> {
        let step = |i: u32| h * (f64::from(i) + f64::from(i % 2) / 6.0);
        (0..1000).map(step).take_while(|t| *t < 6.0).map(|t| (t, t.sin())).collect()
    }

    /// Returns the largest errors of position and rate in the table's inner part.
    fn errors(h: f64, how: Reconstruct) -> (f64, f64) {
        let table = InputTable::through(&sine(h), how);
        (0..4000).map(|i| 1.0 + f64::from(i) * 1e-3).fold((0.0, 0.0), |(s, rate), t| {
            let at = table.at(t);
            let error = ((at.position - t.sin()).abs(), (at.rate - t.cos()).abs());
            (error.0.max(s), error.1.max(rate))
        })
    }

    #[track_caller]
    fn check_order(how: Reconstruct, position: f64, rate: f64) {
        let (coarse, fine) = (errors(0.1, how), errors(0.0125, how));
        let orders = [(coarse.0 / fine.0).log(8.0), (coarse.1 / fine.1).log(8.0)];
        for (observed, expected) in orders.into_iter().zip([position, rate]) {
            assert!((observed - expected).abs() < 0.15, "{how:?}: order {observed}");
        }
    }

    #[test]
    fn each_reconstruction_has_its_order() {
        check_order(Reconstruct::Hold, 1.0, 0.0);
        check_order(Reconstruct::Linear, 2.0, 1.0);
        check_order(Reconstruct::Quadratic, 3.0, 2.0);
        check_order(Reconstruct::Hermite, 3.0, 2.0);
        check_order(Reconstruct::Spline, 4.0, 3.0);
    }

    /// Returns the jumps of position, rate and acceleration at the inner knots.
    fn jumps(how: Reconstruct) -> [f64; 3] {
        let samples = sine(0.2);
        let table = InputTable::through(&samples, how);
        samples[1..samples.len() - 1].iter().fold([0.0; 3], |most, (t, _)| {
            let (before, after) = (table.at(t.next_down()), table.at(*t));
            let jump = [
                after.position - before.position,
                after.rate - before.rate,
                after.acceleration - before.acceleration,
            ];
            std::array::from_fn(|i| jump[i].abs().max(most[i]))
        })
    }

    #[test]
    fn each_reconstruction_is_as_smooth_as_it_says() {
        let continuous = |how| jumps(how).map(|jump| jump < 1e-11);
        assert_eq!(continuous(Reconstruct::Hold), [false, true, true], "both sides are at rest");
        assert_eq!(continuous(Reconstruct::Linear), [true, false, true], "no side bends");
        assert_eq!(continuous(Reconstruct::Quadratic), [true, false, false]);
        assert_eq!(continuous(Reconstruct::Hermite), [true, true, false]);
        assert_eq!(continuous(Reconstruct::Spline), [true, true, true]);
    }

    #[test]
    fn outside_the_table_the_end_values_hold() {
        for how in [Reconstruct::Hold, Reconstruct::Linear, Reconstruct::Spline] {
            let table = InputTable::through(&sine(0.2), how);
            let [first, last] = table.ends;
            let held = |position| Motion { position, ..Motion::default() };
            assert_eq!(table.at(first.0 - 0.1), held(first.1));
            assert_eq!(table.at(last.0 + 0.1), held(last.1));
            assert!((table.at(last.0).position - last.1).abs() < 1e-15);
        }
    }

    #[test]
    fn bounds_hold_between_samples_and_not_across_them() {
        for how in [Reconstruct::Quadratic, Reconstruct::Hermite, Reconstruct::Spline] {
            let table = InputTable::through(&sine(0.1), how);
            let (from, to) = (table.samples[7], table.samples[8]);
            let most = table.bound(from, to).expect("no sample inside");
            for part in 0..100 {
                let s = table.at(from + (to - from) * f64::from(part) / 100.0);
                assert!(s.position.abs() <= most.position && s.rate.abs() <= most.rate, "{how:?}");
                let higher = (s.acceleration.abs(), s.jerk.abs());
                assert!(higher.0 <= most.acceleration && higher.1 <= most.jerk, "{how:?}");
            }
            assert_eq!(table.bound(from, table.samples[9]), None, "{how:?}: a sample inside");
        }
    }

    #[test]
    fn what_jumps_at_a_sample_has_a_rate_without_a_bound() {
        let bound = |how| {
            let table = InputTable::through(&sine(0.1), how);
            table.bound(table.samples[7], table.samples[8]).expect("no sample inside")
        };
        assert!(bound(Reconstruct::Hold).rate.is_infinite());
        let linear = bound(Reconstruct::Linear);
        assert!(linear.rate < 1.0 && linear.acceleration.is_infinite());
        let hermite = bound(Reconstruct::Hermite);
        assert!(hermite.acceleration < 2.0 && hermite.jerk.is_infinite());
        assert!(bound(Reconstruct::Spline).jerk < 2.0);
    }

    #[test]
    fn outside_the_table_nothing_moves() {
        let table = InputTable::through(&sine(0.1), Reconstruct::Linear);
        let last = table.ends[1];
        let most = table.bound(last.0 + 0.1, last.0 + 0.2);
        assert_eq!(most, Some(Motion { position: last.1.abs(), ..Motion::default() }));
        assert_eq!(table.bound(last.0 - 0.05, last.0 + 0.2), None);
    }

    #[test]
    fn few_samples_give_a_line_and_a_parabola() {
        let parabola = |t: f64| (t, 1.0 + t * t);
        for how in [Reconstruct::Quadratic, Reconstruct::Hermite, Reconstruct::Spline] {
            let line = InputTable::through(&[(0.0, 1.0), (2.0, 5.0)], how).at(0.5);
            assert_eq!((line.position, line.rate, line.acceleration), (2.0, 2.0, 0.0), "{how:?}");
            let samples = [0.0, 1.0, 3.0].map(parabola);
            let at = InputTable::through(&samples, how).at(2.0);
            assert!((at.position - 5.0).abs() < 1e-14, "{how:?}: {at:?}");
            assert!((at.acceleration - 2.0).abs() < 1e-13, "{how:?}: {at:?}");
        }
    }
}
