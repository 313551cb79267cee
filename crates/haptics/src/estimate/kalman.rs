//! A constant-acceleration Kalman filter with its steady-state gain.
//!
//! The gain is found at construction; an update is three predictions and three corrections.

use nalgebra::{Matrix3, RowVector3, Vector3};

use super::{Estimator, Motion, assert_positive};

/// Riccati iterations before the gain is taken as it is.
///
/// Convergence takes about ten times the filter's memory, in samples; this bound is only
/// reached by filters that remember more than ten thousand samples.
const MAX_ITERATIONS: usize = 200_000;

/// Relative change of the gain that counts as converged: some hundred roundings.
const CONVERGED: f64 = 1e-14;

/// Share of a quantum, as displacement per period, below which motion counts as rest.
///
/// A millionth of a count per period cannot be told from rest by any encoder.
const REST: f64 = 1e-6;

/// Steady-state Kalman filter of a point driven by white jerk.
///
/// State: position, velocity, acceleration. The measurement's variance is that of a
/// uniformly distributed rounding, quantum²/12. The position is kept as the difference to
/// the latest measurement, so a key that rests is estimated at exactly its measured place
/// with exactly zero velocity.
///
/// # References
///
/// `[BLK01]` §6.2.3 (white jerk, discretised) and §5.2.5 (steady state).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kalman {
    period: f64,
    /// Displacement per period [m] below which motion is rest.
    rest: f64,
    /// Corrections per metre of innovation [1, 1/s, 1/s²].
    gain: [f64; 3],
    measured: f64,
    /// Estimated minus measured position [m].
    offset: f64,
    velocity: f64,
    acceleration: f64,
}

impl Kalman {
    /// Jerk density of a played key [m²/s⁵]: 3e3 m/s³ that change every 10 ms (estimate).
    pub const KEY_JERK_DENSITY: f64 = 1e5;

    /// Creates a filter at rest at zero. Not for the tick: iterates the Riccati recursion.
    ///
    /// One sample each `period` [s], rounded to `quantum` [m]; `jerk_density` is the power
    /// spectral density of the jerk that drives the key [m²/s⁵], larger for a faster and
    /// noisier estimate ([`Self::KEY_JERK_DENSITY`] is a start).
    ///
    /// # Panics
    ///
    /// Unless all three are finite and positive.
    pub fn new(period: f64, quantum: f64, jerk_density: f64) -> Self {
        assert_positive(period, "period");
        assert_positive(quantum, "quantum");
        assert_positive(jerk_density, "jerk density");
        let [position, velocity, acceleration] =
            steady_gain(jerk_density * period.powi(5) / (quantum * quantum));
        Self {
            period,
            rest: REST * quantum,
            gain: [position, velocity / period, acceleration / (period * period)],
            measured: 0.0,
            offset: 0.0,
            velocity: 0.0,
            acceleration: 0.0,
        }
    }

    /// Returns the gains on position, velocity and acceleration [1, 1/s, 1/s²].
    pub const fn gain(&self) -> [f64; 3] {
        self.gain
    }

    /// Moves the state to the next sample, whose position is `measured` [m].
    fn predict(&mut self, measured: f64) {
        let h = self.period;
        self.offset += h * (self.velocity + 0.5 * h * self.acceleration);
        self.offset += self.measured - measured;
        self.velocity += h * self.acceleration;
        self.measured = measured;
    }

    /// Draws the state towards the measurement.
    fn correct(&mut self) {
        let innovation = -self.offset;
        self.offset += self.gain[0] * innovation;
        self.velocity += self.gain[1] * innovation;
        self.acceleration += self.gain[2] * innovation;
    }

    /// Ends the exponential decay before it reaches denormal numbers.
    fn settle(&mut self) {
        let h = self.period;
        let moves = self.offset.abs().max((h * self.velocity).abs());
        if moves.max((h * h * self.acceleration).abs()) < self.rest {
            self.offset = 0.0;
            self.velocity = 0.0;
            self.acceleration = 0.0;
        }
    }
}

