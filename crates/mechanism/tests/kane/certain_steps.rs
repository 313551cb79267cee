//! Number of a played stroke's steps that are certain to hide no crossing.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of ticks are small"
)]

use instruments::equations::ModeNumber;
use pode::input::Cubic;
use pode::stepper::Rk4;
use pode::{Advance, Limits, Motion, Silent, Simulator, Work};

use crate::kane::reference::Case;
use crate::kane::runnable::{GRAND, RIGID, Runnable, SPRINGS, ShippedModel, built_in};
use crate::kane::stroke::{presses, still};

fn share(work: &Work) -> f64 {
    f64::from(work.certain) / f64::from(work.certain + work.unknown)
}

/// Runs `model` under a cubic per tick through `input`; returns the work of ticks without an event.
fn count<const N: usize>(
    model: &Runnable<N>,
    start: (ModeNumber, [f64; N]),
    (h, until): (f64, f64),
    input: impl Fn(f64) -> Motion,
) -> Work {
    let mut simulator = Simulator::new(*model, Rk4, Limits::default(), start.0, start.1);
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

/// Checks that nearly all quiet steps are certain: all but those with a guard near zero.
#[track_caller]
fn check(label: &str, quiet: &Work) {
    assert!(share(quiet) > 0.995, "{label}: {quiet:?}");
}

#[test]
fn most_steps_of_a_played_stroke_are_certain() {
    built_in().into_iter().for_each(strokes_are_certain);
}

fn strokes_are_certain(shipped: &ShippedModel) {
    let last = shipped.table.presets.len() - 1;
    let model = shipped.valued::<4, 256>(&shipped.values(last, 40));
    let scale = model.input_per_metre();
    let press = [[0.0098 * scale, 0.15, 0.02], [-0.0098 * scale, 0.5, 0.02]];
    for h in [1e-3, 2.5e-4] {
        let start = model.at_rest(&presses(&press, 0.0));
        let quiet = count(&model, start, (h, 1.0), |t| presses(&press, t));
        check(&format!("{} stroke {h}", shipped.table.name), &quiet);
    }
}

#[test]
fn most_steps_of_the_references_are_certain() {
    references_are_certain::<2>(&RIGID, "model-a-two-throws");
    references_are_certain::<4>(&SPRINGS, "model-b-figure6");
    references_are_certain::<4>(&SPRINGS, "model-b-stiff-10");
    references_are_certain::<4>(&GRAND, "model-c-forte");
}

fn references_are_certain<const N: usize>(shipped: &ShippedModel, name: &str) {
    let case = Case::<N>::load(shipped, name);
    for h in [1e-3, 2.5e-4] {
        let quiet = count(&case.model, case.start(), (h, case.t_end), |t| case.input(t));
        check(&format!("{name} {h}"), &quiet);
    }
}

#[test]
fn all_steps_at_rest_are_certain() {
    built_in().into_iter().for_each(rest_is_certain);
}

fn rest_is_certain(shipped: &ShippedModel) {
    for (index, preset) in shipped.table.presets.iter().enumerate() {
        let mut values = shipped.values(index, 40);
        if let Some(drop) = shipped.table.parameters.iter().position(|it| it.name == "y0") {
            values[drop] = 0.0;
        }
        let model = shipped.valued::<4, 256>(&values);
        let input = still(0.004 * model.input_per_metre());
        let quiet = count(&model, model.at_rest(&input), (1e-3, 0.1), |_| input);
        check(&format!("{} {}", shipped.table.name, preset.name), &quiet);
        assert_eq!(quiet.unknown, 0, "{} {}", shipped.table.name, preset.name);
    }
}
