//! Expressions of a file: parsed, built, and checked for their units.
#![expect(
    clippy::wildcard_enum_match_arm,
    reason = "TOML has many kinds of values, and each place takes few of them"
)]

use documents::quoted;
use documents::toml::{KeyReader, TomlKind, TomlNode, wrong_kind};

use super::MOST_EXPRESSIONS;
use super::items::{FileExpression, TextOrigin};
use super::names_in_use::NamesInUse;
use super::reader::MechanismReader;
use crate::kane::graph::Node;
use crate::kane::text::{self, Dependence, Dimension, Form, Measured, TextError};

impl MechanismReader {
    pub(super) fn written(&mut self, name: &str, node: &TomlNode) -> Option<FileExpression> {
        self.written_as(name, node, Form::Value)
    }

    pub(super) fn field(
        &mut self,
        keys: &mut KeyReader<'_>,
        name: &'static str,
    ) -> Option<FileExpression> {
        let entry = keys.take(name)?;
        self.written(name, &entry.node)
    }

    pub(super) fn written_as(
        &mut self,
        name: &str,
        node: &TomlNode,
        form: Form,
    ) -> Option<FileExpression> {
        self.size.expressions += 1;
        if self.size.expressions > MOST_EXPRESSIONS {
            self.fill(node.place, &format!("there are more than {MOST_EXPRESSIONS} expressions"));
            return None;
        }
        let (text, is_exact) = match &node.kind {
            TomlKind::Text(text, is_exact) => (text.clone(), *is_exact),
            TomlKind::Integer(number) => (number.to_string(), true),
            TomlKind::Float(number) if number.is_finite() => (format!("{number:e}"), false),
            _ => {
                let help = "write an expression in quotes, as \"2 mm\"";
                wrong_kind(&mut self.report, name, node, "an expression", help);
                return None;
            }
        };
        let origin = TextOrigin { place: node.place, is_exact };
        match text::parse(&text, form) {
            Ok(expression) => Some(FileExpression { place: node.place, origin, expression }),
            Err(error) => {
                self.say(origin, &error);
                None
            }
        }
    }

    pub(super) fn say(&mut self, origin: TextOrigin, error: &TextError) {
        let here = origin.at(error.span.start);
        let message = match &error.other {
            Some(other) => {
                let there = self.report.describe(origin.at(other.start), here);
                format!("{} (at {there})", error.message)
            }
            None => error.message.clone(),
        };
        self.report.say(here, message, error.help.clone());
    }

    pub(super) fn value(&mut self, file: &FileExpression, allowed: Dependence) -> Option<Measured> {
        if self.size.is_full {
            return None;
        }
        let mut scope = NamesInUse { names: &mut self.names, allowed };
        match text::build(&file.expression, &mut self.graph, &mut scope) {
            Ok(value) => {
                self.weigh(file.place);
                Some(value)
            }
            Err(errors) => {
                self.say_all(file, &errors);
                None
            }
        }
    }

    pub(super) fn say_all(&mut self, file: &FileExpression, errors: &[TextError]) {
        for error in errors {
            self.say(file.origin, error);
        }
    }

    pub(super) fn node(
        &mut self,
        name: &str,
        file: &FileExpression,
        allowed: Dependence,
        dimension: Dimension,
    ) -> Option<Node> {
        let value = self.value(file, allowed)?;
        self.fits(name, file, value, dimension).then_some(value.node)
    }

    /// Returns `true` if `value` of `file`, called `name`, is of `dimension`; reports a mismatch.
    pub(super) fn fits(
        &mut self,
        name: &str,
        file: &FileExpression,
        value: Measured,
        dimension: Dimension,
    ) -> bool {
        let is_plain_zero = value.dimension.is_none() && self.graph.is_zero(value.node);
        if self.names.vague.contains(name) || is_plain_zero || value.dimension.fits(dimension) {
            return true;
        }
        let message = format!("{} is in {}, not in {dimension}", quoted(name), value.dimension);
        let help = if value.dimension.is_none() && file.expression.is_literal() {
            format!("write its unit, as \"{} {dimension}\"", file.expression.text.trim())
        } else {
            format!("make it a quantity in {dimension}")
        };
        self.report.say(file.place, message, help);
        false
    }

    pub(super) fn number(
        &mut self,
        name: &str,
        file: &FileExpression,
        dimension: Dimension,
    ) -> Option<f64> {
        let node = self.node(name, file, Dependence::NOTHING, dimension)?;
        let number = self.graph.number(node);
        if number.is_none_or(|it| !it.is_finite()) {
            let message = format!("{} is no finite number", quoted(name));
            self.report.say(file.place, message, "write a number with its unit");
            return None;
        }
        number
    }

    /// Returns the number of the key `name`; bare numbers are in SI.
    pub(super) fn constant(
        &mut self,
        name: &str,
        node: &TomlNode,
        dimension: Dimension,
    ) -> Option<f64> {
        match node.kind {
            TomlKind::Integer(number) => Some(number as f64),
            TomlKind::Float(number) if number.is_finite() => Some(number),
            _ => {
                let file = self.written(name, node)?;
                self.number(name, &file, dimension)
            }
        }
    }
}
