//! A constant-acceleration Kalman filter.
//!
//! As long as samples come once a period it has its steady gain, which is found at construction:
//! an update is three predictions and three corrections. A sample that comes sooner or later is
//! worth less or more, so the covariance is followed from there until it is steady again; with
//! the steady gain the filter would be unstable where every third sample is late.

use nalgebra::{Matrix3, RowVector3, Vector3};

use super::{Estimator, KeyMotion, assert_positive};

/// Riccati iterations before the gain is taken as it is.
///
/// Convergence takes about ten times the filter's memory, in samples; this bound is only
/// reached by filters that remember more than ten thousand samples.
const MAX_ITERATIONS: usize = 200_000;

/// Relative change of the gain that counts as converged: some hundred roundings.
const CONVERGED: f64 = 1e-14;

/// Relative difference to the steady gain that is none.
const STEADY: f64 = 1e-9;

/// Longest time between two samples that is told apart, in periods: its covariance says already
/// that nothing is known but the new position.
const FORGOTTEN: f64 = 1e4;

/// Share of a quantum, as displacement per period, below which motion counts as rest.
///
/// A millionth of a count per period cannot be told from rest by any encoder.
const REST: f64 = 1e-6;

/// Kalman filter of a point driven by white jerk.
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
    /// Displacement per period (m) below which motion is rest.
    rest: f64,
    /// Corrections per metre of innovation when samples come regularly (1, 1/s, 1/s²).
    gain: [f64; 3],
    /// q T⁵ / Δ².
    ratio: f64,
    /// Covariance after a correction when samples come regularly, in units of quantum and period.
    steady: Matrix3<f64>,
    /// The same now, if it is not that.
    unsteady: Option<Matrix3<f64>>,
    measured: f64,
    /// Estimated minus measured position (m).
    offset: f64,
    velocity: f64,
    acceleration: f64,
}

impl Kalman {
    /// Jerk density of a played key (m²/s⁵): 3e3 m/s³ that change every 10 ms (estimate).
    pub const KEY_JERK_DENSITY: f64 = 1e5;

    /// Creates a filter at rest at zero. Not for the tick: iterates the Riccati recursion.
    ///
    /// One sample each `period` (s), rounded to `quantum` (m); `jerk_density` is the power
    /// spectral density of the jerk that drives the key (m²/s⁵), larger for a faster and
    /// noisier estimate ([`Self::KEY_JERK_DENSITY`] is a start).
    ///
    /// # Panics
    ///
    /// Unless all three are finite and positive.
    pub fn new(period: f64, quantum: f64, jerk_density: f64) -> Self {
        assert_positive(period, "period");
        assert_positive(quantum, "quantum");
        assert_positive(jerk_density, "jerk density");
        let ratio = jerk_density * period.powi(5) / (quantum * quantum);
        let (gain, steady) = steady_gain(ratio);
        Self {
            period,
            rest: REST * quantum,
            gain: per_seconds(&gain, period),
            ratio,
            steady,
            unsteady: None,
            measured: 0.0,
            offset: 0.0,
            velocity: 0.0,
            acceleration: 0.0,
        }
    }

    /// Returns the steady gains on position, velocity and acceleration (1, 1/s, 1/s²).
    pub const fn gain(&self) -> [f64; 3] {
        self.gain
    }

    /// Returns the gain for a sample `elapsed` (s) after the last one.
    #[inline]
    fn next_gain(&mut self, elapsed: f64) -> [f64; 3] {
        let periods = (elapsed / self.period).min(FORGOTTEN);
        if is_regular(periods) && self.unsteady.is_none() {
            return self.gain;
        }
        self.unsteady_gain(periods)
    }

    /// Returns the gain for a sample this many `periods` after the last one, and follows the
    /// covariance.
    #[inline(never)]
    fn unsteady_gain(&mut self, periods: f64) -> [f64; 3] {
        let before = self.unsteady.as_ref().unwrap_or(&self.steady);
        let predicted = predicted(before, self.ratio, periods);
        let gain = gain_of(&predicted);
        let after = corrected(&predicted, &gain);
        let gain = per_seconds(&gain, self.period);
        let is_steady = gain.iter().zip(self.gain).all(|(a, b)| (a - b).abs() < STEADY * b);
        self.unsteady =
            (!is_regular(periods) || !is_steady).then_some(0.5 * (after + after.transpose()));
        gain
    }

    /// Moves the state to the next sample, `h` (s) later, whose position is `measured` (m).
    #[inline]
    fn predict(&mut self, measured: f64, h: f64) {
        self.offset += h * (self.velocity + 0.5 * h * self.acceleration);
        self.offset += self.measured - measured;
        self.velocity += h * self.acceleration;
        self.measured = measured;
    }

    /// Draws the state towards the measurement.
    #[inline]
    fn correct(&mut self, [position, velocity, acceleration]: [f64; 3]) {
        let innovation = -self.offset;
        self.offset += position * innovation;
        self.velocity += velocity * innovation;
        self.acceleration += acceleration * innovation;
    }

