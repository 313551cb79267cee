//! Parameters, their values in presets, and what must hold among them.
#![expect(
    clippy::wildcard_enum_match_arm,
    reason = "TOML has many kinds of values, and each place takes few of them"
)]

use diagnostics::{choice, quoted};

use super::key_reader::KeyReader;
use super::names::{SymbolKind, pi};
use super::order::sorted;
use super::reader::{CONSTANT, DescriptionReader, FileExpression};
use super::source::SourcePlace;
use super::toml_tree::{TomlEntry, TomlKind};
use crate::graph::{Graph, Place};
use crate::mechanism::{Parameter, Preset, Requirement};
use crate::text::{self, Dimension, Form, Measured, NameError, NameScope, Reach, Shape};

/// Most presets.
const MOST_PRESETS: usize = 32;

/// A parameter as it was written.
#[derive(Clone, Debug)]
pub(super) struct ParameterText {
    pub(super) value: Option<FileExpression>,
    pub(super) place: SourcePlace,
    pub(super) dimension: Dimension,
}

impl DescriptionReader {
    pub(super) fn declare_parameters(&mut self, root: &mut KeyReader<'_>) {
        for entry in root.table(&mut self.report, "parameters") {
            if self.is_name(entry) {
                self.parameter(entry);
            }
        }
    }

