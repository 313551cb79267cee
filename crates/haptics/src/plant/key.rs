//! The simulated key: a mass with friction that truly sticks, between two felts.

use super::felt::{Felt, FeltSide, Resistance};

/// Constants of a key at its front: moving mass (kg), viscous damping (N s/m), forces and felts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyParameters {
    pub mass: f64,
    pub damping: f64,
    /// Friction while moving (N).
    pub coulomb: f64,
    /// Friction that holds a key at rest (N); at least `coulomb` is used.
    pub stiction: f64,
    /// Constant load (N), up positive: above zero the unpowered key rises to its rest.
    pub weight: f64,
    pub rest_stop: Felt,
    pub bottom_stop: Felt,
}

/// State of a key's front, down positive (m, m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyFront {
    parameters: KeyParameters,
    position: f64,
    velocity: f64,
}

impl KeyFront {
    /// Creates a key at rest, touching its rest felt.
    pub const fn new(parameters: KeyParameters) -> Self {
        let KeyParameters { rest_stop, weight, .. } = parameters;
        let depth = weight.max(0.0) / rest_stop.stiffness;
        Self::placed(parameters, rest_stop.position - depth, 0.0)
    }

    /// Creates a key at `position` (m) moving with `velocity` (m/s).
    pub const fn placed(parameters: KeyParameters, position: f64, velocity: f64) -> Self {
        Self { parameters, position, velocity }
    }

    /// Returns the travel from rest to bottom (m).
    pub const fn dip(&self) -> f64 {
        self.parameters.bottom_stop.position
    }

    pub const fn position(&self) -> f64 {
        self.position
    }

    /// Returns the velocity (m/s); exactly zero while stuck.
    pub const fn velocity(&self) -> f64 {
        self.velocity
    }

    /// Advances by one substep `h` (s) under the outer `force` (N), up positive. Semi-implicit
    /// Euler of order 1; without outer force, energy never grows.
    ///
    /// # Real-time
    /// Two divisions; no loop.
    pub fn step(&mut self, force: f64, h: f64) {
        self.velocity = self.next_velocity(force, h);
        self.position += h * self.velocity;
    }

    /// Returns `true` if the key is stuck and stays so under the outer `force` (N), up positive.
    pub fn holds(&self, force: f64) -> bool {
        self.velocity == 0.0 && self.breakaway(force).is_none()
    }

    /// Returns the velocity after a substep (m/s); zero if friction catches the key.
    fn next_velocity(&self, force: f64, h: f64) -> f64 {
        let direction = if self.velocity == 0.0 {
            match self.breakaway(force) {
                Some(direction) => direction,
                None => return 0.0,
            }
        } else {
            self.velocity.signum()
        };
        let velocity = self.sliding_velocity(force, direction, h);
        // Friction stops motion, it does not reverse it.
        if 0.0 < velocity * direction { velocity } else { 0.0 }
    }

    /// Returns the direction in which a key at rest starts to move, down positive, if it does.
    fn breakaway(&self, force: f64) -> Option<f64> {
        let net = self.resistance(0.0).holding() - force - self.parameters.weight;
        let grip = self.parameters.stiction.max(self.parameters.coulomb);
        (grip < net.abs()).then(|| net.signum())
    }

    fn sliding_velocity(&self, force: f64, direction: f64, h: f64) -> f64 {
        let constants = &self.parameters;
        let push = -(force + constants.weight + direction * constants.coulomb);
        let inertia = constants.mass + h * constants.damping;
        let momentum = constants.mass * self.velocity;
        self.resistance(h).solve(inertia, momentum + h * push, h)
    }

