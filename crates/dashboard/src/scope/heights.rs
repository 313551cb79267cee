//! The ranges of values of plots, chosen or automatic, and the gains of curves.

use std::collections::BTreeMap;

use crate::number;

/// Smallest and largest difference between the ends of a plot, in its unit.
const SPAN: (f64, f64) = (1e-9, 1e12);

/// Smallest difference between the ends of a plot relative to its values: `f64` has 15 digits.
const RESOLUTION: f64 = 1e-11;

/// Free room above and below the values of an automatic range, relative to their range.
const ROOM: f64 = 0.08;

/// Fraction of an automatic range below which it shrinks to the values.
const USED: f64 = 0.5;

/// Ideal gain relative to the present one within which a gain stays: steps of 1, 2 and 5 are up to
/// 2.5 apart, so a gain near a step does not alternate.
const GAIN: std::ops::Range<f64> = 0.8..5.0;

/// Smallest and largest shown value of plots, each in its own unit.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Heights {
    chosen: BTreeMap<usize, (f64, f64)>,
    automatic: BTreeMap<usize, (f64, f64)>,
    gains: BTreeMap<(usize, String), f64>,
}

impl Heights {
    /// Returns the range of the plot `lane`, counted from the top; `None` shows all values.
    pub fn of(&self, lane: usize) -> Option<(f64, f64)> {
        self.chosen.get(&lane).copied()
    }

    pub fn is_chosen(&self) -> bool {
        !self.chosen.is_empty()
    }

    /// Sets a plot that shows `seen` to show `factor` times as much around the fixed value `about`.
    pub fn zoom(&mut self, lane: usize, seen: (f64, f64), factor: f64, about: f64) {
        let (low, high) = (about + (seen.0 - about) * factor, about + (seen.1 - about) * factor);
        let least = SPAN.0.max(RESOLUTION * low.abs().max(high.abs()));
        if (least..=SPAN.1).contains(&(high - low)) {
            self.chosen.insert(lane, (low, high));
        }
    }

    /// Moves the range of a plot, unless it shows all values.
    pub fn pan(&mut self, lane: usize, by: f64) {
        if let Some((low, high)) = self.chosen.get_mut(&lane).filter(|_| by.is_finite()) {
            *low += by;
            *high += by;
        }
    }

    /// Returns the automatic range of a plot, which stays while its values use half of it.
    pub fn automatic(&mut self, lane: usize, (low, high): (f64, f64)) -> (f64, f64) {
        let range = self.automatic.entry(lane).or_insert((0.0, 0.0));
        let is_outside = low < range.0 || range.1 < high;
        if is_outside || high - low < USED * (range.1 - range.0) {
            let room = ROOM * (high - low);
            *range = (low - room, high + room);
        }
        *range
    }

    /// Returns the gain of a channel of a plot, 1, 2 or 5 times a power of ten, if `ideal` would fill
    /// the plot. It stays as long as it is near.
    pub fn gain(&mut self, lane: usize, channel: &str, ideal: f64) -> f64 {
        let gain = self.gains.entry((lane, channel.to_owned())).or_insert(0.0);
        if !GAIN.contains(&(ideal / *gain)) {
            *gain = number::round(ideal);
        }
        *gain
    }

    pub fn fit(&mut self, lane: usize) {
        self.chosen.remove(&lane);
        self.automatic.remove(&lane);
        self.gains.retain(|(of, _), _| *of != lane);
    }

    pub fn fit_all(&mut self) {
        *self = Self::default();
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
            ((1e6, 1e6 + 1e-5), 0.5, 1e6),
        ] {
            heights.zoom(1, seen, factor, about);
        }
        heights.pan(1, 1.0);
        assert!(!heights.is_chosen());
    }

    #[test]
    fn small_changes_move_neither_a_range_nor_a_gain() {
        let mut heights = Heights::default();
        let range = heights.automatic(0, (0.0, 1.0));
        for high in [0.9, 1.05, 0.6] {
            assert_eq!(heights.automatic(0, (0.0, high)), range, "{high}");
        }
        assert!(1.5 < heights.automatic(0, (0.0, 1.5)).1);
        assert!(heights.automatic(0, (0.0, 0.2)).1 < 0.3);
        let gains = [2.2, 1.9, 2.1, 4.9, 1.7].map(|ideal| heights.gain(0, "position", ideal));
        assert!(gains.iter().all(|gain| (gain - 2.0).abs() < 1e-12), "{gains:?}");
        assert!((heights.gain(0, "position", 1.5) - 1.0).abs() < 1e-12);
    }
}
