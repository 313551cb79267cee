//! A constant-acceleration Kalman filter.
//!
//! With one sample per period the filter has a steady gain, found at construction. An early or late
//! sample has another weight, so the covariance is followed until it is steady again; the steady
//! gain would be unstable where every third sample is late.

use nalgebra::Matrix3;

use super::{Estimator, KeyMotion, assert_positive};

/// Maximum Riccati iterations, reached only by a memory of more than ten thousand samples.
const MAX_ITERATIONS: usize = 200_000;

/// Relative change of the gain that counts as converged: some hundred roundings.
const CONVERGED: f64 = 1e-14;

/// Relative difference to the steady gain that counts as none.
const STEADY: f64 = 1e-9;

/// Maximum time between samples (periods): beyond it only the new position counts.
const FORGOTTEN: f64 = 1e4;

/// Variance of a uniform rounding to one unit.
const ROUNDING: f64 = 1.0 / 12.0;

/// Displacement per period that counts as rest (counts): no encoder distinguishes a millionth.
const REST: f64 = 1e-6;

/// Kalman filter of a point driven by white jerk.
///
/// State: position, velocity, acceleration. The measurement's variance is that of a uniformly
/// distributed rounding, quantum²/12. The position is kept as the difference to the latest
/// measurement, so a resting key is estimated at exactly its measured position with exactly zero
/// velocity. `[BLK01]` §6.2.3 (white jerk, discretised) and §5.2.5 (steady state).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kalman {
    period: f64,
    /// Displacement per period (m) below which motion is rest.
    rest: f64,
    gains: KalmanGains,
    /// q T⁵ / Δ².
    ratio: f64,
    /// Variance of a measured speed's rounding, in units of quantum and period.
    speed_variance: Option<f64>,
    /// Covariance after a correction for regular samples, in units of quantum and period.
    steady: Matrix3<f64>,
    /// Current covariance if it differs from `steady`, after irregular samples.
    unsteady: Option<Matrix3<f64>>,
    measured: f64,
    /// Estimated minus measured position (m).
    offset: f64,
    velocity: f64,
    acceleration: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct KalmanGains {
    /// Per metre of the position's innovation (1, 1/s, 1/s²).
    position: [f64; 3],
    /// Per m/s of a measured speed's innovation, applied after `position` (s, 1, 1/s).
    speed: Option<[f64; 3]>,
}

impl Kalman {
    /// Jerk density of a played key (m²/s⁵): 3e3 m/s³ that change every 10 ms (estimate).
    pub const KEY_JERK_DENSITY: f64 = 1e5;

    /// Creates a filter at rest at zero; not for the tick. Samples come each `period` (s), rounded
    /// to `quantum` (m). A larger `jerk_density` (m²/s⁵) is faster and noisier.
    ///
    /// # Panics
    /// Unless all three are finite and positive.
    pub fn new(period: f64, quantum: f64, jerk_density: f64) -> Self {
        assert_positive(period, "period");
        assert_positive(quantum, "quantum");
        assert_positive(jerk_density, "jerk density");
        let ratio = jerk_density * period.powi(5) / (quantum * quantum);
        let (gains, steady) = steady_gains(ratio, None, period);
        Self {
            period,
            rest: REST * quantum,
            gains,
            ratio,
            speed_variance: None,
            steady,
            unsteady: None,
            measured: 0.0,
            offset: 0.0,
            velocity: 0.0,
            acceleration: 0.0,
        }
    }

    /// Adds measured speeds, rounded to `step` (m/s). Not for the tick.
    ///
    /// # Panics
    /// Unless `step` is finite and positive.
    #[must_use]
    pub fn with_measured_speed(self, step: f64) -> Self {
        assert_positive(step, "step of the speed");
        let in_units = step * self.period / (self.rest / REST);
        let speed_variance = Some(in_units * in_units * ROUNDING);
        let (gains, steady) = steady_gains(self.ratio, speed_variance, self.period);
        Self { gains, speed_variance, steady, ..self }
    }

    /// Returns the steady gains on position, velocity and acceleration (1, 1/s, 1/s²).
    pub const fn gain(&self) -> [f64; 3] {
        self.gains.position
    }

