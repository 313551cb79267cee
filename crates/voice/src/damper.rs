//! When a key's damper leaves the string and falls back on it.
//!
//! Models A and B have no damper; the key itself lifts it, at half stroke, where the
//! hammer of a grand is at half blow (piano-facts).

use scheduler::motion::{KeyEvent, Moment};

/// Key-front travel at which the damper leaves the string [m]: half of the dip (S).
const LIFT: f64 = 5.0e-3;

/// Travel at which it is back on the string (m). The hysteresis is hundreds of encoder
/// counts, so that a key held at the threshold does not chatter.
const FALL: f64 = 4.6e-3;

/// A damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DamperTracker {
    lifted: bool,
    position: f64,
}

impl DamperTracker {
    /// On the string or off it, by the key's position (m).
    pub const fn new(position: f64) -> Self {
        Self { lifted: position > LIFT, position }
    }

    /// Follows the key to `position` (m) at the start of `tick`; `period` in (s).
    pub fn follow(&mut self, tick: u64, position: f64, period: f64) -> Option<(Moment, KeyEvent)> {
        let before = std::mem::replace(&mut self.position, position);
        let threshold = if self.lifted { FALL } else { LIFT };
        let crossed = if self.lifted { position <= threshold } else { position > threshold };
        if !crossed {
            return None;
        }
        self.lifted = !self.lifted;
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

    #[test]
    fn it_lifts_and_falls_between_the_samples() {
        let mut damper = DamperTracker::new(0.0);
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
    fn a_key_held_at_the_threshold_does_not_chatter() {
        let mut damper = DamperTracker::new(0.0);
        let events = (0..1000)
            .zip(0_usize..)
            .filter_map(|(tick, n)| damper.follow(tick, 5.0e-3 + [0.0, 1e-5, -1e-5][n % 3], 1e-3));
        assert_eq!(events.count(), 1);
    }
}
