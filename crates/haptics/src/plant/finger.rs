//! The simulated finger: a small mass on a muscle's spring, with a soft pulp.

use super::gesture::MuscleCommand;

/// Height of an absent finger (m): well above any key.
const AWAY: f64 = 20e-3;

/// Commanded speeds at which a finger starts to stiffen, and is stiffest (m/s).
const BRACED: (f64, f64) = (3.0, 6.0);

/// Ratio of stiffness and damping of a braced finger: the stiff corner of fingers.
const BRACED_STIFFNESS: f64 = 1300.0 / 400.0;
const BRACED_DAMPING: f64 = 7.0 / 4.0;

/// Grasp of a finger.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grasp {
    /// Lies on the key: pushes and never pulls.
    Pushes,
    /// Holds the key on both sides, as in the paper's experiment: pushes and pulls. `[GC93]` §6
    Grips,
}

/// Action of a hand on a key between gestures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HandCommand {
    /// Lies on the key with a force (N); 0 is away.
    Weight(f64),
    /// Grips the key and leads it to this depth, as a fraction of the key's dip.
    Grip(f64),
}

impl HandCommand {
    pub const AWAY: Self = Self::Weight(0.0);
}

/// Constants of a finger: mass (kg), damping (N s/m), stiffness (N/m), and those of its pulp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FingerParameters {
    pub mass: f64,
    pub damping: f64,
    pub stiffness: f64,
    pub pulp_stiffness: f64,
    pub pulp_damping: f64,
    pub grasp: Grasp,
}

impl FingerParameters {
    /// Ordinary finger; an estimate, ± 50 %, the pulp too.
    pub const ORDINARY: Self = Self {
        mass: 6e-3,
        damping: 4.0,
        stiffness: 400.0,
        pulp_stiffness: 4e3,
        pulp_damping: 3.0,
        grasp: Grasp::Pushes,
    };

    /// Stiff corner of fingers; an estimate.
    pub const STIFF: Self = Self { damping: 7.0, stiffness: 1300.0, ..Self::ORDINARY };

    /// Hand and forearm that hold a handle between thumb and fingers; an estimate.
    pub const GRIP: Self = Self {
        mass: 0.2,
        damping: 30.0,
        stiffness: 1500.0,
        pulp_stiffness: 10e3,
        pulp_damping: 20.0,
        grasp: Grasp::Grips,
    };

    /// Limp corner of fingers; an estimate.
    pub const LIMP: Self = Self { damping: 0.3, stiffness: 20.0, ..Self::ORDINARY };

    /// Returns the finger at `speed` (m/s), stiffened by the arm from 3 to 6 m/s, up to 3.25 times.
    ///
    /// # Real-time
    /// No division, no loop.
    #[must_use]
    pub fn braced(self, speed: f64) -> Self {
        const PER_SPEED: f64 = 1.0 / (BRACED.1 - BRACED.0);
        let part = ((speed - BRACED.0) * PER_SPEED).clamp(0.0, 1.0);
        Self {
            stiffness: self.stiffness * (1.0 + part * (BRACED_STIFFNESS - 1.0)),
            damping: self.damping * (1.0 + part * (BRACED_DAMPING - 1.0)),
            ..self
        }
    }
}

impl Default for FingerParameters {
    fn default() -> Self {
        Self::ORDINARY
    }
}

/// State of a fingertip, down positive (m, m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finger {
    parameters: FingerParameters,
    braced: FingerParameters,
    position: f64,
    velocity: f64,
}

impl Finger {
    /// Creates an ordinary finger at rest, 20 mm above the key.
    pub const fn away() -> Self {
        Self::new(FingerParameters::ORDINARY)
    }

    /// Creates a finger at rest, 20 mm above the key.
    pub const fn new(parameters: FingerParameters) -> Self {
        Self { parameters, braced: parameters, position: -AWAY, velocity: 0.0 }
    }

    pub const fn position(&self) -> f64 {
        self.position
    }

    pub const fn velocity(&self) -> f64 {
        self.velocity
    }

    /// Moves the finger to the commanded state, braced for a gesture at `speed` (m/s).
    pub(super) fn place(&mut self, command: MuscleCommand, speed: f64) {
        self.braced = self.parameters.braced(speed);
        self.position = command.position;
        self.velocity = command.velocity;
    }

    pub(super) const fn leave(&mut self) {
        *self = Self::new(self.parameters);
    }

    /// Returns the contact force (N) with a key at `position` (m) and `velocity` (m/s): up on the
    /// finger, down on the key, negative only where the finger grips and pulls the key up.
    pub fn contact(&self, position: f64, velocity: f64) -> f64 {
        let FingerParameters { pulp_stiffness, pulp_damping, grasp, .. } = self.braced;
        let depth = self.position - position;
        if grasp == Grasp::Pushes && depth <= 0.0 {
            return 0.0;
        }
        let rate = self.velocity - velocity;
        let force = pulp_stiffness * depth + pulp_damping * rate;
        match grasp {
            Grasp::Pushes => force.max(0.0),
            Grasp::Grips => force,
        }
    }

    /// Advances by one substep `h` (s) towards the commanded `position` (m) and `velocity` (m/s),
    /// against the `contact` force (N). Semi-implicit Euler, stable for any stiffness.
    ///
    /// # Real-time
    /// One division; no loop.
    pub fn step(&mut self, position: f64, velocity: f64, contact: f64, h: f64) {
        let FingerParameters { mass, damping, stiffness, .. } = self.braced;
        let muscle = stiffness * (position - self.position) + damping * velocity;
        let impulse = mass * self.velocity + h * (muscle - contact);
        self.velocity = impulse / (mass + h * (damping + h * stiffness));
        self.position += h * self.velocity;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_finger_is_braced_for_forte_alone_and_no_stiffer_than_the_stiff_corner() {
        let ordinary = FingerParameters::ORDINARY;
        assert_eq!(ordinary.braced(3.0), ordinary);
        assert_eq!(ordinary.braced(f64::NAN.max(0.02)), ordinary);
        assert_eq!(ordinary.braced(6.0), FingerParameters::STIFF);
        assert_eq!(ordinary.braced(20.0), FingerParameters::STIFF);
        let half = ordinary.braced(4.5);
        assert!((half.stiffness - 850.0).abs() < 1e-9 && (half.damping - 5.5).abs() < 1e-12);
    }

    #[test]
    fn its_way_to_a_new_command_is_that_of_an_overdamped_spring() {
        let error = |steps: u32| {
            let (mut finger, t) = (Finger::away(), 0.01);
            (0..steps).for_each(|_| finger.step(0.0, 0.0, 0.0, t / f64::from(steps)));
            // Roots of m s² + c s + k; from −20 mm at rest.
            let (middle, product) = (4.0 / (2.0 * 6e-3), 400.0 / 6e-3);
            let spread = f64::sqrt(middle * middle - product);
            let (slow, fast) = (middle - spread, middle + spread);
            let decay = fast * (-slow * t).exp() - slow * (-fast * t).exp();
            finger.position() + AWAY * decay / (fast - slow)
        };
        let order = (error(400) / error(800)).abs().log2();
        assert!((order - 1.0).abs() < 0.05, "observed order {order}");
        assert!(error(800).abs() < 1e-4);
    }
}