    /// Ends the exponential decay before it reaches denormal numbers.
    #[inline]
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
    #[inline]
    fn update(&mut self, position: f64, elapsed: f64) -> KeyMotion {
        let gain = self.next_gain(elapsed);
        self.predict(position, elapsed);
        self.correct(gain);
        self.settle();
        KeyMotion {
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
        self.unsteady = None;
    }
}

/// Whether a sample came one period after the last one.
#[inline]
fn is_regular(periods: f64) -> bool {
    (periods - 1.0).abs() < STEADY
}

/// A gain in units of the period in those of the second (1, 1/s, 1/s²).
fn per_seconds(gain: &Vector3<f64>, period: f64) -> [f64; 3] {
    [gain[0], gain[1] / period, gain[2] / (period * period)]
}

/// Returns the steady gain, and the covariance after a correction, in units of quantum and
/// period.
///
/// In these units the filter has a single parameter, `ratio` = q T⁵ / Δ²: jerk density
/// against rounding. Iterates prediction and correction of the covariance.
fn steady_gain(ratio: f64) -> (Vector3<f64>, Matrix3<f64>) {
    let mut before = Matrix3::identity() + ratio * white_jerk(1.0);
    let mut gain = gain_of(&before);
    let mut after = corrected(&before, &gain);
    for _ in 0..MAX_ITERATIONS {
        before = predicted(&after, ratio, 1.0);
        let next = gain_of(&before);
        let change = (next - gain).component_div(&next).amax();
        gain = next;
        after = corrected(&before, &gain);
        if change < CONVERGED {
            break;
        }
    }
    (gain, after)
}

/// Covariance before the sample that comes `t` periods after one with the covariance `after`.
fn predicted(after: &Matrix3<f64>, ratio: f64, t: f64) -> Matrix3<f64> {
    let transition = Matrix3::new(1.0, t, 0.5 * t * t, 0.0, 1.0, t, 0.0, 0.0, 1.0);
    let next = transition * after * transition.transpose() + ratio * white_jerk(t);
    0.5 * (next + next.transpose())
}

/// Covariance that unit white jerk adds over `t` periods.
fn white_jerk(t: f64) -> Matrix3<f64> {
    let [t1, t2, t3, t4, t5] = [t, t * t, t * t * t, t.powi(4), t.powi(5)];
    Matrix3::new(
        t5 / 20.0,
        t4 / 8.0,
        t3 / 6.0,
        t4 / 8.0,
        t3 / 3.0,
        t2 / 2.0,
        t3 / 6.0,
        t2 / 2.0,
        t1,
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

    /// Root mean square velocity error (m/s) on a sine of 5 mm at 2 Hz, counted in 10 µm.
    fn velocity_error(mut estimator: impl Estimator) -> f64 {
        let (quantum, omega) = (1e-5, core::f64::consts::TAU * 2.0);
        let mut sum = 0.0;
        for tick in 0..3000_u32 {
            let phase = omega * f64::from(tick) * 1e-3;
            let counts = (5e-3 * phase.sin() / quantum).round();
            let error =
                estimator.update(counts * quantum, 1e-3).velocity - 5e-3 * omega * phase.cos();
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
            estimator.update(f64::from(tick) * 5e-4, 1e-3);
        }
        let rest = 0.012_345_678;
        // Its memory is a few samples; a thousand are forever.
        for _ in 0..1000 {
            estimator.update(rest, 1e-3);
        }
        assert_eq!(estimator.update(rest, 1e-3), KeyMotion::at_rest(rest));
    }

    #[test]
    fn uniform_acceleration_is_followed_without_bias() {
        let mut estimator = Kalman::new(1e-3, 1e-6, Kalman::KEY_JERK_DENSITY);
        let mut motion = KeyMotion::at_rest(0.0);
        for tick in 0..200_u32 {
            let t = f64::from(tick) * 1e-3;
            motion = estimator.update(0.5 * 3.0 * t * t, 1e-3);
        }
        // The model is exact; what is left is rounding of 0.06 m against T and T².
        assert!((motion.velocity - 3.0 * 0.199).abs() < 1e-12, "{motion:?}");
        assert!((motion.acceleration - 3.0).abs() < 1e-9, "{motion:?}");
    }

    #[test]
    fn samples_at_half_the_rate_get_the_gain_of_a_filter_for_that_rate() {
        let (quantum, density) = (1e-6, Kalman::KEY_JERK_DENSITY);
        let mut often = Kalman::new(1e-3, quantum, density);
        let seldom = Kalman::new(2e-3, quantum, density);
        let mut gain = often.gain();
        for _ in 0..200 {
            gain = often.next_gain(2e-3);
        }
        for (got, want) in gain.iter().zip(seldom.gain()) {
            assert!((got / want - 1.0).abs() < 1e-9, "{got} against {want}");
        }
        for _ in 0..200 {
            often.next_gain(1e-3);
        }
        assert!(often.unsteady.is_none(), "and the steady one again");
    }

    #[test]
    fn irregular_samples_of_a_uniform_acceleration_leave_no_bias() {
        let mut estimator = Kalman::new(1e-3, 1e-6, Kalman::KEY_JERK_DENSITY);
        let (mut t, mut motion) = (0.0, KeyMotion::at_rest(0.0));
        for n in 0..2000_u32 {
            // Between a third of a period and three periods after each other.
            let elapsed = 1e-3 * (0.3 + 2.7 * f64::from(n * 7919 % 101) / 101.0);
            t += elapsed;
            motion = estimator.update(0.5 * 3.0 * t * t, elapsed);
        }
        assert!((motion.velocity - 3.0 * t).abs() < 1e-8, "{motion:?}");
        assert!((motion.acceleration - 3.0).abs() < 1e-5, "{motion:?}");
    }

    #[test]
    fn after_a_reset_the_key_rests_there() {
        let mut estimator = Kalman::new(1e-3, 1e-6, Kalman::KEY_JERK_DENSITY);
        estimator.update(0.01, 1e-3);
        estimator.reset(0.004);
        assert_eq!(estimator.update(0.004, 1e-3), KeyMotion::at_rest(0.004));
    }
}
