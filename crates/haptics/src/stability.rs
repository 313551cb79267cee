//! Bounds on the stiffness and damping of a sampled wall: the theory for measured loops.
//!
//! A wall answers the key's position with a force F = K x + B v, computed once a period from a
//! sample and held until the next. Held and late, it returns more energy than it absorbed, and the
//! device's own damping or friction must dissipate the rest. These bounds are of passivity: the
//! loop is stable under any passive hand or load. A given hand may allow more.

use core::f64::consts::PI;

/// Number of frequencies in the search for a supremum: 64 to a wave at 64 periods' delay.
const FREQUENCIES: u32 = 4096;

/// A rendered wall: sampled, held, and late.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampledWall {
    /// Stiffness K (N/m).
    pub stiffness: f64,
    /// Damping B (N s/m), of a velocity by backward difference; negative for one that drives.
    pub damping: f64,
    /// Period T of the loop (s).
    pub period: f64,
    /// Time between a sample and its force (s), beyond the hold.
    pub delay: f64,
}

impl SampledWall {
    /// Returns the device damping (N s/m) above which the wall is passive: K (T/2 + d) + |B|.
    ///
    /// Without delay it is exact, from `[CS97]`: the supremum of [`Self::demand`], at half the
    /// sampling rate for B above zero and at standstill for B below. With a delay of whole periods
    /// it suffices: of the demand's two terms, sin((n + 1/2) θ) / sin(θ/2) is Dirichlet's kernel,
    /// largest, 2 n + 1, at θ = 0, and -cos((n + 1) θ) is at most 1. The first alone is also needed
    /// for any delay, because a slow motion reaches it; `[HA14]` has both boundaries with delay.
    pub fn passive_damping(&self) -> f64 {
        let Self { stiffness, damping, period, delay } = *self;
        stiffness * (0.5 * period + delay) + damping.abs()
    }

    /// Returns the stiffness (N/m) below which the wall is passive on a device with `damping`
    /// (N s/m), by [`Self::passive_damping`]; below zero if none is.
    pub fn passive_stiffness(&self, damping: f64) -> f64 {
        (damping - self.damping.abs()) / (0.5 * self.period + self.delay)
    }

    /// Returns the damping that a motion with the angle `theta` per period (rad, above 0 to π)
    /// demands of the device (N s/m), with the delay rounded to `n` whole periods. `[CS97]` has
    /// (T/2) / (1 − cos θ) · Re{(1 − e^−jθ) H(e^jθ)} for any H. With H(z) = z^−n (K + B (z − 1) /
    /// (T z)) it is (K T/2) sin((n + 1/2) θ) / sin(θ/2) − B cos((n + 1) θ).
    pub fn demand(&self, theta: f64) -> f64 {
        let n = self.whole_periods();
        let spring = ((n + 0.5) * theta).sin() / (0.5 * theta).sin();
        0.5 * self.stiffness * self.period * spring - self.damping * ((n + 1.0) * theta).cos()
    }

    /// Returns the largest demand over all frequencies (N s/m), the necessary and sufficient
    /// damping, with the delay rounded to whole periods.
    ///
    /// # Real-time
    /// Not for the tick: evaluates 4096 frequencies.
    pub fn largest_demand(&self) -> f64 {
        // At θ = 0 the kernel is a limit.
        let still = 0.5 * self.stiffness * self.period * (2.0 * self.whole_periods() + 1.0);
        let angles = (1..=FREQUENCIES).map(|it| PI * f64::from(it) / f64::from(FREQUENCIES));
        angles.map(|theta| self.demand(theta)).fold(still - self.damping, f64::max)
    }

    /// Returns the approximate stiffness (N/m) up to which the loop is stable without a hand, on a
    /// device with `damping` (N s/m): (b + B) / (T/2 + d). The linear condition of `[GS09]`: for a
    /// device of large mass, b T / m and B T / m much less than 1, and delays of few periods.
    pub fn linear_stiffness(&self, damping: f64) -> f64 {
        (damping + self.damping) / (0.5 * self.period + self.delay)
    }

