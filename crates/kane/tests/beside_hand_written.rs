//! The described model B beside the hand-written one, under figure 6's input.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails aloud, and bits are what is compared"
)]

use equations::ModeNumber;
use hand_written::KeyHammerSprings;
use models::Described as _;
use pode::stepper::Rk4;
use pode::{Limits, Model as _, Motion, Resets, RunRecorder, Simulator, Sloped as _, Work};

use crate::by_hand::{self, key_hammer, model};

/// s(t) = Σ A exp(−((t − tc)/w)²) of figure 6.
const BELLS: [[f64; 3]; 3] = [[0.099, 0.514, 0.079], [0.181, 1.095, 0.109], [0.186, 1.573, 0.059]];

pub(crate) fn figure_6(scale: f64) -> impl Fn(f64) -> Motion + Copy {
    move |t| {
        let mut motion = Motion::default();
        for [a, tc, w] in BELLS {
            let z = (t - tc) / w;
            let bell = scale * a * (-z * z).exp();
            motion.position += bell;
            motion.rate += bell * (-2.0 * z) / w;
            motion.acceleration += bell * (4.0 * z * z - 2.0) / (w * w);
            motion.jerk += bell * (12.0 * z - 8.0 * z * z * z) / (w * w * w);
        }
        motion
    }
}

pub(crate) type Run<M> = (RunRecorder<M>, Work, M);

pub(crate) fn run<M: Resets + Copy>(
    model: M,
    (mode, x): (M::Mode, M::State),
    (h, until): (f64, f64),
    input: impl Fn(f64) -> M::Input,
) -> Run<M> {
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, x);
    let mut recorder = RunRecorder::new(h).sampled(1e-3);
    let outcome = simulator.run(until, h, input, &mut recorder);
    assert!(outcome.is_completed(), "{outcome:?}");
    (recorder, outcome.work, model)
}

/// Values of a preset of the hand-written model, with some replaced.
fn values(preset: usize, key: u8, changes: &[(&str, f64)]) -> Vec<f64> {
    let of = |index: usize| (KeyHammerSprings::default().entry().presets[preset].value)(index, key);
    let mut values: Vec<f64> = (0..key_hammer::NAMES.len()).map(of).collect();
    for (name, value) in changes {
        values[key_hammer::NAMES.iter().position(|it| it == name).unwrap()] = *value;
    }
    values
}

/// Runs both, and compares events, samples and work.
fn check(
    label: &str,
    values: &[f64],
    (h, until): (f64, f64),
    input: impl Fn(f64) -> Motion + Copy,
) {
    let names: Vec<_> =
        KeyHammerSprings::default().entry().parameters.iter().map(|it| it.name).collect();
    assert_eq!(names, key_hammer::NAMES, "the order of the parameters");
    let described: by_hand::Described<4> = model(key_hammer::program(), values);
    let written = KeyHammerSprings::default().with_values(values);
    let start = described.at_rest(&input(0.0));
    let expected = written.at_rest(&input(0.0));
    for (a, b) in start.1.iter().zip(&expected.1) {
        assert!((a - b).abs() < 1e-12, "{label}: at rest {start:?}, not {expected:?}");
    }
    let (one, work, _) = run(described, start, (h, until), input);
    let (other, least, _) = run(written, expected, (h, until), input);
    assert!(other.events().len() >= 2, "{label}: a stroke has events");
    let story = |name: &'static str, to: usize| (name, to);
    let seen: Vec<_> = one.events().iter().map(|it| story(it.name, it.to.0.into())).collect();
    let wanted: Vec<_> = other.events().iter().map(|it| story(it.name, it.to as usize)).collect();
    assert_eq!(seen, wanted, "{label}: events");
    for (a, b) in one.times().iter().zip(other.times()) {
        assert!((a - b).abs() < 1e-9, "{label}: {a} is not {b}");
    }
    assert_eq!(one.samples().len(), other.samples().len());
    for (a, b) in one.samples().iter().zip(other.samples()) {
        let size = b.readout.abs().max(1.0);
        let error = (a.readout - b.readout).abs();
        assert!(error < 1e-9 * size, "{label} at {}: {} is not {}", a.t, a.readout, b.readout);
    }
    println!("{label}: described {work:?}\n{label}: written   {least:?}");
    assert!(work.derivatives <= least.derivatives, "{label}: {work:?}, not {least:?}");
    assert!(work.guards <= least.guards, "{label}: {work:?}, not {least:?}");
    assert!(work.unknown <= least.unknown, "{label}: {work:?}, not {least:?}");
}

#[test]
fn model_b_is_the_hand_written_one_under_figure_6() {
    for h in [1e-3, 2.5e-4] {
        check(&format!("paper {h}"), &values(0, 0, &[]), (h, 3.0), figure_6(1.0));
    }
}

#[test]
fn it_is_so_with_dampers_and_felt() {
    let lossy = values(0, 0, &[("b1", 0.05), ("c2", 0.3), ("restitution", 0.4)]);
    check("lossy", &lossy, (1e-3, 3.0), figure_6(1.0));
}

#[test]
fn it_is_so_for_a_key_of_a_real_size() {
    for key in [0, 44, 87] {
        let values = values(2, key, &[]);
        // Ticks that are shorter than either model's longest step.
        check(&format!("playable {key}"), &values, (1e-4, 2.0), figure_6(0.2));
    }
}

#[test]
fn natures_and_slopes_are_the_hand_written_ones() {
    let paper = values(0, 0, &[]);
    let described: by_hand::Described<4> = model(key_hammer::program(), &paper);
    let written = KeyHammerSprings::default().with_values(&paper);
    let input = figure_6(1.0)(0.5);
    for (number, (mode, name)) in (0..).zip(written.modes()) {
        let number = ModeNumber(number);
        assert_eq!(described.table().modes[usize::from(number.0)].name, name);
        let (found, expected) = (described.nature(number), written.nature(mode));
        assert_eq!(found.kind, expected.kind, "{name}");
        // The hand-written rate takes spring and felt one by one.
        let ratio = found.rate / expected.rate;
        assert!((0.8..1.05).contains(&ratio), "{name}: {found:?}, not {expected:?}");
        assert_eq!(described.parts(number).len(), written.parts(mode).len(), "{name}");
        let x = [0.01, 0.02, 0.3, -0.2];
        let slopes = described.slopes(number, &x, &input);
        let wanted = written.slopes(mode, &x, &input);
        assert!((slopes.per_position - wanted.per_position).abs() < 1e-12);
        assert!((slopes.per_rate - wanted.per_rate).abs() < 1e-12);
    }
    assert!((described.input_per_metre() - 1.0 / paper[16]).abs() < 1e-15);
    let before = [0.398, 0.1, 2.0, 0.0];
    let string = described.table().modes[0].guards[1].id;
    assert_eq!(described.sounding(pode::GuardId(string), &before), Some(2.0));
}
