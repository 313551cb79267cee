//! Case C10: a threshold under an input that is quantised and noisy.
//!
//! Hysteresis is the model's: a switch that fires at its threshold fires there again only after the
//! input has been a band's width beyond it. Separate thresholds would also do, but fire late by
//! half their distance.
//!
//! Error model: a reading is off by e at most. A reconstruction amplifies it to λe within a tick,
//! its noise gain. A transition errs by that over the input's speed, by the tick, and by the
//! reconstruction's latency. With a band of 2λe no noise can fire twice.

use pode::input::{Cubic, Reconstruction, Reconstructor};
use pode::stepper::Rk4;
use pode::{
    Advance, Event, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Motion, Reset, Resets,
    Signal as _, Simulator, Watch,
};

use crate::common::{PHASES, STEPS, close};

#[derive(Clone, Copy, Debug, PartialEq)]
struct Switch {
    threshold: f64,
    band: f64,
}

/// Side of the threshold on which the input is, and whether it has been a band beyond.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Mode {
    high: bool,
    fresh: bool,
}

/// Guards: back through the threshold, a band beyond it, a band behind it.
const BACK: GuardSpec = GuardSpec::new(0, "back");
const BEYOND: GuardSpec = GuardSpec::new(1, "beyond");
const BEHIND: GuardSpec = GuardSpec::new(2, "behind");

impl Model for Switch {
    type Mode = Mode;
    type State = [f64; 1];
    type Input = Motion;
    const COORDS: usize = 1;

    fn derivative(&self, _: Mode, _: &[f64; 1], _: &Motion) -> [f64; 1] {
        [0.0]
    }
}

impl Guarded for Switch {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        if mode.fresh { &[BEYOND, BEHIND] } else { &[BACK] }
    }

    fn guard(&self, mode: Mode, id: GuardId, _: &[f64; 1], u: &Motion) -> GuardValue {
        let sign = if mode.high { 1.0 } else { -1.0 };
        let (far, rate) = (sign * (u.position - self.threshold), sign * u.rate);
        match id {
            id if id == BACK.id => GuardValue::new(far, rate),
            id if id == BEYOND.id => GuardValue::new(self.band - far, -rate),
            _ => GuardValue::new(far + self.band, rate),
        }
    }
}

impl Resets for Switch {
    fn reset(&self, mode: Mode, id: GuardId, x: &[f64; 1], _: &Motion) -> Reset<Self> {
        let next = match id {
            id if id == BACK.id => Mode { high: !mode.high, fresh: true },
            id if id == BEYOND.id => Mode { fresh: false, ..mode },
            _ => Mode { high: !mode.high, fresh: false },
        };
        Reset::to(next, *x)
    }
}

#[derive(Debug)]
struct Transitions {
    h: f64,
    phase: f64,
    seen: Vec<(f64, bool)>,
}

impl Watch<Switch> for Transitions {
    fn event(&mut self, _: &Switch, event: &Event<'_, Switch>) {
        if event.before.0.high != event.after.0.high {
            let t = (event.tick as f64 - self.phase + event.theta) * self.h;
            self.seen.extend([(t, event.after.0.high)]);
        }
    }
}

/// One encoder count of the paper (rad).
const QUANTUM: f64 = 1.309e-3;

/// A reading of `s` in whole counts, and its largest error in counts.
#[derive(Clone, Copy, Debug)]
enum Encoder {
    /// Noise of half a count before rounding.
    Before,
    /// Rounded, and then one count up, down or neither.
    After,
    Quiet,
}

impl Encoder {
    const fn error(self) -> f64 {
        match self {
            Self::Before => 1.0,
            Self::After => 1.5,
            Self::Quiet => 0.5,
        }
    }

    fn read(self, s: f64, noise: &mut Noise) -> f64 {
        let counts = s / QUANTUM;
        let counts = match self {
            Self::Before => (counts + noise.next(101) / 100.0 - 0.5).round(),
            Self::After => counts.round() + noise.next(3) - 1.0,
            Self::Quiet => counts.round(),
        };
        counts * QUANTUM
    }
}

struct Noise(u64);

impl Noise {
    fn next(&mut self, n: u32) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % u64::from(n)) as f64
    }
}

const KINDS: [Reconstruction; 4] = [
    Reconstruction::Hold,
    Reconstruction::Linear,
    Reconstruction::Quadratic,
    Reconstruction::LateHermite,
];

/// Returns λ, the amplification of an error of 1 in every sample.
fn gain(kind: Reconstruction) -> f64 {
    let respond = |impulse: usize, theta: f64| {
        let mut it = Reconstructor::new(kind, 0.0, 1.0);
        let mut cubic = Cubic::new([0.0; 4], 1.0);
        for n in 0..4 {
            cubic = it.push(if n == impulse { 1.0 } else { 0.0 });
        }
        cubic.at(theta).position.abs()
    };
    (0..=100)
        .map(|part| (0..4).map(|n| respond(n, f64::from(part) / 100.0)).sum())
        .fold(0.0, f64::max)
}

#[derive(Clone, Copy, Debug)]
struct Setup {
    kind: Reconstruction,
    encoder: Encoder,
    band: f64,
    h: f64,
    phase: f64,
    seed: u64,
}

