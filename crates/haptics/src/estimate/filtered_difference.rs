use super::{Estimator, KeyMotion, assert_positive};

/// Velocity and acceleration of the key behind a critically damped low pass of second order.
///
/// The low pass runs in continuous time between samples, which are joined by straight lines, so
/// late and early samples have their right weight. Velocity lags by 2 / (2π cutoff).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilteredDifference {
    /// 2π times the cutoff (rad/s).
    corner: f64,
    measured: f64,
    /// Filtered minus measured position (m).
    offset: f64,
    /// Filtered velocity (m/s).
    velocity: f64,
}

impl FilteredDifference {
    /// Creates an estimator at rest at zero, whose low pass has `cutoff` (Hz).
    ///
    /// # Panics
    /// Unless `cutoff` is finite and positive.
    pub fn new(cutoff: f64) -> Self {
        assert_positive(cutoff, "cutoff");
        let corner = core::f64::consts::TAU * cutoff;
        Self { corner, measured: 0.0, offset: 0.0, velocity: 0.0 }
    }
}

impl Estimator for FilteredDifference {
    fn update(&mut self, position: f64, elapsed: f64) -> KeyMotion {
        let w = self.corner;
        let rate = (position - self.measured) / elapsed;
        // It converges, critically damped, to a line that is 2 / w late.
        let late = 2.0 * rate / w;
        let (away, drift) = (self.offset + late, self.velocity - rate);
        let slope = drift + w * away;
        let decay = (-w * elapsed).exp();
        let away = (away + slope * elapsed) * decay;
        let drift = (drift - w * slope * elapsed) * decay;
        self.offset = away - late;
        self.velocity = rate + drift;
        self.measured = position;
        let acceleration = -w * (w * away + 2.0 * drift);
        KeyMotion { position, velocity: self.velocity, acceleration }
    }

    fn reset(&mut self, position: f64) {
        (self.measured, self.offset, self.velocity) = (position, 0.0, 0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_is_differentiated_as_the_low_pass_says() {
        // Finely sampled: H(s) = 1 / (1 + s / w)^2, velocity s H, acceleration s^2 H.
        let (h, cutoff, frequency) = (1e-5, 100.0, 60.0_f64);
        let mut estimator = FilteredDifference::new(cutoff);
        let omega = core::f64::consts::TAU * frequency;
        let ratio = frequency / cutoff;
        let (gain, lag) = (1.0 / (1.0 + ratio * ratio), 2.0 * ratio.atan());
        for tick in 1..20_000_u32 {
            let phase = omega * f64::from(tick) * h;
            let motion = estimator.update(1e-3 * phase.sin(), h);
            if 10_000 < tick {
                let velocity = 1e-3 * omega * gain * (phase - lag).cos();
                let acceleration = -1e-3 * omega * omega * gain * (phase - lag).sin();
                assert!((motion.velocity - velocity).abs() < 1e-4 * 1e-3 * omega, "{motion:?}");
                let error = (motion.acceleration - acceleration).abs();
                assert!(error < 3e-3 * 1e-3 * omega * omega, "{error} of {acceleration}");
            }
        }
    }

    #[test]
    fn a_uniform_motion_is_known_through_gaps() {
        let mut estimator = FilteredDifference::new(80.0);
        let mut t = 0.0;
        for n in 0..300_u32 {
            let elapsed = 1e-3 * [1.0, 0.4, 2.7][n as usize % 3];
            t += elapsed;
            let motion = estimator.update(0.3 * t, elapsed);
            if 200 < n {
                assert!((motion.velocity - 0.3).abs() < 1e-12, "{motion:?}");
                assert!(motion.acceleration.abs() < 1e-8, "{motion:?}");
            }
        }
    }

    #[test]
    fn a_count_of_the_encoder_is_spread_over_the_memory() {
        let mut estimator = FilteredDifference::new(50.0);
        let peak = (0..100).map(|_| estimator.update(1e-5, 1e-3).velocity).fold(0.0, f64::max);
        // A step of a count: w / e of it, and less because the step is a ramp of a period.
        let exact = 1e-5 * core::f64::consts::TAU * 50.0 / core::f64::consts::E;
        assert!((0.9..1.0).contains(&(peak / exact)), "{}", peak / exact);
    }
}
