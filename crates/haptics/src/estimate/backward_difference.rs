//! The textbook estimator: differences of the last three positions.

use super::{Estimator, KeyMotion, assert_positive};

/// First and second backward difference. The rig of `[GC93]` §6 used this estimator.
///
/// No lag beyond half a period, but one count of an encoder moves the velocity by
/// quantum / period and the acceleration by quantum / period².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BackwardDifference {
    period: f64,
    position: f64,
    velocity: f64,
    /// Time between the last two samples (s).
    elapsed: f64,
}

impl BackwardDifference {
    /// Creates an estimator at rest at zero, for one sample each `period` (s).
    ///
    /// # Panics
    /// Unless `period` is finite and positive.
    pub fn new(period: f64) -> Self {
        assert_positive(period, "period");
        Self { period, position: 0.0, velocity: 0.0, elapsed: period }
    }
}

impl Estimator for BackwardDifference {
    fn update(&mut self, position: f64, elapsed: f64) -> KeyMotion {
        let velocity = (position - self.position) / elapsed;
        // Each velocity belongs to the middle of its interval.
        let acceleration = (velocity - self.velocity) / (0.5 * (self.elapsed + elapsed));
        self.position = position;
        self.velocity = velocity;
        self.elapsed = elapsed;
        KeyMotion { position, velocity, acceleration }
    }

    fn update_with_speed(&mut self, position: f64, velocity: f64, elapsed: f64) -> KeyMotion {
        let acceleration = (velocity - self.velocity) / elapsed;
        (self.position, self.velocity, self.elapsed) = (position, velocity, elapsed);
        KeyMotion { position, velocity, acceleration }
    }

    fn reset(&mut self, position: f64) {
        self.position = position;
        self.velocity = 0.0;
        self.elapsed = self.period;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The paper's encoder (rad per count): 50 lines per inch, ×4, 3 in over 45°.
    const PAPER_COUNT: f64 = core::f64::consts::FRAC_PI_4 / (50.0 * 4.0 * 3.0);

    #[test]
    fn one_count_of_the_papers_rig_is_a_step_of_1_31_rad_per_s() {
        let mut estimator = BackwardDifference::new(1e-3);
        let motion = estimator.update(PAPER_COUNT, 1e-3);
        assert!((motion.velocity - 1.309).abs() < 5e-4, "{motion:?}");
        assert!((motion.acceleration - 1309.0).abs() < 0.5, "{motion:?}");
    }

    #[test]
    fn uniform_acceleration_is_seen_through_gaps() {
        let (period, acceleration) = (1e-3, 2.0);
        let mut estimator = BackwardDifference::new(period);
        let mut t = 0.0;
        for (n, elapsed) in [1.0, 1.0, 3.0, 0.4, 2.5, 1.0].iter().map(|it| it * period).enumerate()
        {
            t += elapsed;
            let motion = estimator.update(0.5 * acceleration * t * t, elapsed);
            if n >= 2 {
                assert!((motion.velocity - acceleration * (t - 0.5 * elapsed)).abs() < 1e-12);
                assert!((motion.acceleration - acceleration).abs() < 1e-8, "{motion:?}");
            }
        }
    }

    #[test]
    fn measured_speeds_show_an_acceleration_without_delay_in_the_speed() {
        let mut estimator = BackwardDifference::new(1e-3);
        for tick in 0..20_u32 {
            let t = f64::from(tick) * 1e-3;
            let motion = estimator.update_with_speed(t * t, 2.0 * t, 1e-3);
            assert!(motion.velocity.to_bits() == (2.0 * t).to_bits());
            assert!(tick == 0 || (motion.acceleration - 2.0).abs() < 1e-11, "{motion:?}");
        }
    }

    #[test]
    fn a_reset_forgets_the_jump() {
        let mut estimator = BackwardDifference::new(1e-3);
        estimator.update(1.0, 1e-3);
        estimator.reset(0.004);
        assert_eq!(estimator.update(0.004, 1e-3), KeyMotion::at_rest(0.004));
    }
}
