//! Exact inputs, runs of a model under them, and models with other values.

#[path = "../../../mechanism/tests/kane/stroke.rs"]
mod audited_run;

pub use audited_run::{presses, run, still};

use instruments::{Described, Preset};

/// Returns `model` with preset `preset` of `key`, and some values replaced by name.
#[track_caller]
pub fn tuned<M: Described>(model: &M, preset: &str, key: u8, changes: &[(&str, f64)]) -> M {
    let entry = model.entry();
    let found = entry.presets.iter().find(|it| it.name == preset).expect("a preset");
    let mut values = values(found, entry.parameters.len(), key);
    for (name, value) in changes {
        let index = entry.parameters.iter().position(|it| it.name == *name).expect("a parameter");
        values[index] = *value;
    }
    model.with_values(&values)
}

#[track_caller]
pub fn parameter<M: Described>(model: &M, (preset, key): (&str, u8), name: &str) -> f64 {
    let entry = model.entry();
    let found = entry.presets.iter().find(|it| it.name == preset).expect("a preset");
    let index = entry.parameters.iter().position(|it| it.name == name).expect("a parameter");
    found.value(index, key)
}

pub fn values(preset: &Preset, parameters: usize, key: u8) -> Vec<f64> {
    preset.values(key).split_at(parameters).0.to_vec()
}
