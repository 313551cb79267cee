use super::{Estimator, KeyMotion, assert_positive};

/// Gains on the innovation's powers 2/3, 1/3 and 0 (1).
const GAINS: [f64; 3] = [2.0, 2.12, 1.1];

/// Newton steps for the innovation: five converge to rounding if it exists.
const NEWTON_STEPS: usize = 8;

/// Exact sliding-mode differentiator of second order, for keys of bounded jerk, in finite time.
///
/// The step is implicit, so it does not chatter at any sample rate: an innovation that the last
/// power alone can explain is used as it is. `[Lev03]` (gains), `[CL19]` (step).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Levant {
    /// Largest jerk of the key (m/s³).
    jerk: f64,
    motion: KeyMotion,
}

impl Levant {
    /// Creates an estimator at rest at zero, for a key with a jerk of at most `jerk_limit` (m/s³).
    ///
    /// # Panics
    /// Unless `jerk_limit` is finite and positive.
    pub fn new(jerk_limit: f64) -> Self {
        assert_positive(jerk_limit, "jerk limit");
        Self { jerk: jerk_limit, motion: KeyMotion::at_rest(0.0) }
    }
}

impl Estimator for Levant {
    fn update(&mut self, position: f64, elapsed: f64) -> KeyMotion {
        let h = elapsed;
        let KeyMotion { position: x, velocity, acceleration } = self.motion;
        let ahead = x + h * (velocity + h * acceleration) - position;
        let per_third = self.jerk.cbrt();
        let third = h * per_third;
        // Displacement by each power, for an innovation with the cube root 1.
        let moves = [GAINS[0] * third, GAINS[1] * third * third, GAINS[2] * third.powi(3)];
        let root = cube_root_of_rest(ahead.abs(), moves);
        let sign = if 0.0 < root { ahead.signum() } else { ahead / moves[2] };
        let acceleration = acceleration - GAINS[2] * self.jerk * sign * h;
        let sided = root.copysign(sign);
        let velocity = velocity + h * (acceleration - GAINS[1] * per_third * per_third * sided);
        self.motion = KeyMotion { position: position + sided.powi(3), velocity, acceleration };
        self.motion
    }

    fn reset(&mut self, position: f64) {
        self.motion = KeyMotion::at_rest(position);
    }
}

/// Returns y ≥ 0 with y³ + a y² + b y + c = `ahead` for `[a, b, c]` = `moves`; 0 if c is more.
///
/// # Real-time
/// Eight Newton steps, from above, where the cubic is convex.
fn cube_root_of_rest(ahead: f64, [a, b, c]: [f64; 3]) -> f64 {
    let rest = ahead - c;
    if rest <= 0.0 {
        return 0.0;
    }
    let mut y = rest.cbrt().min(rest / b);
    for _ in 0..NEWTON_STEPS {
        let value = ((y + a) * y + b) * y - rest;
        y -= value / ((3.0 * y + 2.0 * a) * y + b);
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_acceleration_that_grows_evenly_is_known_exactly_after_a_while() {
        let (h, jerk) = (1e-4, 500.0);
        let mut estimator = Levant::new(2000.0);
        let mut last = KeyMotion::default();
        for tick in 1..4000_u32 {
            let t = f64::from(tick) * h;
            last = estimator.update(jerk * t.powi(3) / 6.0, h);
        }
        let t = 3999.0 * h;
        // The step is of first order: it lags by one or two periods of what changes.
        assert!((last.velocity - 0.5 * jerk * t * t).abs() < 1.5 * h * jerk * t, "{last:?}");
        assert!((last.acceleration - jerk * t).abs() < 2.5 * h * jerk, "{last:?}");
    }

    #[test]
    fn it_does_not_chatter_on_a_key_that_rests() {
        let mut estimator = Levant::new(1e5);
        estimator.update(1e-5, 1e-3);
        let moves: Vec<_> = (0..400).map(|_| estimator.update(1e-5, 1e-3)).collect();
        let last = moves[399];
        assert!(last.velocity.abs() < 1e-9 && last.acceleration.abs() < 1e-6, "{last:?}");
    }

    #[test]
    fn the_innovation_solves_its_equation() {
        for ahead in [1e-9, 1e-6, 1e-3, 0.3, 50.0] {
            for moves in [[2e-2, 2e-4, 1e-6], [0.2, 0.02, 1e-3], [5.0, 12.0, 0.01]] {
                let y = cube_root_of_rest(ahead, moves);
                let [a, b, c] = moves;
                let found = ((y + a) * y + b) * y + c;
                let exact = f64::max(ahead, c);
                assert!((found - exact).abs() <= 1e-12 * exact, "{ahead} {moves:?}: {found}");
            }
        }
    }
}
