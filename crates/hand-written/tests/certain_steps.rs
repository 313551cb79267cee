//! How many steps of a played stroke are certain to hide no crossing.

#![expect(
    clippy::expect_used,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a test fails aloud, and counts of ticks are small"
)]

use hand_written::{KeyHammerRigid, KeyHammerSprings, ReducedGrand};
use models::Playable;
use pode::input::Cubic;
use pode::stepper::Rk4;
use pode::{Advance, Limits, Motion, Silent, Simulator, Work};

use crate::common::Case;
use crate::every_model::with_all;
use crate::stroke::{presses, still, values};

/// Certain steps over all.
fn share(work: &Work) -> f64 {
    f64::from(work.certain) / f64::from(work.certain + work.unknown)
}

/// Runs `model` from `start` with ticks of `h` until `until` (s), under a cubic per tick through
/// `input` and its rate at both ends; returns the work of the ticks without an event.
fn count<M: Playable>(
    model: M,
    start: (M::Mode, M::State),
    (h, until): (f64, f64),
    input: impl Fn(f64) -> Motion,
) -> Work {
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), start.0, start.1);
    let mut quiet = Work::default();
    let ends: Vec<_> =
        (0..=(until / h).round() as u32).map(|tick| input(f64::from(tick) * h)).collect();
    for pair in ends.windows(2) {
        let signal =
            Cubic::hermite(pair[0].position, pair[0].rate, pair[1].position, pair[1].rate, h);
        let done = simulator.advance(h, &signal, &mut Silent);
        assert_eq!(done.advance, Advance::Completed);
        if done.work.events == 0 {
            quiet = quiet.plus(done.work);
        }
    }
    quiet
}

/// Of the ticks without an event, nearly all steps are certain: all but those in which a guard
/// is as near to zero as it can go in one.
#[track_caller]
fn check(label: &str, quiet: &Work) {
    assert!(share(quiet) > 0.995, "{label}: {quiet:?}");
}

#[test]
fn most_steps_of_a_played_stroke_are_certain() {
    with_all!(strokes_are_certain);
}

fn strokes_are_certain<M: Playable>(model: M) {
    let entry = model.entry();
    let preset = entry.presets.last().expect("a preset");
    let model = model.with_values(&values(preset, entry.parameters.len(), 40));
    let scale = model.input_per_metre();
    let press = [[0.0098 * scale, 0.15, 0.02], [-0.0098 * scale, 0.5, 0.02]];
    for h in [1e-3, 2.5e-4] {
        let start = model.at_rest(&presses(&press, 0.0));
        let quiet = count(model, start, (h, 1.0), |t| presses(&press, t));
        check(&format!("{} stroke {h}", entry.name), &quiet);
    }
}

#[test]
fn most_steps_of_the_references_are_certain() {
    references_are_certain::<KeyHammerRigid>("model-a-two-throws");
    references_are_certain::<KeyHammerSprings>("model-b-figure6");
    references_are_certain::<KeyHammerSprings>("model-b-stiff-10");
    references_are_certain::<ReducedGrand>("model-c-forte");
}

fn references_are_certain<M: Playable + Default>(name: &str) {
    let case = Case::load::<M>(name);
    let model: M = case.model();
    for h in [1e-3, 2.5e-4] {
        let quiet = count(model, case.start(&model), (h, case.t_end), |t| case.input(t));
        check(&format!("{name} {h}"), &quiet);
    }
}

#[test]
fn all_steps_at_rest_are_certain() {
    with_all!(rest_is_certain);
}

fn rest_is_certain<M: Playable>(model: M) {
    let entry = model.entry();
    for preset in entry.presets {
        let mut values = values(preset, entry.parameters.len(), 40);
        if let Some(drop) = entry.parameters.iter().position(|it| it.name == "y0") {
            values[drop] = 0.0;
        }
        let model = model.with_values(&values);
        let input = still(0.004 * model.input_per_metre());
        let quiet = count(model, model.at_rest(&input), (1e-3, 0.1), |_| input);
        check(&format!("{} {}", entry.name, preset.name), &quiet);
        assert_eq!(quiet.unknown, 0, "{} {}", entry.name, preset.name);
    }
}
