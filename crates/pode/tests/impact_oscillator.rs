//! A driven oscillator that hits a wall: x'' + x = β cos ωt, x ≥ σ, v⁺ = −r v⁻.
//!
//! Between impacts x is a sum of two sines in closed form. Error model, with R the radians per
//! step: RK4 keeps a phase to R⁴/120, the dense output takes R⁴/69 of the amplitude at each impact,
//! and an impact passes an error on, over its speed.

use pode::stepper::Rk4;
use pode::{
    Advance, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Nature, Reset, Resets,
    Simulator,
};
use proptest::prelude::*;

use crate::common::{all_completed, close, each_step_and_phase};
use crate::driven::{Clock, root, run_driven};

#[derive(Clone, Copy, Debug, PartialEq)]
struct Oscillator {
    drive: f64,
    omega: f64,
    restitution: f64,
    wall: f64,
}

const RADIANS: f64 = 0.005;

impl Oscillator {
    /// Returns γ: the forced motion is γ cos ωt.
    fn forced(&self) -> f64 {
        self.drive / (1.0 - self.omega * self.omega)
    }

    fn flown(&self, from: f64, x: [f64; 2], t: f64) -> [f64; 2] {
        let gamma = self.forced();
        let [(s0, c0), (s1, c1)] = [from, t].map(|t| (self.omega * t).sin_cos());
        let [a, b] = [x[0] - gamma * c0, x[1] + gamma * self.omega * s0];
        let (sin, cos) = (t - from).sin_cos();
        [a * cos + b * sin + gamma * c1, b * cos - a * sin - gamma * self.omega * s1]
    }

    /// Returns time and speed of the next sharp impact between `from` and `until`, if any.
    fn impact(&self, from: f64, x: [f64; 2], until: f64) -> Option<[f64; 2]> {
        let step = 2e-3 / self.omega.max(1.0);
        let gap = |t: f64| self.flown(from, x, t)[0] - self.wall;
        // An impact leaves with 1e-2 at least: a step later it is far above rounding.
        let mut t = from + step;
        while gap(t) > 0.0 {
            let is_graze = gap(t) < 1e-4 && self.flown(from, x, t)[1].abs() < 2e-2;
            if is_graze || t >= until {
                return None;
            }
            t += step;
        }
        let hit = root(t - step, t, gap);
        let speed = self.flown(from, x, hit)[1];
        (t < until && speed < -2e-2).then_some([hit, speed])
    }

    fn impacts(&self, mut x: [f64; 2], until: f64) -> Vec<[f64; 2]> {
        let mut impacts = vec![];
        let mut from = 0.0;
        while let Some([hit, speed]) = self.impact(from, x, until) {
            impacts.push([hit, speed]);
            (from, x) = (hit, [self.wall, -self.restitution * speed]);
            if x[1] < 1e-2 {
                break;
            }
        }
        impacts
    }

    fn start(self, x: [f64; 2]) -> Simulator<Self, Rk4> {
        Simulator::new(self, Rk4, Limits::default(), (), x)
    }
}

impl Model for Oscillator {
    type Mode = ();
    type State = [f64; 2];
    type Input = Clock;
    const COORDS: usize = 1;

    fn derivative(&self, (): (), x: &[f64; 2], t: &Clock) -> [f64; 2] {
        [x[1], self.drive * (self.omega * t.0).cos() - x[0]]
    }

    fn nature(&self, (): ()) -> Nature {
        Nature::default().with_longest_step(RADIANS / self.omega.max(1.0))
    }
}

impl Guarded for Oscillator {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        const WALL: [GuardSpec; 1] = [GuardSpec::new(0, "wall")];
        &WALL
    }

    fn guard(&self, (): (), _: GuardId, x: &[f64; 2], _: &Clock) -> GuardValue {
        GuardValue::new(x[0] - self.wall, x[1])
    }
}

impl Resets for Oscillator {
    fn reset(&self, (): (), _: GuardId, x: &[f64; 2], _: &Clock) -> Reset<Self> {
        Reset::to((), [self.wall, -self.restitution * x[1]])
    }
}

