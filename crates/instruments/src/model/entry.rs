//! Data of a model that needs no instance.
#![expect(
    clippy::disallowed_types,
    clippy::disallowed_macros,
    reason = "once for a model, off the tick"
)]

use alloc::sync::Arc;
use core::fmt;
use core::sync::atomic::{AtomicU64, Ordering};

use crate::equations::table::{
    Arguments, FunctionId, Functions, ModeTable, ModelTable, NamedQuantity, Reading, is_pose,
};

use crate::model::source::ModelSource;

/// Arithmetic that a table and its presets share.
pub type SharedFunctions = Arc<dyn Functions>;

/// A parameter of a model, with its unit and range.
#[derive(Clone, PartialEq, Debug)]
pub struct Parameter {
    pub name: &'static str,
    /// Title for people; equals `name` by default.
    pub title: Box<str>,
    /// SI unit; `"1"` for a ratio.
    pub unit: &'static str,
    pub range: (f64, f64),
    pub doc: Box<str>,
    pub reading: Reading,
}

/// A named set of parameter values, graded over the compass.
#[derive(Clone)]
pub struct Preset {
    pub name: &'static str,
    pub doc: Box<str>,
    functions: SharedFunctions,
    values: FunctionId,
    parameters: usize,
}

impl Preset {
    pub fn values(&self, key: u8) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.parameters];
        let extra = [f64::from(key)];
        let arguments = Arguments { constants: &[], state: &[], input: &[0.0; 4], extra: &extra };
        self.functions.call(self.values, &arguments, &mut values);
        values
    }

    pub fn value(&self, parameter: usize, key: u8) -> f64 {
        self.values(key).get(parameter).copied().unwrap_or(f64::NAN)
    }
}

impl fmt::Debug for Preset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Preset").field("name", &self.name).finish_non_exhaustive()
    }
}

/// Data of a model that needs no instance.
#[derive(Debug)]
pub struct ModelEntry {
    /// Number of this version of the model in this process.
    id: u64,
    pub name: &'static str,
    pub summary: Box<str>,
    /// Files of the model; `None` for one that is part of the program.
    pub source: Option<ModelSource>,
    /// The parameters, in the order of [`Described::with_values`](crate::Described::with_values).
    pub parameters: Vec<Parameter>,
    /// Presets; the first is the default.
    pub presets: Vec<Preset>,
    pub input: &'static str,
    pub input_unit: &'static str,
    pub states: Vec<&'static str>,
    pub state_units: Vec<&'static str>,
    /// Number of leading entries of the state that are coordinates.
    pub coordinates: usize,
    /// Structural modes, in the order of their numbers.
    pub modes: Vec<ModeEntry>,
    pub outputs: Vec<&'static str>,
    pub output_units: Vec<&'static str>,
}

