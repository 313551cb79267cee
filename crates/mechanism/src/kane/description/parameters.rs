//! Parameters, their units and ranges, and requirements among them.
#![expect(
    clippy::wildcard_enum_match_arm,
    reason = "TOML has many kinds of values, and each place takes few of them"
)]

use documents::quoted;
use documents::toml::{KeyReader, TomlEntry, TomlKind};
use instruments::equations::table::Reading;

use super::items::{FileExpression, ParameterText};
use super::names::SymbolKind;
use super::reader::{CONSTANT, MechanismReader};
use crate::kane::mechanism::{MechanismParameter, Requirement};
use crate::kane::text::{self, Dimension, Form, PartShape};

impl MechanismReader {
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
        let unit = match value.as_ref().and_then(|value| self.without_unit(&mut keys, value)) {
            Some(()) => None,
            None => self.parameter_unit(&mut keys, value.as_ref()),
        };
        let (unit, dimension) = self.or_vague(&entry.name, unit);
        let range = self.range(&mut keys, "range", &entry.name, dimension);
        let title = keys.text(&mut self.report, "title").map(|(it, _)| it.to_owned());
        let doc = keys.text(&mut self.report, "doc").map(|(it, _)| it.to_owned());
        let reading = self.reading(&mut keys, dimension);
        keys.finish(&mut self.report);
        let kind = SymbolKind::Parameter(self.parameters.len());
        if !self.symbol(entry, kind) {
            return;
        }
        self.names.parameters.push(dimension);
        self.parameters.push(ParameterText { value, place: entry.place, dimension });
        let name = entry.name.clone();
        self.mechanism.parameters.push(MechanismParameter {
            title: title.unwrap_or_else(|| name.clone()),
            name,
            unit,
            range: range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY)),
            doc: doc.unwrap_or_default(),
            reading,
        });
    }

    /// Reads the display of a parameter: its step, and a reading that is not the value itself.
    fn reading(&mut self, keys: &mut KeyReader<'_>, dimension: Dimension) -> Reading {
        let mut reading = Reading::default();
        if let Some(entry) = keys.take("step") {
            reading.step = self.constant("step", &entry.node, dimension).filter(|it| 0.0 < *it);
            if reading.step.is_none() {
                self.report.say(entry.place, "a step is not positive", "write step = \"0.1 mm\"");
            }
        }
        let Some(entry) = keys.take("reading") else { return reading };
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return reading };
        let mut number = |name: &'static str, dimension| {
            let found = keys.take(name);
            found.and_then(|it| self.constant(name, &it.node, dimension))
        };
        let (at, is) = (number("at", dimension), number("is", dimension));
        let per = number("per", Dimension::NONE).filter(|it| *it != 0.0);
        keys.finish(&mut self.report);
        if let (Some(at), Some(is), Some(per)) = (at, is, per) {
            (reading.per, reading.offset) = (per, is - per * at);
        } else {
            let help = "write reading = { at = \"61 mm\", is = \"2 mm\", per = -6 }";
            self.report.miss(entry.place, "a reading is not complete", help);
        }
        reading
    }

    /// Returns the stated unit, or the one in which the value is written.
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
            PartShape::Number { dimension, .. } => Some(dimension),
            _ => None,
        });
        let unit = value.expression.literal_unit().unwrap_or("1").to_owned();
        Some((unit, dimension.unwrap_or_default()))
    }

    /// Reports a bare number as value beside a range with a unit.
    fn without_unit(&mut self, keys: &mut KeyReader<'_>, value: &FileExpression) -> Option<()> {
        let is_bare = value.expression.is_literal() && value.expression.literal_unit().is_none();
        let ends = keys.take("range").filter(|_| is_bare)?.node.items()?;
        let unit = ends.iter().find_map(|end| {
            let end = text::parse(end.text()?, Form::Value).ok()?;
            end.is_literal().then(|| end.literal_unit().map(str::to_owned)).flatten()
        })?;
        let message = format!("the value has no unit, but its range is in {unit}");
        let help = format!("write its unit, as \"{} {unit}\"", value.expression.text.trim());
        self.report.say(value.place, message, help);
        Some(())
    }

    /// Returns the unit of `name`; without one, its dependents are not checked.
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

    pub(super) fn requirements(&mut self, root: &mut KeyReader<'_>) {
        for item in root.list(&mut self.report, "requires") {
            let Some(file) = self.written_as("requires", item, Form::Condition) else { continue };
            let Some(value) = self.value(&file, CONSTANT) else { continue };
            let place = self.report.position(file.place).unwrap_or((1, 1));
            let text = file.expression.text.clone();
            self.mechanism.instrument.requirements.push(Requirement {
                text,
                margin: value.node,
                place,
            });
            self.places.requirements.push(file.place);
        }
    }
}
