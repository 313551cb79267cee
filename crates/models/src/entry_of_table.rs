//! What is known of a model without building one, from its table.
#![expect(
    clippy::disallowed_types,
    clippy::disallowed_macros,
    reason = "once for a model, off the tick"
)]

use std::path::Path;

use crate::entry::{GuardEntry, ModeEntry, ModelEntry, Parameter, Preset};
use equations::table::{Arguments, FunctionId, Functions, ModeTable, ModelTable, NamedQuantity};

/// Keeps `value` until the program ends.
pub fn leak<T>(value: T) -> &'static T {
    Box::leak(Box::new(value))
}

/// Keeps what an iterator gives until the program ends.
fn keep<T>(all: impl IntoIterator<Item = T>) -> &'static [T] {
    Vec::leak(all.into_iter().collect())
}

fn keep_text(text: &str) -> &'static str {
    String::leak(text.to_owned())
}

/// The entry of the model of `table`, at a place of its own: some kilobytes that are kept until
/// the program ends.
pub fn entry(
    table: &'static ModelTable,
    functions: &'static dyn Functions,
    file: Option<&Path>,
) -> &'static ModelEntry {
    let names = |all: &[NamedQuantity]| keep(all.iter().map(|it| it.name));
    let units = |all: &[NamedQuantity]| keep(all.iter().map(|it| it.unit));
    let parameters = keep(table.parameters.iter().map(|it| Parameter {
        name: it.name,
        title: it.title,
        unit: it.unit,
        range: it.range,
        doc: it.doc,
    }));
    let presets = keep(table.presets.iter().map(|it| Preset {
        name: it.name,
        doc: it.doc,
        value: preset_values(functions, it.values, table.parameters.len()),
    }));
    leak(ModelEntry {
        // A copy of its own: by its place versions of one name are told apart.
        name: keep_text(table.name),
        summary: table.summary,
        file: file.map(|path| keep_text(&path.to_string_lossy())),
        parameters,
        presets,
        input: table.input.name,
        input_unit: table.input.unit,
        states: names(table.states),
        state_units: units(table.states),
        coordinates: table.coordinates,
        modes: keep(table.modes.iter().map(|mode| mode_entry(table, mode))),
        outputs: names(table.outputs),
        output_units: units(table.outputs),
    })
}

/// The values that the function `values` gives for a key, one at a time.
fn preset_values(
    functions: &'static dyn Functions,
    values: FunctionId,
    n: usize,
) -> &'static (dyn Fn(usize, u8) -> f64 + Send + Sync) {
    leak(move |parameter: usize, key: u8| {
        let mut all = vec![f64::NAN; n];
        let extra = [f64::from(key)];
        let arguments = Arguments { constants: &[], state: &[], input: &[0.0; 4], extra: &extra };
        functions.call(values, &arguments, &mut all);
        all.get(parameter).copied().unwrap_or(f64::NAN)
    })
}

/// A mode with its guards, and behind them the contacts that can close in it, which change no
/// structure.
fn mode_entry(table: &'static ModelTable, mode: &'static ModeTable) -> ModeEntry {
    let name = |mode: u8| table.modes.get(usize::from(mode)).map(|mode| mode.name);
    let guards = mode.guards.iter().map(|guard| {
        let ways = guard.ways.iter();
        let mut to: Vec<_> = Vec::new();
        for next in ways.flat_map(|way| [Some(way.to), way.resting.map(|resting| resting.to)]) {
            let next = next.and_then(name).filter(|next| !to.contains(next));
            to.extend(next);
        }
        GuardEntry { name: guard.name, unit: guard.unit, to: keep(to) }
    });
    let stays = keep([mode.name]);
    let contacts =
        mode.contacts.iter().filter_map(|it| table.contacts.get(usize::from(it.contact)));
    let names = contacts.flat_map(|contact| {
        let gap = contact.gap.map(|_size| (contact.name, "m"));
        [gap, contact.friction.map(|friction| (friction.0, ""))]
    });
    let contacts = names.flatten().map(|(name, unit)| GuardEntry { name, unit, to: stays });
    let guards = keep(guards.chain(contacts));
    let equations::table::Freedom { n, m, p } = mode.freedom;
    ModeEntry { name: mode.name, n, m, p, guards }
}
