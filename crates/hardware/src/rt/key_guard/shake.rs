//! A force that goes to and fro many times in a twentieth of a second is no action's, whatever the
//! model is: the loop of host, board and key has become unstable.

/// Least force that counts (N).
const LEAST: f64 = 1.0;

/// Changes of its sign that are too many.
const MOST_CHANGES: usize = 10;

/// The time within which they count (s).
const WINDOW: f64 = 0.05;

/// When a force changed its sign of late.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ShakeWatch {
    /// Time since each of the newest changes (s), the newest first, and how many there were.
    ages: [f64; MOST_CHANGES],
    n: usize,
    is_up: bool,
}

impl ShakeWatch {
    /// Takes `force` (N), `elapsed` (s) after the one before; returns whether it shakes, and begins
    /// again if it does.
    ///
    /// # Real-time
    /// Ten additions while there are changes.
    pub(super) fn is_shaking(&mut self, force: f64, elapsed: f64) -> bool {
        self.ages[..self.n].iter_mut().for_each(|age| *age += elapsed);
        while self.n.checked_sub(1).is_some_and(|last| WINDOW < self.ages[last]) {
            self.n -= 1;
        }
        let is_up = 0.0 < force;
        if force.abs() < LEAST || is_up == self.is_up {
            return false;
        }
        self.is_up = is_up;
        if self.n == MOST_CHANGES {
            self.n = 0;
            return true;
        }
        self.ages.rotate_right(1);
        self.ages[0] = 0.0;
        self.n += 1;
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// How often within a second a sine of `hz` (1/s) and `newtons` counts as shaking.
    fn shakes(hz: f64, newtons: f64) -> usize {
        let mut watch = ShakeWatch::default();
        let force = |n: u32| newtons * (TAU * hz * f64::from(n) * 1e-3).sin();
        (0..1000).filter(|n| watch.is_shaking(force(*n), 1e-3)).count()
    }

    #[test]
    fn a_loop_that_swings_shakes_and_a_tremolo_does_not() {
        assert!(0 < shakes(180.0, 15.0));
        assert!(0 < shakes(125.0, 1.5));
        assert_eq!(shakes(180.0, 0.9), 0, "too soft to count");
        assert_eq!(shakes(80.0, 15.0), 0, "eight changes in a twentieth of a second");
    }
}
