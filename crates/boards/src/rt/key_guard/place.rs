//! Detects a key that stands still away from its ends.
//!
//! Only reported, since a hand can hold a key anywhere: counts may be lost, or it started pressed.

/// Tremor (m) and duration (s) of standing still.
const STILLNESS: f64 = 5e-6;
const LONG: f64 = 3.0;

/// Minimum distance from rest and bottom (m), since felts give way to a finger.
const AWAY: f64 = 0.7e-3;

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct PlaceWatch {
    place: f64,
    still: f64,
}

impl PlaceWatch {
    /// Adds a position (m), `elapsed` (s) after the last call.
    pub(super) fn take(&mut self, position: f64, elapsed: f64) {
        if (position - self.place).abs() <= STILLNESS {
            self.still += elapsed;
        } else {
            (self.place, self.still) = (position, 0.0);
        }
    }

    /// Returns `true` if a key with this `travel` (m) stands away from its ends.
    pub(super) fn is_misplaced(&self, travel: f64) -> bool {
        let nearest = self.place.abs().min((travel - self.place).abs());
        0.0 < travel && LONG <= self.still && AWAY < nearest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_key_that_stands_still_away_from_both_ends_is_misplaced() {
        let after = |position: f64, seconds: u32| {
            let mut watch = PlaceWatch::default();
            (0..1_000 * seconds).for_each(|_| watch.take(position, 1e-3));
            watch.is_misplaced(10.16e-3)
        };
        assert!(after(1e-3, 4) && after(-1e-3, 4) && after(12e-3, 4));
        assert!(!after(1e-3, 2) && !after(0.3e-3, 4) && !after(10.5e-3, 4));
    }
}
