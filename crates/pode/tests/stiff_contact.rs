//! Cases C8 and C11: a hammer head on a stiff spring, linear and Hunt–Crossley.
//!
//! Error model, with r = ω h the part of a radian per step in contact: RK4 keeps a phase to
//! r⁴/120 and an amplitude to r⁶/144 per step. Its third-order dense output takes, for
//! x' = λx, the amplitude (τ²/8 − τ³/6 + τ⁴/24) r⁴ at an event, at most r⁴/69; a contact has
//! two events inside, the deepest point and the end. All relative; below that, the rounding
//! of the sums, 1e-12.

use pode::stepper::Rk4;
use pode::{
    Advance, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, Simulator,
};

use crate::common::head::{CONTACTS, Head, MASS, Mode, RADIANS};
use crate::common::{G, all_completed, close, each_step_and_phase, no_input, run};

/// Relative error of a time in contact.
fn phase_error() -> f64 {
    RADIANS.powi(4) / 120.0 + 1e-12
}

/// Relative error of a speed or a depth after `events` events in contact.
fn amplitude_error(events: f64) -> f64 {
    let steps = std::f64::consts::PI / RADIANS;
    events * RADIANS.powi(4) / 69.0 + steps * RADIANS.powi(6) / 144.0 + 1e-12
}

#[test]
fn a_contact_has_its_time_depth_and_period() {
    for [k, contact, depth, period] in CONTACTS {
        each_step_and_phase(|h, phase| {
            let (recorder, ticks) = run(&mut Head { k }.dropped(Rk4), h, phase, 0.5);
            all_completed(&ticks);
            let seen = recorder.events();
            let names: Vec<_> = seen.iter().take(4).map(|it| it.name).collect();
            assert_eq!(
                names,
                ["touch", "deepest", "leave", "touch"],
                "k {k}, h {h}, phase {phase}"
            );
            let at = |n: usize| seen[n].t;
            close("contact time", at(2) - at(0), contact, contact * phase_error());
            close("deepest point", -seen[1].before[0], depth, depth * amplitude_error(1.0));
            let tolerance = contact * phase_error() + (period - contact) * amplitude_error(2.0);
            close("period", at(3) - at(0), period, tolerance);
        });
    }
}

#[test]
fn the_head_leaves_as_fast_as_it_came() {
    for [k, ..] in CONTACTS {
        each_step_and_phase(|h, phase| {
            let (recorder, _) = run(&mut Head { k }.dropped(Rk4), h, phase, 0.5);
            close(
                format_args!("k {k}, h {h}"),
                recorder.events()[2].before[1],
                1.0,
                amplitude_error(2.0),
            );
        });
    }
}

#[test]
fn the_impulse_of_a_contact_within_one_tick_is_in_its_mean_force() {
    // The whole contact: the change of momentum, and the weight while it lasts. Simpson's
    // rule over each step errs by r⁴/2880 of it, less than the momentum does.
    for ([k, contact, ..], h) in CONTACTS.into_iter().zip([14e-3, 7e-3, 1e-3]) {
        let mut head = Head { k }.dropped(Rk4);
        let tick = head.advance(h, &no_input, &mut pode::Silent);
        assert_eq!((tick.advance, tick.work.events), (Advance::Completed, 3), "k {k}");
        let impulse = MASS * (2.0 + G * contact);
        close(
            format_args!("k {k}"),
            tick.mean_readout * h,
            impulse,
            impulse * amplitude_error(2.0),
        );
    }
}

#[test]
fn the_impulse_does_not_depend_on_how_ticks_cut_the_contact() {
    for [k, contact, ..] in CONTACTS {
        each_step_and_phase(|h, phase| {
            let (_, ticks) = run(&mut Head { k }.dropped(Rk4), h, phase, 0.1);
            let first = if phase > 0.0 { (1.0 - phase) * h } else { h };
            let rest: f64 = ticks[1..].iter().map(|tick| tick.mean_readout).sum();
            let impulse = first * ticks[0].mean_readout + h * rest;
            let expected = MASS * (2.0 + G * contact);
            let tolerance = expected * amplitude_error(2.0);
            close(format_args!("k {k}, h {h}, phase {phase}"), impulse, expected, tolerance);
        });
    }
}