impl Estimator for Kalman {
    fn update(&mut self, position: f64) -> Motion {
        self.predict(position);
        self.correct();
        self.settle();
        Motion {
            position: position + self.offset,
            velocity: self.velocity,
            acceleration: self.acceleration,
        }
    }

    fn reset(&mut self, position: f64) {
        self.measured = position;
        self.offset = 0.0;
        self.velocity = 0.0;
        self.acceleration = 0.0;
    }
}

/// Returns the steady gain in units of quantum and period.
///
/// In these units the filter has a single parameter, `ratio` = q T⁵ / Δ²: jerk density
/// against rounding. Iterates prediction and correction of the covariance.
fn steady_gain(ratio: f64) -> [f64; 3] {
    let transition = Matrix3::new(1.0, 1.0, 0.5, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0);
    let noise = ratio * white_jerk();
    let mut predicted = Matrix3::identity() + noise;
    let mut gain = Vector3::zeros();
    for _ in 0..MAX_ITERATIONS {
        let before = gain;
        gain = gain_of(&predicted);
        if (gain - before).component_div(&gain).amax() < CONVERGED {
            break;
        }
        let corrected = corrected(&predicted, &gain);
        let next = transition * corrected * transition.transpose() + noise;
        predicted = 0.5 * (next + next.transpose());
    }
    gain.into()
}

/// Covariance that unit white jerk adds over a unit period.
fn white_jerk() -> Matrix3<f64> {
    Matrix3::new(
        1.0 / 20.0,
        1.0 / 8.0,
        1.0 / 6.0,
        1.0 / 8.0,
        1.0 / 3.0,
        1.0 / 2.0,
        1.0 / 6.0,
        1.0 / 2.0,
        1.0,
    )
}

/// Optimal gain on a measured position, rounded to one unit.
fn gain_of(predicted: &Matrix3<f64>) -> Vector3<f64> {
    predicted.column(0) / (predicted[(0, 0)] + 1.0 / 12.0)
}

/// Covariance after a correction with the optimal gain.
fn corrected(predicted: &Matrix3<f64>, gain: &Vector3<f64>) -> Matrix3<f64> {
    let position = RowVector3::new(1.0, 0.0, 0.0);
    (Matrix3::identity() - gain * position) * predicted
}

#[cfg(test)]
mod tests {
    use super::super::BackwardDifference;
    use super::*;

    type Square = [[f64; 3]; 3];