    /// Returns the gains for a sample `elapsed` (s) after the last, and its measured speed, if any.
    #[inline]
    fn next_gains(&mut self, elapsed: f64, speed_variance: Option<f64>) -> KalmanGains {
        let periods = (elapsed / self.period).min(FORGOTTEN);
        let is_usual = speed_variance.is_some() == self.speed_variance.is_some();
        if is_regular(periods) && is_usual && self.unsteady.is_none() {
            return self.gains;
        }
        self.unsteady_gains(periods, speed_variance)
    }

    /// Returns the gains for a sample `periods` after the last, and updates the covariance.
    #[inline(never)]
    fn unsteady_gains(&mut self, periods: f64, speed_variance: Option<f64>) -> KalmanGains {
        let before = self.unsteady.as_ref().unwrap_or(&self.steady);
        let predicted = predicted(before, self.ratio, periods);
        let (gains, after) = corrected(&predicted, speed_variance);
        let gains = gains.per_seconds(self.period);
        let is_steady = is_regular(periods) && gains.is_near(&self.gains);
        self.unsteady = (!is_steady).then_some(0.5 * (after + after.transpose()));
        gains
    }

    #[inline]
    fn follow(&mut self, position: f64, velocity: Option<f64>, elapsed: f64) -> KeyMotion {
        // A speed with unknown steps has no weight.
        let measured = velocity.zip(self.speed_variance);
        let gains = self.next_gains(elapsed, measured.map(|it| it.1));
        self.predict(position, elapsed);
        self.correct(gains.position, -self.offset);
        if let (Some((velocity, _)), Some(gain)) = (measured, gains.speed) {
            self.correct(gain, velocity - self.velocity);
        }
        self.settle();
        KeyMotion {
            position: position + self.offset,
            velocity: self.velocity,
            acceleration: self.acceleration,
        }
    }

    /// Predicts the state `h` (s) later, relative to the `measured` position (m).
    #[inline]
    fn predict(&mut self, measured: f64, h: f64) {
        self.offset += h * (self.velocity + 0.5 * h * self.acceleration);
        self.offset += self.measured - measured;
        self.velocity += h * self.acceleration;
        self.measured = measured;
    }

    #[inline]
    fn correct(&mut self, [position, velocity, acceleration]: [f64; 3], innovation: f64) {
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
        self.follow(position, None, elapsed)
    }

    #[inline]
    fn update_with_speed(&mut self, position: f64, velocity: f64, elapsed: f64) -> KeyMotion {
        self.follow(position, Some(velocity), elapsed)
    }

    fn reset(&mut self, position: f64) {
        self.measured = position;
        self.offset = 0.0;
        self.velocity = 0.0;
        self.acceleration = 0.0;
        self.unsteady = None;
    }
}

#[inline]
fn is_regular(periods: f64) -> bool {
    (periods - 1.0).abs() < STEADY
}

impl KalmanGains {
    fn per_seconds(self, h: f64) -> Self {
        let [position, velocity, acceleration] = self.position;
        Self {
            position: [position, velocity / h, acceleration / (h * h)],
            speed: self.speed.map(|[position, velocity, acceleration]| {
                [position * h, velocity, acceleration / h]
            }),
        }
    }

    /// Returns the largest relative difference to `other`; infinite if only one has gains on speed.
    fn difference(&self, other: &Self) -> f64 {
        let of = |a: &[f64; 3], b: &[f64; 3]| {
            let relative = a.iter().zip(b).map(|(a, b)| (a - b).abs() / b.abs());
            relative.fold(0.0, f64::max)
        };
        let speed = match (&self.speed, &other.speed) {
            (Some(a), Some(b)) => of(a, b),
            (None, None) => 0.0,
            (Some(_), None) | (None, Some(_)) => f64::INFINITY,
        };
        of(&self.position, &other.position).max(speed)
    }

    fn is_near(&self, other: &Self) -> bool {
        self.difference(other) < STEADY
    }
}

