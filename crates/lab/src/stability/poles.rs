//! Exact poles of a wall on a key: the map of a small motion over a period.
//!
//! Between two ticks the key is a damped mass under a constant force, which has a closed form. So
//! the motion from tick to tick is a matrix without an error of integration.

use haptics::SampledWall;
use nalgebra_of_lm::{DMatrix, Schur};

/// Maximum steps of the QR algorithm.
const MOST_STEPS: usize = 10_000;

/// Returns the largest modulus of the poles of `wall` on a key of `mass` (kg) and `damping`
/// (N s/m); `None` if they cannot be found.
///
/// Below 1 a motion without steps, felts or friction decays. The state is position and velocity at the
/// tick, the position before, and the forces that are still on their way.
pub fn spectral_radius(wall: &SampledWall, mass: f64, damping: f64) -> Option<f64> {
    let tick = TickMap::new(wall, mass, damping);
    let size = 3 + tick.forces();
    let columns = (0..size).map(|place| {
        let mut state = vec![0.0; size];
        state[place] = 1.0;
        tick.apply(&state)
    });
    let matrix = DMatrix::from_iterator(size, size, columns.flatten());
    if matrix.iter().any(|it| !it.is_finite()) {
        return None;
    }
    let schur = Schur::try_new(matrix, f64::EPSILON, MOST_STEPS)?;
    Some(schur.complex_eigenvalues().iter().map(|it| it.norm()).fold(0.0, f64::max))
}

struct TickMap<'a> {
    wall: &'a SampledWall,
    whole: usize,
    /// Segment of the previous force, and of the next.
    parts: [HeldForce; 2],
}

impl<'a> TickMap<'a> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative")]
    fn new(wall: &'a SampledWall, mass: f64, damping: f64) -> Self {
        let periods = wall.delay / wall.period;
        // A delay of whole periods must not become one more by rounding.
        let whole = (periods + 1e-9).floor().max(0.0);
        let part = (periods - whole).max(0.0) * wall.period;
        let held = |time| HeldForce::new(time, mass, damping);
        Self { wall, whole: whole as usize, parts: [held(part), held(wall.period - part)] }
    }

    /// Returns the number of forces on their way at a tick: those of the `whole` + 1 ticks before.
    const fn forces(&self) -> usize {
        self.whole + 1
    }

    fn apply(&self, state: &[f64]) -> Vec<f64> {
        let [position, velocity, before] = [state[0], state[1], state[2]];
        let rate = (position - before) / self.wall.period;
        let force = self.wall.stiffness * position + self.wall.damping * rate;
        let mut forces = vec![force];
        forces.extend(&state[3..]);
        let moved = self.parts[0].apply((position, velocity), forces[self.whole + 1]);
        let moved = self.parts[1].apply(moved, forces[self.whole]);
        forces.truncate(self.forces());
        [&[moved.0, moved.1, position], forces.as_slice()].concat()
    }
}

/// A mass with a damper for some time under a constant force.
#[derive(Clone, Copy)]
struct HeldForce {
    /// Remaining fraction of a velocity.
    kept: f64,
    /// Displacement per velocity (s).
    reach: f64,
    /// Velocity and displacement per force (s/kg, s²/kg).
    pushed: (f64, f64),
}

impl HeldForce {
    /// Share of a time constant below which the exponential is its series (E).
    const SHORT: f64 = 1e-5;

    fn new(time: f64, mass: f64, damping: f64) -> Self {
        let share = damping * time / mass;
        if share < Self::SHORT {
            // To third order in the share.
            let reach = time * (1.0 - share * (0.5 - share / 6.0));
            let way = time * time / mass * (0.5 - share * (1.0 / 6.0 - share / 24.0));
            return Self { kept: (-share).exp(), reach, pushed: (reach / mass, way) };
        }
        let kept = (-share).exp();
        let reach = -(-share).exp_m1() * mass / damping;
        let pushed = (reach / mass, (time - reach) / damping);
        Self { kept, reach, pushed }
    }

    fn apply(&self, (position, velocity): (f64, f64), force: f64) -> (f64, f64) {
        let (speed, way) = self.pushed;
        (position + self.reach * velocity - way * force, self.kept * velocity - speed * force)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const T: f64 = 1e-3;

    fn wall(stiffness: f64, damping: f64, delay: f64) -> SampledWall {
        SampledWall { stiffness, damping, period: T, delay }
    }

    #[test]
    fn without_a_wall_the_position_stays_and_the_velocity_falls_with_its_time_constant() {
        let radius = spectral_radius(&wall(0.0, 0.0, 0.0), 0.04, 1.0).unwrap();
        assert!((radius - 1.0).abs() < 1e-9, "{radius}");
    }

    #[test]
    fn a_mass_without_damping_on_a_held_spring_has_the_modulus_of_its_determinant() {
        // x' = x + T v − T²/2m K x, v' = v − T/m K x: determinant 1 + K T²/2m.
        let (mass, stiffness) = (0.04, 1e3);
        let radius = spectral_radius(&wall(stiffness, 0.0, 0.0), mass, 0.0).unwrap();
        let expected = (1.0 + 0.5 * stiffness * T * T / mass).sqrt();
        assert!((radius - expected).abs() < 1e-9, "{radius}, expected {expected}");
    }

    #[test]
    fn a_mass_that_goes_to_zero_leaves_the_unit_circle_where_passivity_ends() {
        for (device, damping) in [(0.5, 0.0), (1.0, 0.4), (5.0, 1.0)] {
            let limit = wall(0.0, damping, 0.0).passive_stiffness(device);
            // A five-hundredth of b T: no velocity remains after a period, and the remaining
            // displacement is a five-hundredth of the whole.
            let mass = 2e-3 * device * T;
            let radius =
                |share| spectral_radius(&wall(share * limit, damping, 0.0), mass, device).unwrap();
            assert!(radius(0.99) < 1.0 && 1.0 < radius(1.01), "{device}, {damping}");
        }
    }

    #[test]
    fn short_times_and_long_ones_have_the_same_matrix_where_they_meet() {
        let (mass, time) = (0.04, 1e-4);
        let damping = HeldForce::SHORT * mass / time;
        let short = HeldForce::new(time, mass, damping * (1.0 - 1e-9));
        let long = HeldForce::new(time, mass, damping * (1.0 + 1e-9));
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-8;
        assert!(near(short.kept, long.kept) && near(short.reach, long.reach));
        // The difference of time and reach loses five digits.
        assert!(near(short.pushed.0, long.pushed.0));
        assert!((short.pushed.1 / long.pushed.1 - 1.0).abs() < 1e-5);
    }

    #[test]
    fn a_delay_that_is_nearly_a_whole_period_is_nearly_that_period() {
        let radius = |delay: f64| spectral_radius(&wall(900.0, 0.5, delay * T), 0.04, 1.0).unwrap();
        for whole in [1.0, 2.0, 5.0] {
            let ends = [whole - 1e-7, whole, whole + 1e-7].map(radius);
            assert!((ends[0] - ends[1]).abs() < 1e-6 && (ends[2] - ends[1]).abs() < 1e-6);
        }
        assert!(radius(0.0) < radius(0.5) && radius(0.5) < radius(1.0));
    }
}
