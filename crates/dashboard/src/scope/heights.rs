//! The chosen ranges of values of plots.

use std::collections::BTreeMap;

/// Smallest and largest difference between the ends of a plot, in its unit.
const SPAN: (f64, f64) = (1e-9, 1e12);

/// Smallest and largest shown value of plots, each in its own unit.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Heights(BTreeMap<usize, (f64, f64)>);

impl Heights {
    /// Returns the range of the plot `lane`, counted from the top; `None` shows all values.
    pub fn of(&self, lane: usize) -> Option<(f64, f64)> {
        self.0.get(&lane).copied()
    }

    /// Returns `true` if any plot has a chosen range.
    pub fn is_chosen(&self) -> bool {
        !self.0.is_empty()
    }

    /// Sets a plot that shows `seen` to show `factor` times as much around the fixed value `about`.
    pub fn zoom(&mut self, lane: usize, seen: (f64, f64), factor: f64, about: f64) {
        let (low, high) = (about + (seen.0 - about) * factor, about + (seen.1 - about) * factor);
        if (SPAN.0..=SPAN.1).contains(&(high - low)) {
            self.0.insert(lane, (low, high));
        }
    }

    /// Moves the range of a plot, unless it shows all values.
    pub fn pan(&mut self, lane: usize, by: f64) {
        if let Some((low, high)) = self.0.get_mut(&lane).filter(|_| by.is_finite()) {
            *low += by;
            *high += by;
        }
    }

    pub fn fit(&mut self, lane: usize) {
        self.0.remove(&lane);
    }

    pub fn fit_all(&mut self) {
        self.0.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn shows(heights: &Heights, low: f64, high: f64) {
        let seen = heights.of(1).expect("somebody chose");
        assert!((seen.0 - low).abs() < 1e-9 && (seen.1 - high).abs() < 1e-9, "{seen:?}");
    }

    #[test]
    fn zooming_leaves_the_value_under_the_pointer() {
        let mut heights = Heights::default();
        heights.zoom(1, (0.0, 10.0), 0.5, 8.0);
        shows(&heights, 4.0, 9.0);
        heights.pan(1, -1.5);
        shows(&heights, 2.5, 7.5);
        assert_eq!(heights.of(0), None);
        heights.fit(1);
        assert!(!heights.is_chosen());
    }

    #[test]
    fn what_would_show_nothing_is_no_zoom() {
        let mut heights = Heights::default();
        for (seen, factor, about) in [
            ((0.0, 1.0), 0.0, 0.5),
            ((0.0, 1.0), -1.0, 0.5),
            ((0.0, 1.0), f64::INFINITY, 0.5),
            ((0.0, f64::NAN), 0.5, 0.5),
            ((0.0, 1.0), 0.5, f64::NAN),
        ] {
            heights.zoom(1, seen, factor, about);
        }
        heights.pan(1, 1.0);
        assert!(!heights.is_chosen());
    }
}