/// Iterates prediction and correction; returns the steady gains (per second), and the covariance
/// after a correction, in units of quantum and period `h` (s). The filter then has two parameters:
/// `ratio` = q T⁵ / Δ² and the variance of speeds.
fn steady_gains(ratio: f64, speed_variance: Option<f64>, h: f64) -> (KalmanGains, Matrix3<f64>) {
    let start = Matrix3::identity() + ratio * white_jerk(1.0);
    let (mut gains, mut after) = corrected(&start, speed_variance);
    for _ in 0..MAX_ITERATIONS {
        let (next, corrected) = corrected(&predicted(&after, ratio, 1.0), speed_variance);
        let change = gains.difference(&next);
        (gains, after) = (next, corrected);
        if change < CONVERGED {
            break;
        }
    }
    (gains.per_seconds(h), after)
}

/// Returns the covariance `t` periods after one with the covariance `after`.
fn predicted(after: &Matrix3<f64>, ratio: f64, t: f64) -> Matrix3<f64> {
    let transition = Matrix3::new(1.0, t, 0.5 * t * t, 0.0, 1.0, t, 0.0, 0.0, 1.0);
    let next = transition * after * transition.transpose() + ratio * white_jerk(t);
    0.5 * (next + next.transpose())
}

/// Returns the covariance that unit white jerk adds over `t` periods.
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

/// Returns the optimal gains on a position that is rounded to one unit, and then on a speed with
/// this variance, if one is measured; and the covariance after both.
fn corrected(predicted: &Matrix3<f64>, speed_variance: Option<f64>) -> (KalmanGains, Matrix3<f64>) {
    let (position, after) = measured(predicted, 0, ROUNDING);
    let Some(variance) = speed_variance else {
        return (KalmanGains { position, speed: None }, after);
    };
    let (speed, after) = measured(&after, 1, variance);
    (KalmanGains { position, speed: Some(speed) }, after)
}

