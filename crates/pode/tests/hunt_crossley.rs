//! Case C11 and its family: F = k xⁿ (1 + λv), for any n, λ, k and speed.
//!
//! With u = 1 + λv, u − ln u + (k λ² / m) xⁿ⁺¹ / (n + 1) is conserved: exit speed and depth are
//! closed forms. Error model: steps have a tolerance of 1e-13 each, in the unit of each entry; a
//! contact takes some 100 of them, and the force's xⁿ at both ends, which no method follows at its
//! order, some more.

use pode::stepper::{Controlled, Dop853, Tolerance};
use pode::{GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, Simulator};
use proptest::prelude::*;

use crate::common::{all_completed, close, each_step_and_phase, run};
use crate::driven::root;

/// A mass (kg) against a felt: penetration and its rate, in units of the closed form's depth and of
/// the entry speed, so that tolerances mean the same for every k.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Felt {
    mass: f64,
    k: f64,
    power: f64,
    lambda: f64,
    speed: f64,
}

impl Felt {
    fn invariant(&self) -> f64 {
        let v = self.lambda * self.speed;
        v - v.ln_1p()
    }

    fn exit(&self) -> f64 {
        let target = self.invariant();
        // v − ln(1 + v) falls from +∞ at −1 to 0 at 0.
        root(-1.0 + 1e-15, 0.0, |v| v - v.ln_1p() - target) / self.lambda
    }

    fn depth(&self) -> f64 {
        let one = self.power + 1.0;
        (self.mass * one * self.invariant() / (self.k * self.lambda * self.lambda)).powf(1.0 / one)
    }
}

impl Model for Felt {
    type Mode = bool;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, touched: bool, x: &[f64; 2], (): &()) -> [f64; 2] {
        let force = self.readout(touched, x, &());
        [x[1] * self.speed / self.depth(), -force / self.mass / self.speed]
    }

    fn readout(&self, touched: bool, x: &[f64; 2], (): &()) -> f64 {
        if !touched {
            return 0.0;
        }
        let loss = 1.0 + self.lambda * self.speed * x[1];
        self.k * (self.depth() * x[0].max(0.0)).powf(self.power) * loss
    }
}

impl Guarded for Felt {
    fn guards(&self, touched: bool) -> &'static [GuardSpec] {
        const FREE: [GuardSpec; 1] = [GuardSpec::new(0, "touch")];
        const TOUCHED: [GuardSpec; 2] =
            [GuardSpec::new(1, "leave"), GuardSpec::new(2, "deepest").on_crossing()];
        if touched { &TOUCHED } else { &FREE }
    }

    fn guard(&self, touched: bool, id: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        let [rate, acceleration] = self.derivative(touched, x, &());
        match id.0 {
            0 => GuardValue::new(-x[0], -rate),
            1 => GuardValue::new(x[0], rate),
            _ => GuardValue::new(x[1], acceleration),
        }
    }
}

impl Resets for Felt {
    fn reset(&self, touched: bool, id: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        match id.0 {
            0 => Reset::to(true, [0.0, x[1]]),
            1 => Reset::to(false, [0.0, x[1]]),
            _ => Reset::to(touched, *x),
        }
    }
}

/// Returns exit speed (m/s), depth (m), contact time (s), impulse (N s); touched after 2 ms.
fn contact(felt: Felt, h: f64, phase: f64, until: f64) -> [f64; 4] {
    let method = Controlled { method: Dop853, tolerance: Tolerance::both(1e-13) };
    let start = [-2e-3 * felt.speed / felt.depth(), 1.0];
    let mut it = Simulator::new(felt, method, Limits::default(), false, start);
    let (recorder, ticks) = run(&mut it, h, phase, until);
    all_completed(&ticks);
    let seen = recorder.events();
    let names: Vec<_> = seen.iter().map(|seen| seen.name).collect();
    assert_eq!(names, ["touch", "deepest", "leave"], "{felt:?}, h {h}, phase {phase}");
    let first = if phase > 0.0 { (1.0 - phase) * h } else { h };
    let rest: f64 = ticks[1..].iter().map(|tick| tick.mean_readout).sum();
    let impulse = first * ticks[0].mean_readout + h * rest;
    let speed = seen[2].before[1] * felt.speed;
    [speed, seen[1].before[0] * felt.depth(), seen[2].t - seen[0].t, impulse]
}

/// Relative: a hundred steps of 1e-13, and some more.
const ERROR: f64 = 1e-10;

#[test]
fn c11_at_every_step_and_phase() {
    /// Loss λ (s/m), entry speed, exit speed (m/s).
    const EXITS: [[f64; 3]; 3] = [
        [0.1, 1.0, -0.937_475_579_949_905],
        [0.1, 5.0, -3.742_174_657_987_171],
        [0.6, 1.0, -0.711_950_179_577_866_2],
    ];
    for [lambda, speed, exit] in EXITS {
        for k in [1e5, 1e7] {
            let felt = Felt { mass: 0.01, k, power: 1.5, lambda, speed };
            close("the closed form", felt.exit(), exit, 2e-15 * speed);
            each_step_and_phase(|h, phase| {
                let [found, depth, _, impulse] = contact(felt, h, phase, 0.03);
                let what = |name: &str| format!("{name}, {felt:?}, h {h}, phase {phase}");
                close(what("exit"), found, exit, ERROR * speed);
                close(what("depth"), depth, felt.depth(), ERROR * felt.depth());
                let expected = felt.mass * (speed - exit);
                // The readout's own quadrature, over steps that end where xⁿ begins.
                close(what("impulse"), impulse, expected, 1e-7 * expected);
            });
        }
    }
}

#[test]
fn c11_has_its_times_and_depths() {
    /// Stiffness, deepest point (m), contact time (s); λ = 0.6, v0 = 1.
    const FELTS: [[f64; 3]; 2] = [
        [1e5, 0.001_521_344_239_131_188_8, 0.005_332_605_765_715_331],
        [1e7, 0.000_241_116_812_798_895_35, 0.000_845_161_057_611_2],
    ];
    for [k, depth, time] in FELTS {
        let felt = Felt { mass: 0.01, k, power: 1.5, lambda: 0.6, speed: 1.0 };
        close("the closed form", felt.depth(), depth, 1e-15 * depth);
        each_step_and_phase(|h, phase| {
            let [_, found, t, _] = contact(felt, h, phase, 0.03);
            close(format_args!("depth, h {h}, phase {phase}"), found, depth, ERROR * depth);
            close(format_args!("time, h {h}, phase {phase}"), t, time, ERROR * time);
        });
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_felt_gives_back_what_its_invariant_says(
        power in 1.0..3.5,
        lambda in 0.01..2.0,
        speed in 0.05..8.0,
        exponent in 4.0..9.0,
        h in prop_oneof![Just(1e-4), Just(1e-3), Just(7e-3)],
        phase in prop_oneof![Just(0.0), Just(1.0 / 3.0), Just(0.999)],
    ) {
        let felt = Felt { mass: 0.01, k: 10_f64.powf(exponent), power, lambda, speed };
        // At most five times the duration at its entry speed.
        let until = 4e-3 + 20.0 * felt.depth() / -felt.exit();
        prop_assume!(until < 2.0);
        let [exit, depth, ..] = contact(felt, h, phase, until);
        close("exit", exit, felt.exit(), 10.0 * ERROR * speed);
        close("depth", depth, felt.depth(), 10.0 * ERROR * felt.depth());
    }
}