#[test]
fn a_minute_of_contacts_keeps_the_energy() {
    let [k, _, _, period] = CONTACTS[1];
    let mut head = Head { k }.dropped(Rk4);
    let mut ticks = 0_u32;
    while f64::from(ticks) * 1e-3 < 60.0 || head.mode() == Mode::Contact {
        assert_eq!(head.advance(1e-3, &no_input, &mut pode::Silent).advance, Advance::Completed);
        ticks += 1;
    }
    let [x, v] = *head.state();
    let drift = v * v + 2.0 * G * x - 1.0;
    // Energy goes with the square of the amplitude.
    let tolerance = 60.0 / period * 2.0 * amplitude_error(2.0);
    close("energy", drift, 0.0, tolerance);
}

/// F = k xⁿ (1 + λ v), without gravity: penetration (m) and its rate (m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Felt {
    k: f64,
    lambda: f64,
    /// Longest step (s).
    step: f64,
}

/// Exponent of the felt.
const POWER: f64 = 1.5;

impl Model for Felt {
    /// Whether the felt is touched.
    type Mode = bool;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, touched: bool, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -self.readout(touched, x, &()) / MASS]
    }

    fn readout(&self, touched: bool, x: &[f64; 2], (): &()) -> f64 {
        if touched { self.k * x[0].max(0.0).powf(POWER) * (1.0 + self.lambda * x[1]) } else { 0.0 }
    }

    fn longest_step(&self, touched: bool) -> f64 {
        if touched { self.step } else { f64::INFINITY }
    }
}

impl Guarded for Felt {
    fn guards(&self, touched: bool) -> &'static [GuardSpec] {
        const TOUCHED: [GuardSpec; 2] =
            [GuardSpec::new(0, "leave").scaled(1e-3), GuardSpec::new(1, "deepest").on_crossing()];
        if touched { &TOUCHED } else { &[] }
    }

    fn guard(&self, touched: bool, id: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        match id.0 {
            0 => GuardValue::new(x[0], x[1]),
            _ => GuardValue::new(x[1], self.derivative(touched, x, &())[1]),
        }
    }
}

impl Resets for Felt {
    fn reset(&self, _: bool, id: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        Reset::to(id.0 != 0, *x)
    }
}

/// Exit speed, contact time (s) and deepest point (m) of a contact at `v0` in `n` steps.
fn contact(k: f64, lambda: f64, v0: f64, duration: f64, n: f64) -> [f64; 3] {
    let felt = Felt { k, lambda, step: duration / n };
    let mut head = Simulator::new(felt, Rk4, Limits::default(), true, [0.0, v0]);
    let (recorder, ticks) = run(&mut head, 2.0 * duration, 0.0, 2.0 * duration);
    all_completed(&ticks);
    assert_eq!(recorder.events().len(), 2);
    [recorder.events()[1].before[1], recorder.events()[1].t, recorder.events()[0].before[0]]
}

/// Relative error of Hunt–Crossley in `n` steps: the force starts and ends like t^1.5, of
/// which a step at either end misses a part of h^2.5; smooth steps err by less.
fn felt_error(n: f64) -> f64 {
    n.powf(-2.5)
}

#[test]
fn hunt_crossley_leaves_at_the_speed_of_its_invariant() {
    /// Loss λ (s/m), entry speed and exit speed (m/s); any stiffness.
    const EXITS: [[f64; 3]; 3] = [
        [0.1, 1.0, -0.937_475_579_949_905],
        [0.1, 5.0, -3.742_174_657_987_171],
        [0.6, 1.0, -0.711_950_179_577_866_2],
    ];
    for [lambda, v0, exit] in EXITS {
        for k in [1e5, 1e7] {
            // Contact time scales with (m / (k √v0))^0.4.
            let duration = 3.3 * (MASS / (k * v0.sqrt())).powf(0.4);
            for n in [50.0, 400.0] {
                let [found, ..] = contact(k, lambda, v0, duration, n);
                close(
                    format_args!("λ {lambda}, v0 {v0}, k {k}, n {n}"),
                    found,
                    exit,
                    v0 * felt_error(n),
                );
            }
        }
    }
}

#[test]
fn hunt_crossley_has_its_time_and_depth() {
    /// Stiffness, deepest point (m), contact time (s); λ = 0.6, v0 = 1.
    const FELTS: [[f64; 3]; 2] = [
        [1e5, 0.001_521_344_239_131, 0.005_332_605_765_715_331],
        [1e7, 0.000_241_116_812_798_9, 0.000_845_161_057_611_2],
    ];
    for [k, depth, time] in FELTS {
        for n in [50.0, 400.0] {
            let [_, t, x] = contact(k, 0.6, 1.0, time, n);
            close(format_args!("k {k}, n {n}: time"), t, time, time * felt_error(n));
            close(format_args!("k {k}, n {n}: depth"), x, depth, depth * felt_error(n));
        }
    }
}