/// Returns the optimal gain on entry `row` with this `variance`, and the covariance after it.
fn measured(before: &Matrix3<f64>, row: usize, variance: f64) -> ([f64; 3], Matrix3<f64>) {
    let gain = before.column(row) / (before[(row, row)] + variance);
    let looked_at = Matrix3::identity().row(row).into_owned();
    (gain.into(), (Matrix3::identity() - gain * looked_at) * before)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::super::BackwardDifference;
    use super::*;

    /// Computes the steady gain in SI units by Joseph's form and a fixed long iteration.
    fn joseph_gain(period: f64, quantum: f64, jerk_density: f64) -> [f64; 3] {
        let (t, r) = (period, quantum * quantum / 12.0);
        let f = Matrix3::new(1.0, t, t * t / 2.0, 0.0, 1.0, t, 0.0, 0.0, 1.0);
        // Gauss-Legendre of order 6 integrates the outer product (polynomials of degree 4) exactly.
        let mut q = Matrix3::zeros();
        for (node, weight) in [(-0.6_f64.sqrt(), 5.0), (0.0, 8.0), (0.6_f64.sqrt(), 5.0)] {
            let s = t * (1.0 + node) / 2.0;
            let response = Vector3::new(s * s / 2.0, s, 1.0);
            q += jerk_density * t / 2.0 * weight / 9.0 * response * response.transpose();
        }
        let mut p = Matrix3::from_diagonal(&Vector3::new(1e-6, 1.0, 1e4));
        let mut gain = Vector3::zeros();
        for _ in 0..50_000 {
            p = f * p * f.transpose() + q;
            gain = p.column(0) / (p[(0, 0)] + r);
            let mut keep = Matrix3::identity();
            keep.set_column(0, &(keep.column(0) - gain));
            p = keep * p * keep.transpose() + r * gain * gain.transpose();
        }
        gain.into()
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

    /// Returns the rms velocity error (m/s) on a sine of 5 mm at 2 Hz, in counts of 10 µm.
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
    fn measured_speeds_have_the_gain_of_the_information_filter() {
        // The inverse covariances of both measurements add up, without any gain.
        let (ratio, variance) = (0.1, 0.003);
        let (_gains, after) = steady_gains(ratio, Some(variance), 1.0);
        let before = predicted(&after, ratio, 1.0);
        let mut information = before.try_inverse().expect("it is no point");
        information[(0, 0)] += 12.0;
        information[(1, 1)] += 1.0 / variance;
        let wanted = information.try_inverse().expect("nor is this");
        assert!((wanted - after).abs().max() < 1e-12 * wanted.abs().max(), "{wanted} {after}");
    }

    /// Returns the root mean square error of the acceleration (m/s²) on a sine of 5 mm at 5 Hz, in
    /// counts of 0.1 mm, with `update` fed a position and a speed in steps of 0.2 mm/s.
    fn acceleration_error(mut update: impl FnMut(f64, f64) -> KeyMotion) -> f64 {
        let omega = core::f64::consts::TAU * 5.0;
        let mut error = |tick: u32| {
            let phase = omega * f64::from(tick) * 1e-3;
            let position = (5e-3 * phase.sin() / 1e-4).round() * 1e-4;
            let speed = (5e-3 * omega * phase.cos() / 2e-4).round() * 2e-4;
            update(position, speed).acceleration + 5e-3 * omega * omega * phase.sin()
        };
        let errors: Vec<_> = (0..3000).map(&mut error).collect();
        (errors[1000..].iter().map(|it| it * it).sum::<f64>() / 2000.0).sqrt()
    }

    #[test]
    fn a_measured_speed_makes_the_acceleration_of_a_coarse_encoder_three_times_better() {
        let mut alone = Kalman::new(1e-3, 1e-4, 1e3);
        let mut with_speed = alone.with_measured_speed(2e-4);
        let without = acceleration_error(|position, _speed| alone.update(position, 1e-3));
        let with = acceleration_error(|position, speed| {
            with_speed.update_with_speed(position, speed, 1e-3)
        });
        assert!(3.0 * with < without, "{with} {without}");
    }

    #[test]
    fn a_speed_that_is_missing_once_leaves_the_filter_what_it_was() {
        let mut kalman = Kalman::new(1e-3, 1e-6, 1e5).with_measured_speed(2e-4);
        let at = |tick: u32| (f64::from(tick) * 5e-4, 0.5);
        for tick in 0..100 {
            let (position, speed) = at(tick);
            let motion = if tick == 50 {
                kalman.update(position, 1e-3)
            } else {
                kalman.update_with_speed(position, speed, 1e-3)
            };
            assert!(tick < 40 || (motion.velocity - 0.5).abs() < 1e-6, "{tick}: {motion:?}");
        }
        assert!(kalman.unsteady.is_none());
    }

    #[test]
    fn a_key_that_rests_is_estimated_exactly_at_rest() {
        let mut estimator = Kalman::new(1e-3, 1e-6, Kalman::KEY_JERK_DENSITY);
        for tick in 0..20_u32 {
            estimator.update(f64::from(tick) * 5e-4, 1e-3);
        }
        let rest = 0.012_345_678;
        // Its memory is a few samples.
        for _ in 0..1000 {
            estimator.update(rest, 1e-3);
        }
        assert_eq!(estimator.update(rest, 1e-3), KeyMotion::at_rest(rest));
    }

    #[test]
    fn samples_at_half_the_rate_get_the_gain_of_a_filter_for_that_rate() {
        let (quantum, density) = (1e-6, Kalman::KEY_JERK_DENSITY);
        let mut often = Kalman::new(1e-3, quantum, density);
        let seldom = Kalman::new(2e-3, quantum, density);
        let mut gain = often.gain();
        for _ in 0..200 {
            gain = often.next_gains(2e-3, None).position;
        }
        for (got, want) in gain.iter().zip(seldom.gain()) {
            assert!((got / want - 1.0).abs() < 1e-9, "{got} against {want}");
        }
        for _ in 0..200 {
            often.next_gains(1e-3, None);
        }
        assert!(often.unsteady.is_none(), "and the steady one again");
    }

    #[test]
    fn irregular_samples_of_a_uniform_acceleration_leave_no_bias() {
        let mut estimator = Kalman::new(1e-3, 1e-6, Kalman::KEY_JERK_DENSITY);
        let (mut t, mut motion) = (0.0, KeyMotion::at_rest(0.0));
        for n in 0..2000_u32 {
            // Intervals between a third of a period and three periods.
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
