mod linear;
mod logarithmic;

use std::ops::Range;

/// A linear or logarithmic axis between two positions.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Axis {
    scale: AxisScale,
    /// Values at both ends, as decimal logarithms for a logarithmic axis.
    ends: (f64, f64),
    /// Positions of both ends (pixels).
    places: (f64, f64),
}

/// Scale of an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum AxisScale {
    #[default]
    Linear,
    Logarithmic,
}

/// A line of the grid.
#[derive(Clone, PartialEq, Debug)]
pub struct GridLine {
    /// Position on the axis (pixels).
    pub place: f64,
    /// Number beside the line; a long axis has lines without.
    pub label: Option<String>,
}

impl Axis {
    pub const fn linear(range: &Range<f64>, places: (f64, f64)) -> Self {
        Self { scale: AxisScale::Linear, ends: (range.start, range.end), places }
    }

    /// Returns a logarithmic axis over `values` with room; one decade around 1 without values.
    pub fn logarithmic(values: impl Iterator<Item = f64>, places: (f64, f64)) -> Self {
        Self { scale: AxisScale::Logarithmic, ends: logarithmic::ends(values), places }
    }

    /// Returns a logarithmic axis over `range` of values above zero, without room.
    pub fn decades(range: &Range<f64>, places: (f64, f64)) -> Self {
        let ends = (logarithmic::log(range.start), logarithmic::log(range.end));
        Self { scale: AxisScale::Logarithmic, ends, places }
    }

    /// Returns the position of `value` (pixels).
    pub fn place(&self, value: f64) -> f64 {
        let (value, (low, high)) = match self.scale {
            AxisScale::Linear => (value, self.ends),
            AxisScale::Logarithmic => (logarithmic::log(value), self.ends),
        };
        // The length of the widest range overflows, its half does not.
        let part = (0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low);
        self.places.0 + part * (self.places.1 - self.places.0)
    }

    /// Returns the lines of the grid, about `wanted` of them with a number.
    pub fn lines(&self, wanted: f64) -> Vec<GridLine> {
        let ticks = match self.scale {
            AxisScale::Linear => linear::ticks(self.ends, wanted),
            AxisScale::Logarithmic => logarithmic::ticks(self.ends, wanted),
        };
        let line = |(value, label)| GridLine { place: self.place(value), label };
        ticks.into_iter().map(line).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_lie_within_their_ends_and_zero_at_the_floor() {
        let axis = Axis::logarithmic([0.0, 1.0].into_iter(), (100.0, 0.0));
        let (low, high) = (axis.place(0.0), axis.place(1.0));
        assert!(0.0 < high && high < low && low < 100.0, "{low}, {high}");
    }

    #[test]
    fn nothing_has_a_scale_too() {
        let axis = Axis::logarithmic(std::iter::empty(), (0.0, 100.0));
        assert!(axis.place(1.0) > 0.0 && axis.place(10.0) < 100.0);
    }

    #[test]
    fn the_widest_range_has_places_and_lines() {
        let axis = Axis::linear(&(-1.2e308..1.2e308), (0.0, 100.0));
        assert!((axis.place(0.0) - 50.0).abs() < 1e-9);
        let lines = axis.lines(6.0);
        assert_eq!(lines.len(), 5, "{lines:?}");
        assert!(lines.iter().all(|line| (0.0..=100.0).contains(&line.place)), "{lines:?}");
    }
}
