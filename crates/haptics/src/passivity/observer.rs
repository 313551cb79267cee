/// Bound on the energy that a voice may return.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyBound {
    /// Energy that an action may store and return (J).
    pub stored: f64,
    /// Power that sampling and rounding may add unfelt (W).
    pub leak: f64,
}

impl EnergyBound {
    /// Power of sampling and rounding at a key (W). Instruments that come to rest generate less
    /// than 5 mW (measured, 500 Hz to 10 kHz); loops that do not, 30 mW and more.
    const LEAK: f64 = 20e-3;

    /// Returns the bound of a key with a force of at most `limit` (N), over its whole `dip` (m).
    pub fn of_force_limit(limit: f64, dip: f64) -> Self {
        Self { stored: limit * dip, leak: Self::LEAK }
    }
}

/// Adds up the energy that flows through a key's port, force held and position sampled.
///
/// Between two samples the force is constant, so its work is exactly force times displacement.
/// The largest fall of that sum since any earlier time is the returned energy. A passive action
/// never returns more than it stores, whatever moves the key. Without a finger the motor alone
/// moves it, and the sum shows the energy that a loop of estimator, model and motor generates.
///
/// The observer of `[HR02]`, for one port, without the controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PassivityObserver {
    /// Energy that may be returned (J).
    stored: f64,
    /// Energy that may be generated in a tick (J).
    leak: f64,
    /// Fall of the sum below its highest value, less the leak (J).
    returned: f64,
    /// Last tick, with its position (m) and force (N).
    last: Option<(u64, f64, f64)>,
}

impl PassivityObserver {
    /// Creates an observer of ticks of `period` (s).
    pub const fn new(bound: EnergyBound, period: f64) -> Self {
        Self { stored: bound.stored, leak: bound.leak * period, returned: 0.0, last: None }
    }

    /// Returns `true` if all energy returned until `tick`, at `position` (m), can have been put in.
    /// Adds the work since the previous tick if [`Self::hold`] recorded its force.
    ///
    /// # Real-time
    /// Six operations.
    pub fn is_passive(&mut self, tick: u64, position: f64) -> bool {
        if let Some((_, before, force)) = self.last.filter(|(last, ..)| last + 1 == tick) {
            // Forces are positive up and positions down: work on the voice.
            let supplied = force * (position - before);
            self.returned = (self.returned - supplied - self.leak).max(0.0);
        }
        self.returned <= self.stored
    }

    /// Records that `force` (N) is held over `tick`, with the key at `position` (m) at its start.
    pub const fn hold(&mut self, tick: u64, position: f64, force: f64) {
        self.last = Some((tick, position, force));
    }

    /// Resets after a change of action or finger, or after a gap.
    pub const fn reset(&mut self) {
        (self.returned, self.last) = (0.0, None);
    }

    /// Returns the energy returned beyond the input (J).
    pub const fn returned(&self) -> f64 {
        self.returned
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 1e-3;

    fn observer(stored: f64) -> PassivityObserver {
        PassivityObserver::new(EnergyBound { stored, leak: 0.0 }, H)
    }

    fn swinging(tick: u64) -> f64 {
        5e-3 - 5e-3 * (OMEGA * tick as f64 * H).cos()
    }

    const OMEGA: f64 = 18.85;

    #[test]
    fn a_spring_gives_back_what_it_took_and_a_little_more_because_it_is_held() {
        const STIFFNESS: f64 = 500.0;
        let mut observer = observer(1.0);
        for tick in 0..1000 {
            let x = swinging(tick);
            assert!(observer.is_passive(tick, x));
            observer.hold(tick, x, STIFFNESS * x);
        }
        // Held over H, it is late by H / 2 and returns K H / 2 times the integral of v^2, which is
        // A^2 W pi in each of three periods. Rounded up for the energy stored at the end.
        let per_period = 0.5 * STIFFNESS * H * 25e-6 * OMEGA * core::f64::consts::PI;
        let returned = observer.returned();
        let stored = 0.5 * STIFFNESS * 1e-4;
        assert!((2.9 * per_period..stored + 3.1 * per_period).contains(&returned), "{returned} J");
    }

    #[test]
    fn a_damper_gives_nothing_back() {
        let mut observer = observer(1.0);
        let mut last = 0.0;
        for tick in 0..3000 {
            let x = swinging(tick);
            assert!(observer.is_passive(tick, x));
            observer.hold(tick, x, 0.5 * (x - last) / H);
            last = x;
        }
        // It reverses within one tick, its only delay.
        assert!(observer.returned() < 1e-5, "{} J", observer.returned());
    }

    #[test]
    fn a_key_that_its_motor_bangs_is_caught_within_a_stroke() {
        let mut observer = PassivityObserver::new(EnergyBound::of_force_limit(25.0, 10e-3), H);
        let mut position = 0.0;
        let caught = (0..2000).find(|&tick| {
            let is_passive = observer.is_passive(tick, position);
            let down = tick / 50 % 2 == 0;
            observer.hold(tick, position, if down { -25.0 } else { 25.0 });
            position += if down { 0.2e-3 } else { -0.2e-3 };
            !is_passive
        });
        // 0.25 J are stored after the first stroke down; the leak is then 2.5 mJ.
        assert!(caught.is_some_and(|tick| tick <= 52), "{caught:?}");
    }

    #[test]
    fn what_a_finger_gave_long_ago_is_no_credit() {
        let mut observer = observer(0.1);
        observer.hold(0, 0.0, 20.0);
        assert!(observer.is_passive(1, 1.0), "20 J were put in");
        observer.hold(1, 1.0, 20.0);
        assert!(!observer.is_passive(2, 0.99), "0.2 J of them came back");
    }

    #[test]
    fn ticks_that_were_skipped_and_actions_that_were_replaced_are_not_counted() {
        let mut observer = observer(0.1);
        observer.hold(0, 0.01, 25.0);
        assert!(observer.is_passive(2, 0.0));
        observer.hold(2, 0.01, 25.0);
        observer.reset();
        assert!(observer.is_passive(3, 0.0));
        assert!(observer.returned() == 0.0);
    }
}