    fn resistance(&self, h: f64) -> Resistance {
        let KeyParameters { rest_stop, bottom_stop, .. } = &self.parameters;
        if self.position - rest_stop.position < bottom_stop.position - self.position {
            rest_stop.resistance(FeltSide::Rest, self.position, h)
        } else {
            bottom_stop.resistance(FeltSide::Bottom, self.position, h)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 5e-5;

    /// Returns a key of 50 g between undamped felts, without friction.
    fn free_key() -> KeyParameters {
        let felt = |position| Felt { position, stiffness: 6e4, damping: 0.0 };
        KeyParameters {
            mass: 0.05,
            damping: 0.0,
            coulomb: 0.0,
            stiction: 0.0,
            weight: 0.0,
            rest_stop: felt(0.0),
            bottom_stop: felt(0.01),
        }
    }

    /// Returns a free key with 0.10 N of friction and 0.12 N of stiction.
    fn rough_key() -> KeyParameters {
        KeyParameters { coulomb: 0.10, stiction: 0.12, ..free_key() }
    }

    fn energy(key: &KeyFront) -> f64 {
        let constants = &key.parameters;
        let high = (constants.rest_stop.position - key.position).max(0.0);
        let deep = (key.position - constants.bottom_stop.position).max(0.0);
        0.5 * constants.mass * key.velocity * key.velocity
            + 0.5 * constants.rest_stop.stiffness * high * high
            + 0.5 * constants.bottom_stop.stiffness * deep * deep
            + constants.weight * key.position
    }

    #[test]
    fn a_stuck_key_stays_exactly_put_below_stiction() {
        let mut key = KeyFront::placed(rough_key(), 0.004, 0.0);
        let before = key;
        for force in [0.119, -0.119].repeat(5000) {
            assert!(key.holds(force));
            key.step(force, H);
        }
        assert_eq!(key, before);
    }

    #[test]
    fn above_stiction_it_breaks_free_and_friction_drops() {
        for sign in [1.0, -1.0] {
            let mut key = KeyFront::placed(rough_key(), 0.004, 0.0);
            assert!(!key.holds(sign * 0.121));
            key.step(sign * 0.121, H);
            let expected = -sign * H * (0.121 - 0.10) / 0.05;
            assert!((key.velocity() / expected - 1.0).abs() < 1e-12, "{}", key.velocity());
        }
    }

    #[test]
    fn friction_stops_a_sliding_key_where_its_energy_is_spent() {
        let (mut key, speed) = (KeyFront::placed(rough_key(), 0.001, 0.1), 0.1_f64);
        for _ in 0..2000 {
            key.step(0.0, H);
        }
        let path = 0.05 * speed * speed / (2.0 * 0.10);
        // Order 1: errs by half a substep at the initial speed, and stops within one.
        assert!(key.holds(0.0));
        assert!((key.position() - 0.001 - path).abs() < speed * H, "{}", key.position());
    }

    #[test]
    fn a_damped_fall_converges_to_the_closed_form_at_order_one() {
        let error = |steps: u32| {
            let damped = KeyParameters { damping: 2.0, weight: -0.5, ..free_key() };
            let mut key = KeyFront::new(damped);
            let t = 0.02;
            (0..steps).for_each(|_| key.step(0.0, t / f64::from(steps)));
            let (tau, terminal) = (0.05 / 2.0, 0.5 / 2.0);
            key.position() - terminal * (t - tau * (1.0 - (-t / tau).exp()))
        };
        let order = (error(400) / error(800)).abs().log2();
        assert!((order - 1.0).abs() < 0.02, "observed order {order}");
    }

    #[test]
    fn the_energy_of_a_key_that_bounces_never_grows() {
        let damped = Felt { damping: 30.0, ..free_key().bottom_stop };
        let hard = Felt { stiffness: 1e7, ..free_key().bottom_stop };
        let loaded = KeyParameters { weight: -0.5, ..free_key() };
        for parameters in [
            free_key(),
            rough_key(),
            KeyParameters { bottom_stop: damped, ..free_key() },
            KeyParameters { bottom_stop: hard, ..free_key() },
        ] {
            check_energy(parameters, 1.0, 20_000);
        }
        check_energy(loaded, 0.0, 200);
    }

    #[track_caller]
    fn check_energy(parameters: KeyParameters, speed: f64, steps: u32) {
        let mut key = KeyFront::placed(parameters, 0.005, speed);
        let mut before = energy(&key);
        for _ in 0..steps {
            key.step(0.0, H);
            let after = energy(&key);
            assert!(after <= before * (1.0 + 8.0 * f64::EPSILON), "{after} after {before}");
            before = after;
        }
    }

    #[test]
    fn a_bounce_on_a_lossless_felt_takes_half_a_period_of_its_oscillation() {
        let mut key = KeyFront::placed(free_key(), 0.01, 0.2);
        let h = 1e-6;
        let mut contact = 0.0;
        for _ in 0..100_000 {
            key.step(0.0, h);
            if 0.01 < key.position() {
                contact += h;
            }
        }
        let half_period = core::f64::consts::PI * (0.05_f64 / 6e4).sqrt();
        // The key returns after 0.1 s. Order 1: entry and exit each err by a substep.
        assert!((contact - half_period).abs() < 2.0 * h, "{contact}, expected {half_period}");
    }
}
