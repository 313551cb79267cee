//! Times at which a damper leaves its string and falls back, lifted by the key at a model's height.

use instruments::Damper;
use scheduler::motion::{KeyEvent, Moment};

/// A damper that follows its key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DamperTracker {
    damper: Damper,
    lifted: bool,
    position: f64,
}

impl DamperTracker {
    /// Returns `damper` on the string, of a key at `position` (m): if that is beyond the
    /// lift height, the damper leaves the string in the first tick.
    pub const fn new(damper: Damper, position: f64) -> Self {
        Self { damper, lifted: false, position }
    }

    /// Keeps the state, on the string or off it, with the heights of `damper`.
    #[must_use]
    pub const fn with_damper(self, damper: Damper) -> Self {
        Self { damper, ..self }
    }

    /// Follows the key to `position` (m) at the start of `tick`, in ticks of `period` (s); returns
    /// the time at which it left the string or fell back since the tick before.
    pub fn follow(&mut self, tick: u64, position: f64, period: f64) -> Option<(Moment, KeyEvent)> {
        let before = std::mem::replace(&mut self.position, position);
        let Damper { lift, fall } = self.damper;
        let threshold = if self.lifted { fall } else { lift };
        let crossed = if self.lifted { position <= threshold } else { position > threshold };
        if !crossed {
            return None;
        }
        self.lifted = !self.lifted;
        // A key that begins down has not moved: the quotient is -∞, and θ is 0.
        let theta = ((threshold - before) / (position - before)).clamp(0.0, 1.0);
        let at = Moment { tick: tick.saturating_sub(1), theta };
        let event = if self.lifted {
            KeyEvent::DamperLift
        } else {
            KeyEvent::DamperFall { speed: ((before - position) / period).max(0.0) }
        };
        Some((at, event))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DAMPER: Damper = Damper { lift: 5.0e-3, fall: 4.6e-3 };

    #[test]
    fn it_lifts_and_falls_between_the_samples() {
        let mut damper = DamperTracker::new(DAMPER, 0.0);
        assert_eq!(damper.follow(1, 4.9e-3, 1e-3), None);
        let (at, event) = damper.follow(2, 5.1e-3, 1e-3).expect("a lift");
        assert_eq!((at.tick, event), (1, KeyEvent::DamperLift));
        assert!((at.theta - 0.5).abs() < 1e-9);
        assert_eq!(damper.follow(3, 4.7e-3, 1e-3), None, "within the hysteresis");
        let (at, event) = damper.follow(4, 4.5e-3, 1e-3).expect("a fall");
        assert!((at.theta - 0.5).abs() < 1e-9);
        let KeyEvent::DamperFall { speed } = event else { panic!("{event:?}") };
        assert!((speed - 0.2).abs() < 1e-9);
    }

    #[test]
    fn of_a_key_that_is_down_when_it_begins_it_lifts_at_once() {
        let mut damper = DamperTracker::new(DAMPER, 8e-3);
        let (at, event) = damper.follow(7, 8e-3, 1e-3).expect("a lift");
        assert_eq!((at, event), (Moment { tick: 6, theta: 0.0 }, KeyEvent::DamperLift));
        assert_eq!(damper.follow(8, 8e-3, 1e-3), None);
    }

    #[test]
    fn a_key_held_at_the_threshold_does_not_chatter() {
        let mut damper = DamperTracker::new(DAMPER, 0.0);
        let events = (0..1000)
            .zip(0_usize..)
            .filter_map(|(tick, n)| damper.follow(tick, 5.0e-3 + [0.0, 1e-5, -1e-5][n % 3], 1e-3));
        assert_eq!(events.count(), 1);
    }
}