/// Returns phase of the drive and speed after the impact of the periodic orbit with one impact at σ
/// = 0 per `turns` periods of the drive. From x(0) = x(T) = 0 and v(0) = −r v(T): tan φ = −tan(T/2)
/// (1 − r) / (ω (1 + r)).
fn orbit(it: &Oscillator, turns: f64) -> [f64; 2] {
    let (gamma, r, omega) = (it.forced(), it.restitution, it.omega);
    let half = std::f64::consts::PI * turns / omega;
    let p = -half.sin() * (1.0 - r);
    let q = half.cos() * omega * (1.0 + r);
    let [a, b] = [p.atan2(q), (-p).atan2(-q)]
        .map(|phase| [phase, 2.0 * r / (1.0 - r) * gamma * omega * phase.sin()]);
    if a[1] > 0.0 { a } else { b }
}

#[track_caller]
fn check_orbit(omega: f64, turns: f64, restitution: f64) {
    let it = Oscillator { drive: 1.0, omega, restitution, wall: 0.0 };
    let [phase, speed] = orbit(&it, turns);
    let period = std::f64::consts::TAU * turns / omega;
    let t0 = phase / omega;
    assert!(
        (1..1000).all(|n| it.flown(t0, [0.0, speed], t0 + period * f64::from(n) / 1000.0)[0] > 0.0)
    );
    each_step_and_phase(|h, at| {
        let mut sim = it.start([0.0, speed]);
        let (recorder, ticks) = run_driven(&mut sim, (h, at), 8.5 * period, |t| Clock(t0 + t));
        all_completed(&ticks);
        assert_eq!(recorder.events().len(), 8, "ω {omega}, r {restitution}, h {h}");
        for (n, seen) in (1_u32..).zip(recorder.events()) {
            let n = f64::from(n);
            // A stable orbit forgets errors; each period adds its own once or a few times.
            let tolerance = 10.0 * (period * RADIANS.powi(4) / 120.0 + RADIANS.powi(4) / 69.0);
            close(
                format_args!("ω {omega}, r {restitution}, h {h}, impact {n}"),
                seen.t,
                n * period,
                tolerance,
            );
            close("speed", seen.after[1], speed, 10.0 * tolerance);
        }
    });
}

#[test]
fn orbits_with_one_impact_per_drive_period_are_kept() {
    for r in [0.5, 0.8] {
        // ω = 2n: half a period of the free motion, where the phase is ±π/2 for any r.
        for (omega, turns) in [(2.0, 1.0), (4.0, 2.0), (6.0, 3.0), (2.5, 1.0), (1.8, 1.0)] {
            check_orbit(omega, turns, r);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn impacts_are_those_of_the_closed_form(
        drive in 0.2..2.0,
        omega in prop_oneof![0.3..0.9, 1.1..6.0],
        restitution in 0.3..1.0,
        wall in -1.0..0.5,
        height in 0.1..1.0,
        speed in -1.0..1.0,
        h in prop_oneof![Just(1e-4), Just(1e-3), Just(7e-3)],
        phase in prop_oneof![Just(0.0), Just(1.0 / 3.0), Just(0.999)],
    ) {
        const UNTIL: f64 = 15.0;
        let it = Oscillator { drive, omega, restitution, wall };
        let x = [wall + height, speed];
        let expected: Vec<_> = it.impacts(x, UNTIL).into_iter().take(8).collect();
        let until = expected.last().map_or(0.05, |last| last[0] + 1e-6);
        let (recorder, ticks) = run_driven(&mut it.start(x), (h, phase), until, Clock);
        prop_assert!(ticks.iter().all(|tick| tick.advance == Advance::Completed));
        prop_assert_eq!(recorder.events().len(), expected.len());
        // An error of the phase meets the wall at this impact's speed, and leaves as an error of
        // the speed times the acceleration.
        let size = drive / (1.0 - omega * omega).abs() * (1.0 + omega) + height + speed.abs() + 1.0;
        let mut error = 1e-13;
        let mut before = 0.0;
        for (seen, [t, speed]) in recorder.events().iter().zip(&expected) {
            let fresh = size * RADIANS.powi(4) * (0.02 + (t - before) / 120.0);
            error = (1.0 + (1.0 + size) / speed.abs()) * (error + fresh);
            prop_assert!((seen.t - t).abs() < error, "{} is not {}: {:e}, {:e}", seen.t, t, seen.t - t, error);
            before = *t;
            if error > 1e-4 {
                break;
            }
        }
    }
}
