//! The zero of a guard inside a step: Newton, kept inside a bracket.

/// Maximum number of rounds; Newton needs 4 or 5, bisection alone at most 53.
const ROUNDS: usize = 60;

/// Length of the last Newton step: its own error is that squared.
const LAST: f64 = 1e-10;

/// Returns the part θ of a step at which `guard` (value, and rate per step) falls through zero.
///
/// The guard is positive at `start`, or zero there and rising; it is not positive at `end`.
#[inline]
pub(crate) fn falling((start, end): (f64, f64), mut guard: impl FnMut(f64) -> (f64, f64)) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    // Start at the far side if the near one is on the threshold: that zero is another root.
    let mut theta = if start > 1e-9 { start / (start - end) } else { 1.0 };
    for _ in 0..ROUNDS {
        let (value, rate) = guard(theta);
        let step = value / rate;
        if rate < 0.0 && step.abs() < LAST {
            return theta - step;
        }
        if value > 0.0 || (value == 0.0 && rate > 0.0) {
            low = theta;
        } else {
            high = theta;
        }
        let newton = theta - step;
        let is_inside = rate < 0.0 && newton > low && newton < high;
        theta = if is_inside { newton } else { 0.5 * (low + high) };
    }
    theta
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_that_starts_on_the_threshold_falls_at_its_second_root() {
        let theta = falling((0.0, -0.5), |t| (t * (0.5 - t), 0.5 - 2.0 * t));
        assert!((theta - 0.5).abs() < 1e-15, "{theta}");
    }

    #[test]
    fn a_straight_line_is_found_at_once() {
        let mut calls = 0;
        let theta = falling((1.0, -3.0), |t| {
            calls += 1;
            (1.0 - 4.0 * t, -4.0)
        });
        assert!((theta - 0.25).abs() < 1e-15 && calls == 1, "{theta} after {calls}");
    }
}
