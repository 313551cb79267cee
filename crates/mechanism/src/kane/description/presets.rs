//! Presets: named values of the parameters, graded over the keys.
#![expect(
    clippy::wildcard_enum_match_arm,
    reason = "TOML has many kinds of values, and each place takes few of them"
)]

use documents::toml::{KeyReader, SourcePlace, TomlEntry};
use documents::{choice, quoted};

use super::items::FileExpression;
use super::names::{SymbolKind, pi};
use super::order::sorted;
use super::reader::MechanismReader;
use crate::kane::graph::{Graph, Place};
use crate::kane::mechanism::MechanismPreset;
use crate::kane::text::{self, Dependence, Dimension, Measured, NameError, NameScope, PartShape};

const MOST_PRESETS: usize = 32;

impl MechanismReader {
    /// Reads the presets; without any, the parameters' values form one.
    pub(super) fn presets(&mut self, root: &mut KeyReader<'_>) {
        let entries = root.table(&mut self.report, "presets");
        if let Some(entry) = entries.get(MOST_PRESETS) {
            let help = format!("there are {MOST_PRESETS} at most");
            self.report.say(entry.place, "too many presets", help);
            return;
        }
        for entry in entries {
            let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { continue };
            let doc = keys.text(&mut self.report, "doc").map(|(it, _)| it.to_owned());
            let values = keys.table(&mut self.report, "values");
            keys.finish(&mut self.report);
            self.preset(&entry.name, doc.unwrap_or_default(), values);
        }
        if entries.is_empty() {
            self.preset("default", "the values of the parameters".to_owned(), &[]);
        }
    }

    pub(super) fn preset(&mut self, name: &str, doc: String, values: &[TomlEntry]) {
        let mut written: Vec<_> = self.parameters.iter().map(|it| it.value.clone()).collect();
        for entry in values {
            let Some(index) = self.parameter_index(&entry.name) else {
                let known = self.mechanism.parameters.iter().map(|it| it.name.as_str());
                let message = format!("there is no parameter {}", quoted(&entry.name));
                let help = choice(&entry.name, known);
                self.report.say(entry.place, message, help);
                continue;
            };
            let value = self.written(&entry.name, &entry.node);
            if let Some(slot) = written.get_mut(index) {
                *slot = value;
            }
        }
        let places =
            written.iter().map(|it| it.as_ref().map_or_else(SourcePlace::default, |it| it.place));
        self.places.presets.push(places.collect());
        let nodes = self.preset_values(&written);
        let values: Option<Vec<_>> = nodes.iter().map(|it| it.map(|it| it.node)).collect();
        if let Some(values) = values {
            self.mechanism.instrument.presets.push(MechanismPreset {
                name: name.to_owned(),
                doc,
                values,
            });
        }
    }

    pub(super) fn parameter_index(&self, name: &str) -> Option<usize> {
        match self.names.symbols.get(name) {
            Some((SymbolKind::Parameter(index), _)) => Some(*index),
            _ => None,
        }
    }

    pub(super) fn preset_values(
        &mut self,
        written: &[Option<FileExpression>],
    ) -> Vec<Option<Measured>> {
        let needs: Vec<_> = written.iter().map(|it| self.parameters_in(it.as_ref())).collect();
        let sorted = sorted(&needs);
        for circle in &sorted.circles {
            self.say_circle(circle);
        }
        let mut values: Vec<Option<Measured>> = vec![None; written.len()];
        let in_circles: Vec<usize> = sorted.circles.into_iter().flatten().collect();
        for index in sorted.order.into_iter().filter(|it| !in_circles.contains(it)) {
            let Some(file) = written.get(index).and_then(Option::as_ref) else { continue };
            let value = self.preset_value(file, index, &values);
            if let Some(slot) = values.get_mut(index) {
                *slot = value;
            }
        }
        values
    }

    pub(super) fn say_circle(&mut self, circle: &[usize]) {
        let name = |index: &usize| self.mechanism.parameters.get(*index).map_or("", |it| &it.name);
        let path: Vec<_> = circle.iter().chain(circle.first()).map(name).collect();
        let place = circle.first().and_then(|it| self.parameters.get(*it)).map(|it| it.place);
        let message = format!("the values depend on each other: {}", path.join(" → "));
        self.report.say(place.unwrap_or_default(), message, "give one of them a number");
    }

    pub(super) fn parameters_in(&self, file: Option<&FileExpression>) -> Vec<usize> {
        let parts = file.map_or(&[][..], |it| &it.expression.parts);
        let names = parts.iter().filter_map(|part| match &part.shape {
            PartShape::Name { name, .. } => self.parameter_index(name),
            _ => None,
        });
        names.collect()
    }

    pub(super) fn preset_value(
        &mut self,
        file: &FileExpression,
        index: usize,
        values: &[Option<Measured>],
    ) -> Option<Measured> {
        let parameters = self.mechanism.parameters.iter().map(|it| it.name.as_str()).collect();
        let mut scope = PresetScope { parameters, values };
        let value = match text::build(&file.expression, &mut self.graph, &mut scope) {
            Ok(value) => value,
            Err(errors) => {
                self.say_all(file, &errors);
                return None;
            }
        };
        self.weigh(file.place);
        let name = self.mechanism.parameters.get(index)?.name.clone();
        let dimension = self.parameters.get(index)?.dimension;
        if self.names.vague.contains(&name) {
            return None;
        }
        self.fits(&name, file, value, dimension).then_some(value)
    }
}

/// Names in a preset's formulas: the key, and other parameters of the preset.
struct PresetScope<'a> {
    parameters: Vec<&'a str>,
    values: &'a [Option<Measured>],
}

impl NameScope for PresetScope<'_> {
    fn value(
        &mut self,
        graph: &mut Graph,
        name: &str,
        primes: u8,
    ) -> Result<Measured, Option<NameError>> {
        if primes == 0 && name == "pi" {
            return Ok(pi(graph));
        }
        if primes == 0 && name == "key" {
            let node = graph.symbol(Place::Key);
            return Ok(Measured { node, dimension: Dimension::NONE, reach: Dependence::KEY });
        }
        match self.parameters.iter().position(|known| *known == name) {
            Some(index) if primes == 0 => self.values.get(index).copied().flatten().ok_or(None),
            _ => {
                let known = self.parameters.iter().copied().chain(["key", "pi"]);
                let message = format!("there is no parameter {}", quoted(name));
                Err(Some(NameError { message, help: choice(name, known) }))
            }
        }
    }

    fn named(
        &mut self,
        _graph: &mut Graph,
        function: &str,
        _names: &[&str],
    ) -> Result<Measured, (usize, Option<NameError>)> {
        let message = format!("{function} cannot stand in a parameter's value");
        let help = "use parameters and key only".to_owned();
        Err((0, Some(NameError { message, help })))
    }

    fn rate(&mut self, _graph: &mut Graph, _value: Measured) -> Result<Measured, NameError> {
        let message = "parameters have no rates".to_owned();
        Err(NameError { message, help: "use parameters and key only".to_owned() })
    }

    fn allowed(&self) -> Dependence {
        Dependence::KEY
    }
}
