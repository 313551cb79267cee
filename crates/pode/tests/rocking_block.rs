//! A rocking block: two edges, an impact at each change between them.
//!
//! With θ in parts of the angle α at which it would fall, φ'' = p² (φ − sign φ), and at
//! φ = 0 the block goes over to its other edge with φ' → r φ'. From rest at φ it comes down
//! after (1/p) acosh(1/(1 − φ)), a quarter of a period `[Hou63]`, and rises to the next φ with
//! 1 − φ₊ = √(1 − r² (1 − (1 − φ)²)). The impacts accumulate: φ goes like r², its quarter
//! periods in the end like r.
//!
//! Error model, with R = p h the step: RK4 errs by R⁴/120 of a time and its dense output by
//! R⁴/69 of the distance to the fall, 1, at an impact.

#![allow(clippy::disallowed_macros, reason = "a test may use the heap")]
#![allow(clippy::disallowed_methods, reason = "a test may use the heap")]

use pode::stepper::Rk4;
use pode::{
    Advance, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, Simulator,
};
use proptest::prelude::*;

use crate::common::{all_completed, close, each_step_and_phase, no_input, run};

#[derive(Clone, Copy, Debug, PartialEq)]
struct Block {
    /// p (rad/s).
    p: f64,
    restitution: f64,
}

/// The edge on which the block stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edge {
    Right,
    Left,
}

impl Edge {
    const fn sign(self) -> f64 {
        match self {
            Self::Right => 1.0,
            Self::Left => -1.0,
        }
    }

    const fn other(self) -> Self {
        match self {
            Self::Right => Self::Left,
            Self::Left => Self::Right,
        }
    }
}

/// Part of 1/p that one step may take.
const PART: f64 = 0.01;

impl Model for Block {
    type Mode = Edge;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, edge: Edge, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], self.p * self.p * (x[0] - edge.sign())]
    }

    fn readout(&self, _: Edge, _: &[f64; 2], (): &()) -> f64 {
        0.0
    }

    fn longest_step(&self, _: Edge) -> f64 {
        PART / self.p
    }
}

impl Guarded for Block {
    fn guards(&self, _: Edge) -> &'static [GuardSpec] {
        const FLAT: [GuardSpec; 1] = [GuardSpec::new(0, "flat")];
        &FLAT
    }

    fn guard(&self, edge: Edge, _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(edge.sign() * x[0], edge.sign() * x[1])
    }
}

impl Resets for Block {
    fn reset(&self, edge: Edge, _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        Reset::to(edge.other(), [0.0, self.restitution * x[1]])
    }
}

impl Block {
    fn quarter(&self, angle: f64) -> f64 {
        (1.0 / (1.0 - angle)).acosh() / self.p
    }

    /// The angle to which it rises after an impact that it came down to from `angle`.
    fn rise(&self, angle: f64) -> f64 {
        let left = 1.0 - angle;
        let speed = self.restitution * self.restitution * (1.0 - left * left);
        // 1 − √(1 − s), without a loss of digits.
        speed / (1.0 + (1.0 - speed).sqrt())
    }

    /// Times and speeds (before, per p) of the first `n` impacts from rest at `angle`.
    fn impacts(&self, mut angle: f64, n: usize) -> Vec<[f64; 2]> {
        let mut t = self.quarter(angle);
        let mut impacts = vec![];
        for _ in 0..n {
            impacts.push([t, (1.0 - (1.0 - angle).powi(2)).sqrt()]);
            angle = self.rise(angle);
            t += 2.0 * self.quarter(angle);
        }
        impacts
    }

    fn released(self, angle: f64) -> Simulator<Self, Rk4> {
        let edge = if angle > 0.0 { Edge::Right } else { Edge::Left };
        Simulator::new(self, Rk4, Limits::default(), edge, [angle, 0.0])
    }
}

/// Asserts the first `n` impacts from `angle`.
#[track_caller]
fn check(block: Block, angle: f64, n: usize, (h, phase): (f64, f64)) {
    // As long as they do not pile up within one tick.
    let mut expected = block.impacts(angle.abs(), n);
    let apart = expected.windows(2).take_while(|pair| pair[1][0] - pair[0][0] > 0.1 * h).count();
    expected.truncate(apart + 1);
    let until = expected[apart][0] + 0.5 * h;
    let (recorder, ticks) = run(&mut block.released(angle), h, phase, until);
    all_completed(&ticks[..ticks.len() - 1]);
    assert!(recorder.events().len() > apart, "{block:?}, {angle}: {}", recorder.events().len());
    let [mut error, mut lost] = [1e-13, 0.0];
    let mut edge = if angle > 0.0 { Edge::Right } else { Edge::Left };
    for (seen, [t, speed]) in recorder.events().iter().zip(&expected) {
        // Of the distance 1 to the fall, the angle errs by one part at each impact, which its
        // speed makes a time; the speed errs too, which the next flight takes twice.
        let part = 2.0 * PART.powi(4) / 69.0;
        error += PART.powi(4) * t / 120.0 + part / (block.p * speed) + 2.0 * lost / block.p;
        lost += part;
        close(format_args!("{block:?}, {angle}, h {h}, phase {phase}"), seen.t, *t, error);
        edge = edge.other();
        assert_eq!(seen.to, edge, "it changes its edge");
    }
}

#[test]
fn a_block_rocks_in_the_periods_of_housner() {
    let block = Block { p: 2.14, restitution: 0.9 };
    for angle in [0.9, 0.5, 0.1, -0.3] {
        each_step_and_phase(|h, phase| check(block, angle, 10, (h, phase)));
    }
}

#[test]
fn a_block_that_loses_nothing_rocks_for_ever() {
    let block = Block { p: 3.0, restitution: 1.0 };
    each_step_and_phase(|h, phase| check(block, 0.4, 40, (h, phase)));
}

#[test]
fn a_block_beyond_its_angle_falls_and_never_returns() {
    let (recorder, ticks) =
        run(&mut Block { p: 2.0, restitution: 0.9 }.released(1.01), 1e-3, 0.0, 3.0);
    all_completed(&ticks);
    assert!(recorder.events().is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_block_rocks_so(
        p in 0.5..6.0,
        restitution in 0.5..1.0,
        angle in prop_oneof![0.01..0.95, -0.95..-0.01],
        h in 1e-4..7e-3,
        phase in prop_oneof![Just(0.0), Just(1.0 / 3.0), Just(0.999)],
    ) {
        check(Block { p, restitution }, angle, 8, (h, phase));
        prop_assert!(true);
    }

    #[test]
    fn an_accumulation_that_nobody_declared_costs_bounded_work(
        restitution in 0.1..0.9,
        angle in 0.1..0.9,
        h in 1e-4..7e-3,
    ) {
        let block = Block { p: 2.0, restitution };
        let mut it = block.released(angle);
        let ratio = block.restitution;
        let end = 4.0 * block.quarter(angle) / (1.0 - ratio) + 0.1;
        let mut ticks = 0_u32;
        while f64::from(ticks) * h < end {
            let tick = it.advance(h, &no_input, &mut pode::Silent);
            prop_assert!(!matches!(tick.advance, Advance::Faulty(_)), "{:?}", tick);
            ticks += 1;
        }
        // Wherever it was given up, it lies on the ground.
        prop_assert!(it.state()[0].abs() < 1e-9, "{:?} {:?}", it.mode(), it.state());
    }
}
