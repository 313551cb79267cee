//! Cases C8 and C9 on the exact flow: events and energy to rounding, at any stiffness.
//!
//! Error model: each step rounds by ε/2 of the largest term, at worst always in one direction (a
//! fall adds the same g h each time). The time of an event inherits the rounding of the height over
//! the speed there, which is of the same size.

use pode::stepper::Exact;
use pode::{Advance, Silent};

use crate::common::head::{CONTACTS, Head, MASS, Mode};
use crate::common::{G, all_completed, close, each_step_and_phase, no_input, run};

const EXACT: Exact = Exact;

/// Returns v² + 2 g x of a head in the air: 1 m²/s² at the start.
fn energy([x, v]: [f64; 2]) -> f64 {
    v * v + 2.0 * G * x
}

/// Returns the rounding of a speed of 1 m/s in 2 s of steps of `h` (s).
fn rounding(h: f64) -> f64 {
    1e-14 + 2.0 / h * 0.5 * f64::EPSILON
}

#[test]
fn a_contact_has_its_time_depth_and_period() {
    for [k, contact, depth, period] in CONTACTS {
        each_step_and_phase(|h, phase| {
            let what = |name: &str| format!("{name}, k {k}, h {h}, phase {phase}");
            let (recorder, ticks) = run(&mut Head { k }.dropped(EXACT), h, phase, 2.0);
            all_completed(&ticks);
            let seen = recorder.events();
            for bounce in seen.chunks_exact(3).take(8) {
                let names: Vec<_> = bounce.iter().map(|it| it.name).collect();
                assert_eq!(names, ["touch", "deepest", "leave"]);
                close(what("contact"), bounce[2].t - bounce[0].t, contact, 2e-15);
                close(what("depth"), -bounce[1].before[0], depth, 1e-15);
                close(what("exit speed"), bounce[2].before[1], 1.0, rounding(h));
            }
            for (n, bounce) in seen.chunks_exact(3).enumerate() {
                close(what("period"), bounce[0].t - seen[0].t, n as f64 * period, rounding(h));
            }
        });
    }
}

#[test]
fn twenty_seconds_at_the_stiffest_keep_events_and_energy() {
    let [k, _, _, period] = CONTACTS[2];
    for phase in crate::common::PHASES {
        let mut head = Head { k }.dropped(EXACT);
        let (recorder, ticks) = run(&mut head, 1e-3, phase, 20.0);
        all_completed(&ticks);
        let touches: Vec<_> = recorder.events().iter().filter(|it| it.name == "touch").collect();
        assert_eq!(touches.len(), 99);
        for (n, touch) in touches.iter().enumerate() {
            close(format_args!("touch {n}"), touch.t - touches[0].t, n as f64 * period, 1e-11);
        }
        assert_eq!(head.mode(), Mode::Flight);
        close("energy", energy(*head.state()), 1.0, 1e-12);
    }
}

#[test]
fn the_impulse_of_a_contact_is_in_the_mean_force_however_ticks_cut_it() {
    for [k, contact, ..] in CONTACTS {
        each_step_and_phase(|h, phase| {
            let (_, ticks) = run(&mut Head { k }.dropped(EXACT), h, phase, 0.1);
            let first = if phase > 0.0 { (1.0 - phase) * h } else { h };
            let rest: f64 = ticks[1..].iter().map(|tick| tick.mean_readout).sum();
            let impulse = first * ticks[0].mean_readout + h * rest;
            // Six places per step of 1 rad leave 1e-11 of a sine.
            let expected = MASS * (2.0 + G * contact);
            close(format_args!("k {k}, h {h}, phase {phase}"), impulse, expected, 1e-11 * expected);
        });
    }
}

#[test]
fn a_contact_within_one_tick_takes_few_steps() {
    let [k, ..] = CONTACTS[2];
    let tick = Head { k }.dropped(EXACT).advance(1e-3, &no_input, &mut Silent);
    assert_eq!((tick.advance, tick.work.events), (Advance::Completed, 3));
    assert!(tick.work.pieces <= 8, "{:?}", tick.work);
}