    fn parameter(&mut self, entry: &TomlEntry) {
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        let value = self.field(&mut keys, "value");
        if keys.take("value").is_none() {
            let message = format!("the parameter {} has no value", quoted(&entry.name));
            self.report.miss(entry.place, message, "write value = \"5 mm\"");
        }
        let unit = self.parameter_unit(&mut keys, value.as_ref());
        let (unit, dimension) = self.or_vague(&entry.name, unit);
        let range = self.range(&mut keys, "range", &entry.name, dimension);
        let title = keys.text(&mut self.report, "title").map(|(it, _)| it.to_owned());
        let doc = keys.text(&mut self.report, "doc").map(|(it, _)| it.to_owned());
        keys.finish(&mut self.report);
        let kind = SymbolKind::Parameter(self.parameters.len());
        if !self.symbol(entry, kind) {
            return;
        }
        self.names.parameters.push(dimension);
        self.parameters.push(ParameterText { value, place: entry.place, dimension });
        let name = entry.name.clone();
        self.mechanism.parameters.push(Parameter {
            title: title.unwrap_or_else(|| name.clone()),
            name,
            unit,
            range: range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY)),
            doc: doc.unwrap_or_default(),
        });
    }

    /// The unit that is stated, or that the value is written in.
    fn parameter_unit(
        &mut self,
        keys: &mut KeyReader<'_>,
        value: Option<&FileExpression>,
    ) -> Option<(String, Dimension)> {
        if keys.take("unit").is_some() {
            return self.unit(keys, "unit");
        }
        let value = value?;
        if !value.expression.is_literal() {
            let help = "write unit = \"m\" beside it; 1 for a ratio";
            self.report.say(value.place, "a value that is a formula needs its unit stated", help);
            return None;
        }
        let dimension = value.expression.parts.iter().find_map(|part| match part.shape {
            Shape::Number { dimension, .. } => Some(dimension),
            _ => None,
        });
        let unit = value.expression.literal_unit().unwrap_or("1").to_owned();
        Some((unit, dimension.unwrap_or_default()))
    }

    /// Returns the unit of `name`; without one, what depends on it is not looked at.
    pub(super) fn or_vague(
        &mut self,
        name: &str,
        unit: Option<(String, Dimension)>,
    ) -> (String, Dimension) {
        unit.unwrap_or_else(|| {
            self.names.vague.insert(name.to_owned());
            ("1".to_owned(), Dimension::NONE)
        })
    }

    /// Returns the unit called `name`, in SI.
    pub(super) fn unit(
        &mut self,
        keys: &mut KeyReader<'_>,
        name: &'static str,
    ) -> Option<(String, Dimension)> {
        let (text, place) = keys.text(&mut self.report, name)?;
        match text::unit(text) {
            Ok(unit) if unit.is_si() => Some((unit.si, unit.dimension)),
            Ok(unit) => {
                let message = format!("{} is not in SI", quoted(text));
                self.report.say(
                    place,
                    message,
                    format!("write {}; values may be in {text}", unit.si),
                );
                None
            }
            Err(error) => {
                self.report.say(place.after(error.span.start), error.message, error.help);
                None
            }
        }
    }

    /// Returns the range called `name` of what is called `of`.
    pub(super) fn range(
        &mut self,
        keys: &mut KeyReader<'_>,
        name: &'static str,
        of: &str,
        dimension: Dimension,
    ) -> Option<(f64, f64)> {
        let help = format!("write {name} = [\"smallest\", \"largest\"], each with its unit");
        let Some(entry) = keys.take(name) else {
            self.report.miss(keys.place, format!("{} has no {name}", quoted(of)), help);
            return None;
        };
        if self.names.vague.contains(of) {
            return None;
        }
        let TomlKind::List(items) = &entry.node.kind else {
            self.report.say(entry.place, format!("{} is no list", quoted(name)), help);
            return None;
        };
        let [low, high] = items.as_slice() else {
            self.report.say(
                entry.place,
                format!("{} has {} values", quoted(name), items.len()),
                help,
            );
            return None;
        };
        let (low, high) =
            (self.constant(name, low, dimension), self.constant(name, high, dimension));
        let (low, high) = (low?, high?);
        if low > high {
            let message = format!("the {name} begins at {low} and ends at {high}");
            self.report.say(entry.place, message, "give the smaller one first");
            return None;
        }
        Some((low, high))
    }

    /// Reads the presets; without any, the parameters' values are one.
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

    fn preset(&mut self, name: &str, doc: String, values: &[TomlEntry]) {
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
        self.preset_places.push(places.collect());
        let nodes = self.preset_values(&written);
        let values: Option<Vec<_>> = nodes.iter().map(|it| it.map(|it| it.node)).collect();
        if let Some(values) = values {
            self.mechanism.presets.push(Preset { name: name.to_owned(), doc, values });
        }
    }

    fn parameter_index(&self, name: &str) -> Option<usize> {
        match self.names.symbols.get(name) {
            Some((SymbolKind::Parameter(index), _)) => Some(*index),
            _ => None,
        }
    }

    /// Builds the values of all parameters, each of the key alone.
    fn preset_values(&mut self, written: &[Option<FileExpression>]) -> Vec<Option<Measured>> {
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

    fn say_circle(&mut self, circle: &[usize]) {
        let name = |index: &usize| self.mechanism.parameters.get(*index).map_or("", |it| &it.name);
        let path: Vec<_> = circle.iter().chain(circle.first()).map(name).collect();
        let place = circle.first().and_then(|it| self.parameters.get(*it)).map(|it| it.place);
        let message = format!("the values depend on each other: {}", path.join(" → "));
        self.report.say(place.unwrap_or_default(), message, "give one of them a number");
    }

    fn parameters_in(&self, file: Option<&FileExpression>) -> Vec<usize> {
        let parts = file.map_or(&[][..], |it| &it.expression.parts);
        let names = parts.iter().filter_map(|part| match &part.shape {
            Shape::Name { name, .. } => self.parameter_index(name),
            _ => None,
        });
        names.collect()
    }

    fn preset_value(
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

    /// Reads what must hold among the parameters.
    pub(super) fn requirements(&mut self, root: &mut KeyReader<'_>) {
        for item in root.list(&mut self.report, "requires") {
            let Some(file) = self.written_as("requires", item, Form::Condition) else { continue };
            let Some(value) = self.value(&file, CONSTANT) else { continue };
            let place = self.report.position(file.place).unwrap_or((1, 1));
            let text = file.expression.text.clone();
            self.mechanism.requirements.push(Requirement { text, margin: value.node, place });
            self.requirement_places.push(file.place);
        }
    }
}

/// The names in a preset's formulas: the key, and other parameters of the same preset.
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
            return Ok(Measured { node, dimension: Dimension::NONE, reach: Reach::KEY });
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

    fn allowed(&self) -> Reach {
        Reach::KEY
    }
}
