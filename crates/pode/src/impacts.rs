//! Sequences of impacts that would come to rest in one mode: their limit, its time and impulse.
//!
//! A ball bounces at ever shorter intervals. If the intervals shrink like a geometric sequence, or
//! ever more like one, infinitely many of them fit into a finite time (Zeno). If they tend to a
//! constant, they do not, however much they shrink at first: a pendulum against a wall keeps its
//! period. Aitken's Δ², the limit of the intervals, distinguishes both.

/// Changes of a ratio below this may be rounding: an interval is known to some 1e-9 of it.
const NOISE: f64 = 1e-6;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Impacts<M> {
    resting: Option<M>,
    /// Time from the latest impact (s) to the end declared then; infinite if none was.
    declared: f64,
    /// Time since the latest impact (s).
    since: f64,
    /// Times between impacts (s), newest first; 0 where none is known.
    intervals: [f64; 4],
    impulses: [f64; 4],
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Accumulation {
    /// Time from the latest impact to the last of all (s).
    pub(crate) after: f64,
    /// Error of `after` (s), estimated by the last change of the ratio.
    pub(crate) error: f64,
    /// Predicted ratio of each interval to the one before.
    pub(crate) ratio: f64,
    pub(crate) impulse: f64,
}

impl<M: Copy + PartialEq> Impacts<M> {
    pub(crate) const NONE: Self = Self {
        resting: None,
        declared: f64::INFINITY,
        since: 0.0,
        intervals: [0.0; 4],
        impulses: [0.0; 4],
    };

    /// Advances the time by `dt` (s).
    #[inline]
    pub(crate) fn pass(&mut self, dt: f64) {
        self.since += dt;
    }

    /// Adds an impact with this impulse that would come to rest in the mode `resting`.
    pub(crate) fn strike(&mut self, resting: M, impulse: f64) {
        if self.resting == Some(resting) {
            self.intervals = pushed(self.intervals, self.since);
        } else {
            *self = Self { resting: Some(resting), ..Self::NONE };
        }
        self.impulses = pushed(self.impulses, impulse);
        self.since = 0.0;
    }

    /// Declares the end of all impacts `after` (s) the latest one, with intervals shrinking by
    /// `ratio`; returns the error (s) by the declaration before, infinite at first.
    pub(crate) fn declare(&mut self, resting: M, after: f64, ratio: f64) -> f64 {
        let is_known = self.resting == Some(resting);
        let before = if is_known { self.declared - self.since } else { f64::INFINITY };
        *self = Self { resting: Some(resting), declared: after, ..Self::NONE };
        // The motion of the end from impact to impact shrinks at least with their speed.
        (after - before).abs() * ratio / (1.0 - ratio)
    }

    pub(crate) fn accumulation(&self) -> Option<Accumulation> {
        /// Limit of the intervals, relative to the newest, that counts as zero.
        const NOTHING: f64 = 0.05;
        let [c, b, a, first] = self.intervals;
        let shrinks = 0.0 < c && c < b && b < a;
        // Aitken's limit of the intervals: 0 for a geometric sequence.
        let limit = c - (c - b) * (c - b) / ((c - b) - (b - a));
        if !shrinks || limit.abs() > NOTHING * c || !limit.is_finite() {
            return None;
        }
        let now = c / b;
        let after = remaining(self.intervals)?;
        // The contribution of the ratio's change is known to about its own square, and to the
        // effect of one more or less such change; rounding is part of that.
        let added = (after - c * now / (1.0 - now)).abs();
        let wavers = ((now - b / a) - (b / a - a / first)).abs().min((now - b / a).abs());
        let error = (30.0 * added * added / after).max(wavers * after / (1.0 - now));
        // Impacts without an impulse on the input have none in future either.
        let impulse = remaining(self.impulses).unwrap_or(0.0);
        after.is_finite().then_some(Accumulation { after, error, ratio: now, impulse })
    }
}

fn pushed([a, b, c, _]: [f64; 4], newest: f64) -> [f64; 4] {
    [newest, a, b, c]
}

/// Sums all terms after a sequence with these last four, newest first; `None` if not finite. The
/// ratio of successive terms tends to a constant, and its distance from that shrinks by a factor of
/// its own: like a power of the speed, whatever the law of the impact is.
fn remaining([d, c, b, a]: [f64; 4]) -> Option<f64> {
    /// Terms before the rest is summed up as a geometric sequence.
    const TERMS: usize = 48;
    let [first, second, third] = [b / a, c / b, d / c];
    let shrinks = (third - second) / (second - first);
    // The quotient is noise where the ratio is constant. The distance shrinks like the speed.
    let is_noise = (third - second).abs() < NOISE;
    let shrinks = if is_noise { 0.0 } else { shrinks.max(0.0).min(third) };
    let (mut ratio, mut change) = (third, third - second);
    let (mut term, mut sum) = (d, 0.0);
    for _ in 0..TERMS {
        change *= shrinks;
        ratio += change;
        term *= ratio;
        sum += term;
    }
    let sum = sum + term * ratio / (1.0 - ratio);
    (sum.is_finite() && ratio < 1.0).then_some(sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(intervals: &[f64], impulses: &[f64]) -> Option<Accumulation> {
        let mut impacts = Impacts::NONE;
        impacts.strike((), impulses[0]);
        for (interval, impulse) in intervals.iter().zip(&impulses[1..]) {
            impacts.pass(*interval);
            impacts.strike((), *impulse);
        }
        impacts.accumulation()
    }

    #[test]
    fn a_geometric_sequence_ends_where_its_sum_does() {
        for e in [0.1, 0.5, 0.9, 0.99] {
            let powers = [1.0, e, e * e, e * e * e, e * e * e * e];
            let end = after(&powers[..4], &powers).expect("an end");
            let rest = powers[4] / (1.0 - e);
            assert!((end.after - rest).abs() < 1e-12 * rest, "e {e}: {end:?}");
            let impulse = powers[4] * e / (1.0 - e);
            assert!((end.impulse - impulse).abs() < 1e-12 * impulse, "e {e}: {end:?}");
        }
    }

    #[test]
    fn a_ratio_that_still_changes_is_followed_to_its_limit() {
        // The ratio of two intervals is 0.6 less a fraction of the interval itself.
        let mut intervals = [0.2; 200];
        for n in 1..intervals.len() {
            let last = intervals[n - 1];
            intervals[n] = last * (0.6 - 0.5 * last);
        }
        for n in 8..12 {
            let rest: f64 = intervals[n..].iter().sum();
            let end = after(&intervals[n - 4..n], &[5.0, 4.0, 3.0, 2.0, 1.0]).expect("an end");
            let error = (end.after - rest).abs();
            assert!(
                error < 60.0 * intervals[n] * intervals[n] * rest,
                "{n}: {error:e} of {rest:e}"
            );
            assert!(error <= end.error, "{n}: {error:e}, not within {:e}", end.error);
        }
    }

    #[test]
    fn a_declared_end_is_as_wrong_as_the_declaration_before_was() {
        let mut impacts = Impacts::NONE;
        assert!(impacts.declare((), 1.0, 0.5).is_infinite(), "the first one");
        impacts.pass(0.5);
        let error = impacts.declare((), 0.51, 0.5);
        assert!((error - 0.01).abs() < 1e-15, "{error}");
        impacts.pass(0.255);
        assert!(impacts.declare((), 0.255, 0.5) < 1e-16, "as it was said");
    }
}