impl Setup {
    #[track_caller]
    fn transitions(&self, s: impl Fn(f64) -> f64, until: f64) -> Vec<(f64, bool)> {
        let mut noise = Noise(self.seed);
        let time = |n: f64| (n - self.phase) * self.h;
        let mut reconstructor = Reconstructor::new(self.kind, s(time(-4.0)), self.h);
        for n in -4..0 {
            let _ = reconstructor.push(self.encoder.read(s(time(f64::from(n))), &mut noise));
        }
        let switch = Switch { threshold: 0.1, band: self.band * QUANTUM };
        let mode = Mode { high: s(0.0) > 0.1, fresh: false };
        let mut it = Simulator::new(switch, Rk4, Limits::default(), mode, [0.0]);
        let mut watch = Transitions { h: self.h, phase: self.phase, seen: Vec::new() };
        while time(it.tick() as f64) < until {
            let sample = self.encoder.read(s(time(it.tick() as f64)), &mut noise);
            let tick = it.advance(self.h, &reconstructor.push(sample), &mut watch);
            assert_eq!(tick.advance, Advance::Completed, "{self:?}");
        }
        watch.seen
    }

    fn latency(&self) -> f64 {
        if self.kind == Reconstruction::LateHermite { self.h } else { 0.0 }
    }
}

fn sine(t: f64) -> f64 {
    0.3 * (std::f64::consts::TAU * t).sin()
}

fn first() -> f64 {
    (0.1_f64 / 0.3).asin() / std::f64::consts::TAU
}

fn speed() -> f64 {
    std::f64::consts::TAU * (0.09_f64 - 0.01).sqrt()
}

#[track_caller]
fn check_sine(setup: Setup, periods: u32, tolerance: f64) {
    let seen = setup.transitions(sine, f64::from(periods));
    assert_eq!(seen.len(), 2 * periods as usize, "{setup:?}: {seen:?}");
    for (pair, n) in seen.chunks_exact(2).zip(0_u32..) {
        assert_eq!((pair[0].1, pair[1].1), (true, false), "{setup:?}");
        let n = f64::from(n) + setup.latency();
        close(format_args!("{setup:?}: up"), pair[0].0, n + first(), tolerance);
        close(format_args!("{setup:?}: down"), pair[1].0, n + 0.5 - first(), tolerance);
    }
}

#[test]
fn c10_a_held_noisy_sine_has_two_transitions_a_period_in_time() {
    let kind = Reconstruction::Hold;
    for encoder in [Encoder::Quiet, Encoder::Before, Encoder::After] {
        for seed in 0..50 {
            let setup = Setup { kind, encoder, band: 3.0, h: 1e-3, phase: 0.0, seed };
            check_sine(setup, 10, 1e-3 + QUANTUM / speed());
        }
    }
}

#[test]
fn two_transitions_a_period_at_any_step_phase_and_reconstruction() {
    for kind in KINDS {
        for encoder in [Encoder::Before, Encoder::After] {
            for (h, phase) in STEPS.into_iter().flat_map(|h| PHASES.map(|phase| (h, phase))) {
                let error = gain(kind) * encoder.error();
                let setup = Setup { kind, encoder, band: 2.0 * error, h, phase, seed: 7 };
                // Over this time the speed changes by less than a tenth.
                check_sine(setup, 4, h + 1.1 * error * QUANTUM / speed());
            }
        }
    }
}

#[test]
fn c10_a_slow_drift_has_one_transition_with_two_quanta() {
    let drift = |t: f64| 0.1 - 4.0 * QUANTUM + 1e-4 * t;
    let until = 8.0 * QUANTUM / 1e-4;
    for (kind, h) in KINDS.into_iter().flat_map(|kind| [1e-3, 7e-3].map(|h| (kind, h))) {
        for phase in PHASES {
            for sign in [1.0, -1.0] {
                let band = 2.0 * gain(kind);
                let setup = Setup { kind, encoder: Encoder::Before, band, h, phase, seed: 3 };
                let slope = |t: f64| 0.1 + sign * (drift(t) - 0.1);
                let seen = setup.transitions(slope, until);
                assert_eq!(seen.len(), 1, "{setup:?}: {seen:?}");
                assert_eq!(seen[0].1, sign > 0.0, "{setup:?}");
                let tolerance = 2.0 * h + gain(kind) * QUANTUM / 1e-4;
                close(format_args!("{setup:?}"), seen[0].0, 0.5 * until, tolerance);
            }
        }
    }
}

#[test]
fn a_reading_that_is_held_needs_two_quanta_and_no_more() {
    let drift = |t: f64| 0.1 - 4.0 * QUANTUM + 1e-3 * t;
    let number = |band: f64| {
        let kind = Reconstruction::Hold;
        let setup = Setup { kind, encoder: Encoder::Before, band, h: 1e-3, phase: 0.0, seed: 3 };
        setup.transitions(drift, 8.0 * QUANTUM / 1e-3).len()
    };
    assert_eq!(number(2.0), 1);
    // With no band, and with half a quantum, noise fires: these tests can fail.
    assert!(number(0.0) > 20, "{}", number(0.0));
    assert!(number(0.5) > 1, "{}", number(0.5));
}
