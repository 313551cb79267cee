//! A curve of any length in bounded memory: its visible points in each pixel column.

/// t (s) and a value.
pub(super) type TrackPoint = (f64, f64);

#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    pub(super) n: usize,
    /// End of the last column (s).
    pub(super) until: f64,
}

impl Columns {
    /// Returns the column of `t` (s).
    #[expect(clippy::cast_possible_truncation, reason = "clamped to the columns")]
    #[expect(clippy::cast_sign_loss, reason = "clamped to the columns")]
    pub(super) fn of(self, t: f64) -> usize {
        let last = self.n.saturating_sub(1);
        (t / self.until * self.n as f64).clamp(0.0, last as f64) as usize
    }

    /// Returns the number of samples that show all of a `duration` (s).
    pub(super) fn samples(self, duration: f64) -> usize {
        self.of(duration) + 1
    }
}

#[derive(Clone, Copy, Debug)]
struct PixelColumn {
    first: TrackPoint,
    low: TrackPoint,
    high: TrackPoint,
    last: TrackPoint,
    /// `true` if `low` came before `high`.
    rises: bool,
    /// `true` if the curve starts here after a gap.
    is_start: bool,
}

impl PixelColumn {
    const fn new(point: TrackPoint) -> Self {
        Self { first: point, low: point, high: point, last: point, rises: true, is_start: false }
    }

    fn add(&mut self, point: TrackPoint) {
        self.last = point;
        if point.1 < self.low.1 {
            (self.low, self.rises) = (point, false);
        } else if point.1 > self.high.1 {
            (self.high, self.rises) = (point, true);
        }
    }

    /// Returns the points in their order of time.
    const fn points(&self) -> [TrackPoint; 4] {
        let Self { first, low, high, last, .. } = *self;
        if self.rises { [first, low, high, last] } else { [first, high, low, last] }
    }
}

/// A drawn curve: at most four points per pixel column, with the extremes.
#[derive(Debug)]
pub(super) struct DecimatedCurve {
    axis: Columns,
    columns: Vec<Option<PixelColumn>>,
    /// `true` if the next point starts after a gap.
    is_cut: bool,
}

impl DecimatedCurve {
    pub(super) fn new(axis: Columns) -> Self {
        Self { axis, columns: vec![None; axis.n], is_cut: true }
    }

    /// Adds `value` at `t` (s), not before the last; a missing or infinite value cuts the curve.
    pub(super) fn add(&mut self, t: f64, value: Option<f64>) {
        let Some(value) = value.filter(|value| value.is_finite()) else {
            self.is_cut = true;
            return;
        };
        match &mut self.columns[self.axis.of(t)] {
            Some(column) => column.add((t, value)),
            empty => {
                *empty =
                    Some(PixelColumn { is_start: self.is_cut, ..PixelColumn::new((t, value)) });
            }
        }
        self.is_cut = false;
    }

    pub(super) fn stretches(&self) -> Vec<Vec<TrackPoint>> {
        let mut stretches: Vec<Vec<TrackPoint>> = Vec::new();
        for column in self.columns.iter().flatten() {
            if column.is_start || stretches.is_empty() {
                stretches.push(Vec::new());
            }
            if let Some(stretch) = stretches.last_mut() {
                stretch.extend(column.points());
                stretch.dedup();
            }
        }
        stretches
    }

    pub(super) fn extent(&self) -> Option<(f64, f64)> {
        let ends = self.columns.iter().flatten().map(|column| (column.low.1, column.high.1));
        ends.reduce(|(low, high), (lower, higher)| (low.min(lower), high.max(higher)))
    }

    /// Returns the largest magnitude; 1 if all values are zero.
    pub(super) fn peak(&self) -> f64 {
        let peak = self.extent().map_or(0.0, |(low, high)| low.abs().max(high.abs()));
        if peak > 0.0 { peak } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const AXIS: Columns = Columns { n: 20, until: 1.0 };

    fn track(points: &[(f64, Option<f64>)]) -> DecimatedCurve {
        let mut track = DecimatedCurve::new(AXIS);
        for (t, value) in points {
            track.add(*t, *value);
        }
        track
    }

    #[test]
    fn a_short_curve_is_kept_point_by_point() {
        let points = [(0.0, 1.0), (0.01, -1.0), (0.01, 2.0), (0.02, 0.0), (0.5, 3.0)];
        let track = track(&points.map(|(t, value)| (t, Some(value))));
        assert_eq!(track.stretches(), [points.to_vec()]);
        assert_eq!(track.extent(), Some((-1.0, 3.0)));
    }

    #[test]
    fn an_interruption_longer_than_a_column_is_seen() {
        let points = [(0.0, Some(1.0)), (0.2, None), (0.4, Some(2.0)), (0.6, Some(f64::NAN))];
        let track = track(&[&points[..], &[(0.8, Some(3.0)), (1.0, Some(4.0))]].concat());
        let expected = [vec![(0.0, 1.0)], vec![(0.4, 2.0)], vec![(0.8, 3.0), (1.0, 4.0)]];
        assert_eq!(track.stretches(), expected);
    }

    #[test]
    fn nothing_has_no_extent_and_a_peak_to_divide_by() {
        let track = track(&[(0.0, None)]);
        assert_eq!(track.extent(), None);
        assert!((track.peak() - 1.0).abs() < f64::EPSILON);
    }

    /// Generates more values than columns, in order of time.
    fn samples() -> impl Strategy<Value = Vec<TrackPoint>> {
        prop::collection::vec((0.0..=1.0, -1e3..1e3), 1..400).prop_map(
            |mut samples: Vec<TrackPoint>| {
                samples.sort_by(|a, b| a.0.total_cmp(&b.0));
                samples
            },
        )
    }

    fn extremes(points: &[TrackPoint]) -> Vec<Option<(f64, f64)>> {
        let of_column = |column: usize| {
            let values =
                points.iter().filter(|(t, _)| AXIS.of(*t) == column).map(|(_, v)| (*v, *v));
            values.reduce(|(low, high), (v, _)| (low.min(v), high.max(v)))
        };
        (0..AXIS.n).map(of_column).collect()
    }

    proptest! {
        #[test]
        fn every_extreme_is_kept_and_no_point_is_invented(samples in samples()) {
            let all: Vec<_> = samples.iter().map(|(t, v)| (*t, Some(*v))).collect();
            let kept = track(&all).stretches().concat();
            prop_assert_eq!(extremes(&kept), extremes(&samples));
            prop_assert!(kept.len() <= 4 * AXIS.n);
            let mut rest = samples.iter();
            prop_assert!(kept.iter().all(|point| rest.any(|sample| sample == point)));
            prop_assert_eq!((kept.first(), kept.last()), (samples.first(), samples.last()));
        }

        #[test]
        fn interruptions_lose_no_extreme(
            samples in samples(),
            holes in prop::collection::vec(any::<bool>(), 400),
        ) {
            let all: Vec<_> =
                samples.iter().zip(&holes).map(|((t, v), hole)| (*t, (!hole).then_some(*v))).collect();
            let present: Vec<_> = all.iter().filter_map(|(t, v)| Some((*t, (*v)?))).collect();
            prop_assert_eq!(extremes(&track(&all).stretches().concat()), extremes(&present));
        }
    }
}
