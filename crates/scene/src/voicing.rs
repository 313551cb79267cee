//! Voices of a range of keys: a model, a preset, and the parameters that differ from it.

use std::sync::Arc;

use instruments::{LoadedModel, Parameter, Preset};
use keyboard::{KEYS, KeyIndex, KeyRange};
use mechanism::{Library, MissingModel, unmet};

use super::quantity::Quantity;
use super::read::{self, TableReader, unknown};
use documents::quoted;
use documents::toml::{FindingList, SourcePlace, TomlKind, TomlNode};

#[derive(Clone, PartialEq, Debug)]
enum ChangedValues {
    Graded(Graded),
    ByKey(Arc<[f64; KEYS]>),
}

impl ChangedValues {
    fn at(&self, key: u8) -> f64 {
        match self {
            Self::Graded(graded) => graded.at(key),
            Self::ByKey(values) => values[usize::from(key.min(LAST))],
        }
    }
}

const LAST: u8 = KeyIndex::HIGHEST.number();

/// Value that is linear in the key, from the bass to the treble.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Graded {
    /// Value at key 0, A0.
    bass: f64,
    /// Value at key 87, C8.
    treble: f64,
}

impl Graded {
    fn at(self, key: u8) -> f64 {
        let place = f64::from(key.min(LAST)) / f64::from(LAST);
        let value = self.bass + (self.treble - self.bass) * place;
        // Rounding must not carry a checked value out of its range.
        value.clamp(self.bass.min(self.treble), self.bass.max(self.treble))
    }
}

/// Model with a value for each of its parameters on each key: those of a preset, and differences.
#[derive(Clone, Debug)]
pub struct Voicing {
    pub model: Arc<LoadedModel>,
    preset: usize,
    changed: Vec<Option<ChangedValues>>,
    /// File of the instrument, if it is no part of the program.
    pub file: Option<Arc<InstrumentFile>>,
}

/// An instrument that is no part of the program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct InstrumentFile {
    pub name: String,
    pub path: String,
}

impl Voicing {
    /// Returns `model` with its first preset; `None` without presets.
    pub fn of_model(model: &Arc<LoadedModel>) -> Option<Self> {
        let voicing = Self { model: Arc::clone(model), preset: 0, changed: Vec::new(), file: None };
        (!model.presets.is_empty()).then_some(voicing)
    }

    pub fn preset(&self) -> &Preset {
        &self.model.presets[self.preset]
    }

    /// Returns the voicing for another version of the model: the preset of equal name, or else the
    /// first, and the differences in parameters of equal name that allow these values.
    pub fn following(&self, model: &Arc<LoadedModel>) -> Option<Self> {
        let called = |it: &Preset| it.name == self.preset().name;
        let preset = model.presets.iter().position(called).unwrap_or(0);
        let changed = model.parameters.iter().map(|it| self.changed_in(it)).collect();
        Some(Self { preset, changed, ..Self::of_model(model)? })
    }

    /// Returns the difference from the preset in the parameter with the name of `wanted`.
    fn changed_in(&self, wanted: &Parameter) -> Option<ChangedValues> {
        let same = |it: &Parameter| it.name == wanted.name && it.unit == wanted.unit;
        let index = self.model.parameters.iter().position(same)?;
        let changed = self.changed.get(index)?.as_ref()?;
        let quantity = Quantity { unit: wanted.unit, range: wanted.range };
        (0..=LAST).all(|key| quantity.allows(changed.at(key))).then(|| changed.clone())
    }

    /// Reports the first of the model's conditions on its parameters that fails on one of `keys`.
    pub(super) fn refuse_unmet(
        &self,
        report: &mut FindingList,
        place: SourcePlace,
        keys: KeyRange,
    ) {
        let on_key = |key| Some((key, unmet(&self.model, &self.values(key)).into_iter().next()?));
        if let Some((key, condition)) = keys.numbers().find_map(on_key) {
            let key = KeyIndex::new(key).map_or_else(String::new, |key| key.to_string());
            let name = self.model.name;
            let message = format!("{name} needs {condition}, which does not hold on {key}");
            report.say(place, message, "choose other parameters, or another preset");
        }
    }

    /// Returns one value per parameter of the model for `key`, 0 (A0) ..= 87 (C8).
    pub fn values(&self, key: u8) -> Vec<f64> {
        let mut values = self.preset().values(key);
        for (value, changed) in values.iter_mut().zip(&self.changed) {
            if let Some(changed) = changed {
                *value = changed.at(key);
            }
        }
        values
    }

    /// Sets the values of the parameter at `index` on all keys.
    pub(super) fn set_values(&mut self, index: usize, values: Arc<[f64; KEYS]>) {
        self.changed.resize(self.model.parameters.len(), None);
        self.changed[index] = Some(ChangedValues::ByKey(values));
    }