impl ModelEntry {
    /// Returns the entry of the model of `table`, as a new version.
    pub(crate) fn new(
        table: &ModelTable,
        functions: &SharedFunctions,
        source: Option<ModelSource>,
    ) -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(1);
        let names = |all: &[NamedQuantity]| all.iter().map(|it| it.name).collect();
        let units = |all: &[NamedQuantity]| all.iter().map(|it| it.unit).collect();
        let parameters = table.parameters.iter().map(|it| Parameter {
            name: it.name,
            title: it.title.clone(),
            unit: it.unit,
            range: it.range,
            doc: it.doc.clone(),
            reading: it.reading,
        });
        let presets = table.presets.iter().map(|it| Preset {
            name: it.name,
            doc: it.doc.clone(),
            functions: Arc::clone(functions),
            values: it.values,
            parameters: table.parameters.len(),
        });
        Self {
            id: NEXT.fetch_add(1, Ordering::Relaxed),
            name: table.name,
            summary: table.summary.clone(),
            source,
            parameters: parameters.collect(),
            presets: presets.collect(),
            input: table.input.quantity.name,
            input_unit: table.input.quantity.unit,
            states: names(&table.states),
            state_units: units(&table.states),
            coordinates: table.coordinates,
            modes: (0..).zip(&table.modes).map(|mode| ModeEntry::new(table, mode)).collect(),
            outputs: names(&table.outputs),
            output_units: units(&table.outputs),
        }
    }

    pub const fn id(&self) -> u64 {
        self.id
    }

    pub const fn is(&self, other: &Self) -> bool {
        self.id == other.id
    }

    /// Returns the path of the description; `None` for a model that is part of the program.
    pub fn file(&self) -> Option<&str> {
        self.source.as_ref().map(|source| source.file.as_str())
    }

    /// Returns the version of the description; 0 for a model that is part of the program.
    pub fn version(&self) -> u32 {
        self.source.as_ref().map_or(0, |source| source.version)
    }

    /// Returns the unit of the guard called `name`; empty if it is unknown.
    pub fn guard_unit(&self, name: &str) -> &'static str {
        let mut guards = self.modes.iter().flat_map(|mode| &mode.guards);
        guards.find(|guard| guard.name == name).map_or("", |guard| guard.unit)
    }

    /// Returns the outputs for people, without the poses that a drawing follows.
    pub fn quantities(&self) -> &[&'static str] {
        let count = self.outputs.iter().take_while(|name| !is_pose(name)).count();
        self.outputs.split_at(count).0
    }

    /// Returns the default preset's value of a parameter for the lowest key.
    pub fn default_value(&self, parameter: usize) -> f64 {
        self.presets.first().map_or(f64::NAN, |preset| preset.value(parameter, 0))
    }

    /// Returns one value per parameter: what `given` has for its name, or the default value.
    pub fn values(&self, given: impl Fn(&str) -> Option<f64>) -> Vec<f64> {
        let value = |(index, parameter): (usize, &Parameter)| {
            given(parameter.name).unwrap_or_else(|| self.default_value(index))
        };
        self.parameters.iter().enumerate().map(value).collect()
    }
}

/// A structural mode: coordinates n, constraints m, freedoms p = n − m. `[GC93]` table 1.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ModeEntry {
    pub name: &'static str,
    pub n: u8,
    pub m: u8,
    pub p: u8,
    /// Guards, in the order of the model's list.
    pub guards: Vec<GuardEntry>,
}

impl ModeEntry {
    /// Lists the guards of a mode, then the contacts that can close in it.
    fn new(table: &ModelTable, (number, mode): (u8, &ModeTable)) -> Self {
        let name = |mode: u8| table.modes.get(usize::from(mode)).map(|mode| mode.name);
        let guards = mode.guards.iter().map(|guard| {
            let ways = guard.ways.iter();
            let family = guard.closes.and_then(|_contact| table.automata.impacts_in(number));
            let members = family.into_iter().flat_map(|it| it.members.iter().map(|it| Some(it.0)));
            let mut to: Vec<_> = Vec::new();
            let ways = ways.flat_map(|way| [Some(way.to), way.resting.map(|resting| resting.to)]);
            for next in ways.chain(members) {
                let next = next.and_then(name).filter(|next| !to.contains(next));
                to.extend(next);
            }
            GuardEntry { name: guard.name, unit: guard.unit, to }
        });
        let contacts =
            mode.contacts.iter().filter_map(|it| table.contacts.get(usize::from(it.contact)));
        let names = contacts.flat_map(|contact| {
            let gap = contact.gap.map(|_size| (contact.name, "m"));
            [gap, contact.friction.map(|friction| (friction.0, ""))]
        });
        let to = [mode.name];
        let contacts =
            names.flatten().map(|(name, unit)| GuardEntry { name, unit, to: to.to_vec() });
        let guards = guards.chain(contacts).collect();
        let crate::equations::table::Freedom { n, m, p } = mode.freedom;
        Self { name: mode.name, n, m, p, guards }
    }
}

/// A guard of a mode, with the modes after it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct GuardEntry {
    pub name: &'static str,
    /// SI unit; empty if unknown.
    pub unit: &'static str,
    pub to: Vec<&'static str>,
}