    /// Returns the mass (kg) up to which a rendered mass without delay is passive on a device with
    /// `damping` (N s/m), rendered by second differences each `period` (s): b T / 2. The criterion
    /// of `[CS97]` with H(z) = M ((z − 1) / (T z))² demands −(2 M / T) sin(θ/2) sin(3 θ/2), which
    /// is largest, 2 M / T, at half the sampling rate.
    pub fn passive_mass(damping: f64, period: f64) -> f64 {
        0.5 * damping * period
    }

    fn whole_periods(&self) -> f64 {
        (self.delay / self.period).round()
    }
}

/// Dry friction, damping and encoder of a device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundedDevice {
    /// Damping b (N s/m).
    pub damping: f64,
    /// Coulomb friction f (N).
    pub coulomb: f64,
    /// Displacement Δ of one count (m); 0 for an encoder without steps.
    pub quantum: f64,
}

impl RoundedDevice {
    /// Returns the largest stiffness (N/m) of a wall without damping that is passive at `period`
    /// (s): the lesser of 2 b / T and 2 f / Δ. `[AO05]`: over one period with the displacement δ a
    /// held spring generates at most K δ²/2, which damping dissipates if b ≥ K T/2, and K Δ |δ|/2
    /// as its position is rounded, which friction dissipates if f ≥ K Δ/2.
    pub fn passive_stiffness(&self, period: f64) -> f64 {
        let held = 2.0 * self.damping / period;
        if self.quantum > 0.0 { held.min(2.0 * self.coulomb / self.quantum) } else { held }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const T: f64 = 1e-3;

    fn wall(stiffness: f64, damping: f64, periods: u32) -> SampledWall {
        SampledWall { stiffness, damping, period: T, delay: f64::from(periods) * T }
    }

    fn product((a, b): (f64, f64), (c, d): (f64, f64)) -> (f64, f64) {
        (a * c - b * d, a * d + b * c)
    }

    /// Returns the paper's criterion, in complex numbers, at the angle `theta`.
    fn criterion(wall: &SampledWall, theta: f64) -> f64 {
        let back = (theta.cos(), -theta.sin());
        let difference = (1.0 - back.0, -back.1);
        let rate = wall.damping / wall.period;
        let mut h = (wall.stiffness + rate * difference.0, rate * difference.1);
        let mut late = wall.delay;
        while 0.5 * wall.period < late {
            h = product(h, back);
            late -= wall.period;
        }
        0.5 * wall.period / (1.0 - theta.cos()) * product(difference, h).0
    }

    /// Returns its supremum on a grid that differs from the product's.
    fn supremum(wall: &SampledWall) -> f64 {
        let angles = (1..=3001).map(|it| PI * f64::from(it) / 3001.0);
        angles.map(|theta| criterion(wall, theta)).fold(f64::NEG_INFINITY, f64::max)
    }

    #[test]
    fn the_demand_is_the_criterion_of_the_paper_in_complex_numbers() {
        for wall in [wall(2e3, 0.0, 0), wall(2e3, 1.5, 0), wall(500.0, -0.7, 2), wall(0.0, 3.0, 5)]
        {
            for theta in [0.01, 0.3, 1.0, 2.2, PI] {
                let (ours, theirs) = (wall.demand(theta), criterion(&wall, theta));
                // 1 − cos θ loses four digits at 0.01.
                assert!((ours - theirs).abs() < 1e-9 * (1.0 + theirs.abs()), "{wall:?}: {theta}");
            }
        }
    }

    #[test]
    fn the_largest_passive_mass_is_that_of_the_criterion_in_complex_numbers() {
        let mass = SampledWall::passive_mass(1.0, T);
        let demand = |theta: f64| {
            let difference = (1.0 - theta.cos(), theta.sin());
            let cube = product(difference, product(difference, difference));
            0.5 * T / (1.0 - theta.cos()) * mass / (T * T) * cube.0
        };
        let angles = (1..=3001).map(|it| PI * f64::from(it) / 3001.0);
        let sup = angles.map(demand).fold(f64::NEG_INFINITY, f64::max);
        assert!((sup - 1.0).abs() < 1e-9, "{sup}");
    }

    #[test]
    fn without_delay_the_closed_form_is_the_supremum_over_all_frequencies() {
        for stiffness in [0.0, 300.0, 4e3] {
            for damping in [-2.0, -0.1, 0.0, 0.5, 3.0] {
                let wall = wall(stiffness, damping, 0);
                let (closed, sup) = (wall.passive_damping(), supremum(&wall));
                // The lowest frequency is π/3001 from zero: 1 − cos of it is 5e-7.
                assert!((closed - sup).abs() < 1e-5 * closed.max(1.0), "{wall:?}: {sup}");
            }
        }
    }

    #[test]
    fn with_delay_it_is_the_supremum_for_springs_and_never_below_it() {
        for periods in [1, 2, 7] {
            let spring = wall(1e3, 0.0, periods);
            let closed = 1e3 * T * (0.5 + f64::from(periods));
            assert!((spring.passive_damping() - closed).abs() < 1e-12);
            assert!((supremum(&spring) / closed - 1.0).abs() < 1e-3, "{periods}");
            for damping in [-3.0, 0.4, 3.0] {
                let wall = wall(1e3, damping, periods);
                assert!(supremum(&wall) <= wall.passive_damping() + 1e-9, "{wall:?}");
                // A few in a thousand between the two grids.
                let (ours, theirs) = (wall.largest_demand(), supremum(&wall));
                assert!((ours / theirs - 1.0).abs() < 5e-3, "{ours} against {theirs}");
            }
        }
    }

    #[test]
    fn the_stiffest_wall_is_where_the_damping_is_all_used() {
        let device = 2.5;
        let limit = SampledWall { stiffness: 0.0, damping: 0.5, period: T, delay: 0.7 * T };
        let limit = SampledWall { stiffness: limit.passive_stiffness(device), ..limit };
        assert!((limit.passive_damping() - device).abs() < 1e-12);
        assert!((limit.linear_stiffness(device) - 3.0 / 1.2e-3).abs() < 1e-9);
        let none = SampledWall { damping: -3.0, ..limit };
        assert!(none.passive_stiffness(device) < 0.0);
    }

    /// Returns the energy that a wall of `stiffness` generates on the closed path `samples` (m),
    /// less the device's dissipation: above zero if it is not passive.
    fn made(stiffness: f64, device: &RoundedDevice, samples: &[f64]) -> f64 {
        let next = samples.iter().cycle().skip(1);
        let steps = samples.iter().zip(next).map(|(from, to)| {
            let way = to - from;
            let read = (from / device.quantum).round() * device.quantum;
            // Least loss on that path within a period: at a constant speed.
            let lost = device.damping * way * way / T + device.coulomb * way.abs();
            -stiffness * read * way - lost
        });
        steps.sum()
    }

    const DEVICE: RoundedDevice = RoundedDevice { damping: 0.5, coulomb: 0.01, quantum: 1e-5 };

    #[test]
    fn a_key_across_one_edge_of_a_count_gains_energy_just_above_the_limit() {
        // Both terms of the limit are the same for this device: 2 b / T = 1 kN/m.
        let device = RoundedDevice { coulomb: 5e-3, ..DEVICE };
        let limit = device.passive_stiffness(T);
        assert!((limit - 1e3).abs() < 1e-9);
        let edge = 0.5 * device.quantum;
        let across = [edge * (1.0 + 1e-9), -edge * (1.0 + 1e-9)];
        assert!(made(1.001 * limit, &device, &across) > 0.0);
        assert!(made(0.999 * limit, &device, &across) < 0.0);
    }

    #[test]
    fn the_lesser_of_both_limits_counts_and_no_steps_mean_no_second_one() {
        assert!((DEVICE.passive_stiffness(T) - 1e3).abs() < 1e-9);
        let rough = RoundedDevice { quantum: 1e-4, ..DEVICE };
        assert!((rough.passive_stiffness(T) - 200.0).abs() < 1e-9);
        let smooth = RoundedDevice { quantum: 0.0, ..DEVICE };
        assert!((smooth.passive_stiffness(1e-4) - 1e4).abs() < 1e-9);
    }

    proptest! {
        #[test]
        fn no_way_through_any_samples_gains_energy_below_the_limit(
            samples in proptest::collection::vec(-5e-5..5e-5_f64, 2..40),
            quantum in 1e-7..1e-4_f64,
        ) {
            let device = RoundedDevice { quantum, ..DEVICE };
            let gained = made(device.passive_stiffness(T), &device, &samples);
            prop_assert!(gained <= 1e-15, "{gained} J");
        }
    }
}
