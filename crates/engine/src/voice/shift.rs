//! Slow shift of a model's key to the position that new settings or a pause require.

use pode::input::Cubic;
use pode::{Motion, Signal as _};

/// Duration of a shift after a change of settings (s): too slow to throw a hammer.
const FADE: f64 = 0.3;

/// Duration of a shift after a pause (s). A whole stroke sounds at medium loudness; a stroke that
/// was nearly complete at the pause sounds hardly louder than it would have.
const CATCH_UP: f64 = 30e-3;

/// Displacement of a model's key from the player's, after a change.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct InputShift {
    /// Displacement at the change (model input).
    whole: f64,
    /// Remaining fraction, 1 to 0.
    left: f64,
    /// Duration of the shift (s).
    fade: f64,
}

impl InputShift {
    pub(crate) const fn new(displacement: f64) -> Self {
        Self { whole: displacement, left: 1.0, fade: FADE }
    }

    /// Returns a shift by the `displacement` (model input) in a pause; a note in it is late.
    pub(crate) const fn after_pause(displacement: f64) -> Self {
        Self { fade: CATCH_UP, ..Self::new(displacement) }
    }

    /// Returns the remaining displacement (model input).
    pub(crate) fn now(&self) -> f64 {
        self.whole * self.left
    }

    /// Returns the motion `key` over a tick of `h` (s), shifted.
    ///
    /// # Real-time
    /// One evaluation of the motion, if some displacement is left.
    pub(crate) fn follow(&mut self, key: Cubic, h: f64) -> Cubic {
        let before = self.now();
        if before == 0.0 {
            return key;
        }
        self.left = (self.left - h / self.fade).max(0.0);
        let Motion { position, rate, acceleration, jerk } = key.at(0.0);
        let moved = h * rate + self.now() - before;
        Cubic::new(
            [position + before, moved, h * h * acceleration / 2.0, h * h * h * jerk / 6.0],
            h,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shift_goes_evenly_and_leaves_the_motion_as_it_is() {
        let h = 1e-3;
        let mut shift = InputShift::new(2e-3);
        for tick in 0..320_u32 {
            let key = Cubic::ballistic(0.1, 0.5, -3.0, h);
            let moved = shift.follow(key, h);
            for theta in [0.0, 0.5, 1.0] {
                let left = (1.0 - (f64::from(tick) + theta) / 300.0).max(0.0);
                let way = moved.at(theta).position - key.at(theta).position;
                // 300 subtractions of numbers below 1.
                assert!((way - 2e-3 * left).abs() < 1e-14, "tick {tick}: {way}");
            }
        }
        let key = Cubic::ballistic(0.1, 0.5, -3.0, h);
        assert_eq!(shift.follow(key, h), key);
    }
}