    pub(super) fn read(
        report: &mut FindingList,
        reader: &mut TableReader<'_>,
        library: &Library,
    ) -> Option<Self> {
        let model = reader.text(report, "model");
        let preset = reader.text(report, "preset");
        let (name, place) = model?;
        let model = match library.find(&name, report.folder(place)) {
            Ok(model) => model,
            Err(MissingModel::Unknown { message, help }) => {
                report.say(place, message, help);
                return None;
            }
            Err(MissingModel::Wrong(diagnostics)) => {
                report.absorb(diagnostics);
                return None;
            }
        };
        let preset = match preset {
            None => 0,
            Some((name, place)) => {
                let found = model.presets.iter().position(|preset| preset.name == name);
                if found.is_none() {
                    let refusal = format!("{} has no preset", model.name);
                    let known = model.presets.iter().map(|preset| preset.name);
                    unknown(report, place, &refusal, &name, known);
                }
                // The parameters can be checked with any preset.
                found.unwrap_or(0)
            }
        };
        Some(Self { preset, ..Self::of_model(&model)? })
    }

    pub(super) fn read_parameters(
        &mut self,
        report: &mut FindingList,
        reader: &mut TableReader<'_>,
    ) {
        let Some(entry) = reader.take("parameters") else { return };
        let Some(entries) = entry.node.entries() else {
            let help = "write it as a table of the model's parameters";
            read::wrong_kind(report, "parameters", &entry.node, "a table", help);
            return;
        };
        let model = Arc::clone(&self.model);
        let parameters = &model.parameters;
        self.changed.resize(parameters.len(), None);
        for entry in entries {
            let index = parameters.iter().position(|parameter| parameter.name == entry.name);
            let Some(index) = index else {
                self.unknown_parameter(report, entry.place, &entry.name);
                continue;
            };
            let graded = read_graded(report, &parameters[index], &entry.node);
            if let Some(graded) = graded {
                self.changed[index] = Some(ChangedValues::Graded(graded));
            }
        }
    }

    fn unknown_parameter(&self, report: &mut FindingList, place: SourcePlace, name: &str) {
        let refusal = format!("{} has no parameter", self.model.name);
        let known = self.model.parameters.iter().map(|parameter| parameter.name);
        unknown(report, place, &refusal, name, known);
    }
}

fn read_graded(report: &mut FindingList, parameter: &Parameter, node: &TomlNode) -> Option<Graded> {
    let quantity = Quantity { unit: parameter.unit, range: parameter.range };
    if !matches!(node.kind, TomlKind::Table(_)) {
        let value = read::number(report, parameter.name, node, quantity)?;
        return Some(Graded { bass: value, treble: value });
    }
    let mut reader = TableReader::new(report, parameter.name, node)?;
    let mut end = |report: &mut FindingList, name| {
        let value = reader.take(name);
        if value.is_none() {
            let message = format!("{} is graded but has no {name}", quoted(parameter.name));
            report.miss(node.place, message, "write { bass = …, treble = … }");
        }
        let full_name = format!("{}.{name}", parameter.name);
        value.and_then(|entry| read::number(report, &full_name, &entry.node, quantity))
    };
    let (bass, treble) = (end(report, "bass"), end(report, "treble"));
    reader.finish(report);
    Some(Graded { bass: bass?, treble: treble? })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use mechanism::Library;

    use super::*;

    #[test]
    fn a_graded_value_is_exact_at_both_ends_and_straight_between() {
        let graded = Graded { bass: 0.1, treble: 0.05 };
        assert_eq!(graded.at(0).to_bits(), 0.1_f64.to_bits());
        assert_eq!(graded.at(87).to_bits(), 0.05_f64.to_bits());
        // One rounding of a value below 1 in each of three operations.
        assert!((graded.at(29) - (0.1 - 0.05 / 3.0)).abs() < 4.0 * f64::EPSILON);
    }

    #[test]
    fn every_preset_stays_within_its_model_s_ranges() {
        let library = Library::default();
        let models = mechanism::model_names();
        models.for_each(|name| stays_within(&library.find(name, Path::new("")).unwrap()));
    }

    fn stays_within(model: &LoadedModel) {
        let sets = model.presets.iter().flat_map(|preset| (0..88).map(move |key| (preset, key)));
        for (preset, key) in sets {
            for (parameter, value) in model.parameters.iter().zip(preset.values(key)) {
                let quantity = Quantity { unit: parameter.unit, range: parameter.range };
                let label = (model.name, preset.name, parameter.name, key);
                assert!(quantity.allows(value), "{label:?}");
            }
        }
    }
}