    /// Product of two matrices.
    fn product(a: &Square, b: &Square) -> Square {
        let entry = |i: usize, j: usize| (0..3).map(|k| a[i][k] * b[k][j]).sum();
        core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)))
    }

    /// Transposed matrix.
    fn transposed(a: &Square) -> Square {
        core::array::from_fn(|i| core::array::from_fn(|j| a[j][i]))
    }

    /// Sum of two matrices, the second scaled.
    fn sum(a: &Square, scale: f64, b: &Square) -> Square {
        core::array::from_fn(|i| core::array::from_fn(|j| a[i][j] + scale * b[i][j]))
    }

    /// The steady gain again: SI units, plain arrays, Joseph's form, a fixed long iteration.
    fn joseph_gain(period: f64, quantum: f64, jerk_density: f64) -> [f64; 3] {
        let (t, r) = (period, quantum * quantum / 12.0);
        let f = [[1.0, t, t * t / 2.0], [0.0, 1.0, t], [0.0, 0.0, 1.0]];
        // Integral of the impulse response's outer product, by Gauss-Legendre of order 6,
        // exact for its polynomials of degree 4.
        let mut q = [[0.0; 3]; 3];
        for (node, weight) in [(-0.6_f64.sqrt(), 5.0), (0.0, 8.0), (0.6_f64.sqrt(), 5.0)] {
            let s = t * (1.0 + node) / 2.0;
            let response = [s * s / 2.0, s, 1.0];
            let scale = jerk_density * t / 2.0 * weight / 9.0;
            let outer = response.map(|a| response.map(|b| a * b));
            q = sum(&q, scale, &outer);
        }
        let mut p = [[1e-6, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1e4]];
        let mut gain = [0.0; 3];
        for _ in 0..50_000 {
            p = sum(&product(&product(&f, &p), &transposed(&f)), 1.0, &q);
            gain = core::array::from_fn(|i| p[i][0] / (p[0][0] + r));
            let [g0, g1, g2] = gain;
            let keep = [[1.0 - g0, 0.0, 0.0], [-g1, 1.0, 0.0], [-g2, 0.0, 1.0]];
            let outer = gain.map(|a| gain.map(|b| a * b));
            p = sum(&product(&product(&keep, &p), &transposed(&keep)), r, &outer);
        }
        gain
    }

    #[test]
    fn the_gain_is_that_of_josephs_iteration() {
        for (period, quantum, density) in
            [(1e-3, 1e-6, 1e5), (1e-3, 1e-5, 100.0), (1e-4, 1e-6, 1e5), (7e-3, 3e-4, 1.0)]
        {
            let expected = joseph_gain(period, quantum, density);
            for (got, want) in Kalman::new(period, quantum, density).gain().iter().zip(expected) {
                // Covariances with a condition number up to 1e6 lose six of sixteen digits.
                assert!((got / want - 1.0).abs() < 1e-9, "{got} against {want}");
            }
        }
    }

    /// Root mean square velocity error [m/s] on a sine of 5 mm at 2 Hz, counted in 10 µm.
    fn velocity_error(mut estimator: impl Estimator) -> f64 {
        let (quantum, omega) = (1e-5, core::f64::consts::TAU * 2.0);
        let mut sum = 0.0;
        for tick in 0..3000_u32 {
            let phase = omega * f64::from(tick) * 1e-3;
            let counts = (5e-3 * phase.sin() / quantum).round();
            let error = estimator.update(counts * quantum).velocity - 5e-3 * omega * phase.cos();
            // The first second is the transient from rest.
            sum += if tick < 1000 { 0.0 } else { error * error };
        }
        (sum / 2000.0).sqrt()
    }

    #[test]
    fn on_a_quantised_sine_it_is_eight_times_better_than_differences() {
        // Jerk 10 m/s³ · cos, which changes over about 0.1 s: density 100/2 · 0.1 m²/s⁵.
        let kalman = velocity_error(Kalman::new(1e-3, 1e-5, 5.0));
        let difference = velocity_error(BackwardDifference::new(1e-3));
        // A uniform rounding of two positions: Δ √(2/12) / T = 4.1 mm/s, lag aside.
        assert!((difference / 4.1e-3 - 1.0).abs() < 0.1, "{difference}");
        assert!(8.0 * kalman < difference, "{kalman} against {difference}");
    }

    #[test]
    fn a_key_that_rests_is_estimated_exactly_at_rest() {
        let mut estimator = Kalman::new(1e-3, 1e-6, Kalman::KEY_JERK_DENSITY);
        for tick in 0..20_u32 {
            estimator.update(f64::from(tick) * 5e-4);
        }
        let rest = 0.012_345_678;
        // Its memory is a few samples; a thousand are forever.
        for _ in 0..1000 {
            estimator.update(rest);
        }
        assert_eq!(estimator.update(rest), Motion::at_rest(rest));
    }

    #[test]
    fn uniform_acceleration_is_followed_without_bias() {
        let mut estimator = Kalman::new(1e-3, 1e-6, Kalman::KEY_JERK_DENSITY);
        let mut motion = Motion::at_rest(0.0);
        for tick in 0..200_u32 {
            let t = f64::from(tick) * 1e-3;
            motion = estimator.update(0.5 * 3.0 * t * t);
        }
        // The model is exact; what is left is rounding of 0.06 m against T and T².
        assert!((motion.velocity - 3.0 * 0.199).abs() < 1e-12, "{motion:?}");
        assert!((motion.acceleration - 3.0).abs() < 1e-9, "{motion:?}");
    }

    #[test]
    fn after_a_reset_the_key_rests_there() {
        let mut estimator = Kalman::new(1e-3, 1e-6, Kalman::KEY_JERK_DENSITY);
        estimator.update(0.01);
        estimator.reset(0.004);
        assert_eq!(estimator.update(0.004), Motion::at_rest(0.004));
    }
}
