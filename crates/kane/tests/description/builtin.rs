//! The built-in models' descriptions have the values that were written by hand.

use hand_written::{bouncing_ball, key_hammer_springs};
use kane::graph::Place;
use kane::tape::{Argument, ArgumentLayout, Tape, TapeArguments};
use models::ModelEntry;

use super::good;

const BALL: &str = include_str!("../../../models/src/bouncing_ball/model.toml");
const SPRINGS: &str = include_str!("../../../models/src/key_hammer_springs/model.toml");

#[track_caller]
fn agrees(entry: &ModelEntry, text: &str) {
    let mechanism = good(text).mechanism;
    assert_eq!(mechanism.name, entry.name);
    assert_eq!(mechanism.summary, entry.summary);
    assert_eq!(mechanism.parameters.len(), entry.parameters.len());
    for (ours, theirs) in mechanism.parameters.iter().zip(entry.parameters) {
        assert_eq!((ours.name.as_str(), ours.unit.as_str()), (theirs.name, theirs.unit));
        assert_eq!((ours.range, ours.doc.as_str()), (theirs.range, theirs.doc));
    }
    let modes: Vec<_> = mechanism.modes.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(modes, entry.modes.iter().map(|it| it.name).collect::<Vec<_>>());
    let outputs: Vec<_> = mechanism.outputs.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(outputs, entry.outputs);
    let units: Vec<_> = mechanism.outputs.iter().map(|it| it.unit.as_str()).collect();
    assert_eq!(units, entry.output_units);
    assert_eq!(mechanism.presets.len(), entry.presets.len());
    let mut layout = ArgumentLayout::default();
    layout.place(Place::Key, Argument::Extra(0));
    for (ours, theirs) in mechanism.presets.iter().zip(entry.presets) {
        assert_eq!((ours.name.as_str(), ours.doc.as_str()), (theirs.name, theirs.doc));
        let tape = Tape::lower(&mechanism.graph, &layout, &ours.values).expect("values of the key");
        for key in 0..88 {
            let extra = [f64::from(key)];
            let values =
                tape.evaluate(&TapeArguments { extra: &extra, ..TapeArguments::default() });
            for (index, value) in values.into_iter().enumerate() {
                let by_hand = (theirs.value)(index, key);
                let apart = (value - by_hand).abs();
                let name = entry.parameters[index].name;
                assert!(apart <= 1e-12 * by_hand.abs(), "{name} of key {key}: {value}, {by_hand}");
            }
        }
    }
}

#[test]
fn the_ball_has_the_values_of_the_hand_written_one() {
    agrees(&bouncing_ball::ENTRY, BALL);
}

#[test]
fn model_b_has_the_values_of_the_hand_written_one() {
    agrees(&key_hammer_springs::ENTRY, SPRINGS);
}
