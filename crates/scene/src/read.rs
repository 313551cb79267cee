//! Typed entries of scenes: numbers with units, texts, names of a list; invalid ones are reported.

use super::quantity::{self, Quantity, QuantityError};
pub(super) use documents::toml::wrong_kind;
use documents::toml::{FindingList, KeyReader, SourcePlace, TomlEntry, TomlKind, TomlNode};
use documents::{choice, quoted};

#[derive(Debug)]
pub(super) struct TableReader<'a> {
    keys: KeyReader<'a>,
    pub(super) place: SourcePlace,
}

impl<'a> TableReader<'a> {
    /// Returns a reader of `node`, called `name`; reports a node that is no table.
    pub(super) fn new(report: &mut FindingList, name: &str, node: &'a TomlNode) -> Option<Self> {
        let help = match report.typed_at(node.place) {
            None => format!("write it as [{name}]"),
            Some(_) => "set the values in it one by one".to_owned(),
        };
        let keys = KeyReader::of_table(report, name, node, &help)?;
        Some(Self { keys, place: node.place })
    }

    pub(super) fn take(&mut self, name: &'static str) -> Option<&'a TomlEntry> {
        self.keys.take(name)
    }

    pub(super) fn table(&mut self, report: &mut FindingList, name: &'static str) -> Option<Self> {
        let entry = self.take(name)?;
        Self::new(report, name, &entry.node)
    }

    /// Returns the number called `name`, if it exists and is valid.
    pub(super) fn number(
        &mut self,
        report: &mut FindingList,
        name: &'static str,
        quantity: Quantity,
    ) -> Option<f64> {
        let entry = self.take(name)?;
        number(report, name, &entry.node, quantity)
    }

    pub(super) fn whole(
        &mut self,
        report: &mut FindingList,
        name: &'static str,
        quantity: Quantity,
    ) -> Option<u32> {
        let entry = self.take(name)?;
        whole(report, name, &entry.node, quantity)
    }

    /// Returns the text called `name` and its place, if it exists and is not empty.
    pub(super) fn text(
        &mut self,
        report: &mut FindingList,
        name: &'static str,
    ) -> Option<(String, SourcePlace)> {
        let entry = self.take(name)?;
        text(report, name, &entry.node).map(|text| (text, entry.node.place))
    }

    /// Returns the one of `all` with the name in the text called `name`, if it exists and is valid.
    ///
    /// `refusal` precedes an unknown name in the message, as "there is no stepper".
    pub(super) fn choice<T: Copy>(
        &mut self,
        report: &mut FindingList,
        name: &'static str,
        refusal: &str,
        all: &[(&str, T)],
    ) -> Option<T> {
        let node = &self.take(name)?.node;
        let names = all.iter().map(|(known, _)| *known);
        let Some(wanted) = plain_text(report, node) else {
            wrong_kind(report, name, node, "text", &choice("", names));
            return None;
        };
        let found = all.iter().find(|(known, _)| *known == wanted).map(|(_, value)| *value);
        if found.is_none() {
            unknown(report, node.place, refusal, &wanted, names);
        }
        found
    }

    /// Reports every entry that was not read.
    pub(super) fn finish(self, report: &mut FindingList) {
        self.keys.finish(report);
    }
}

/// Reports the unknown name `wanted` and all known names.
///
/// `refusal` precedes the name, as "there is no stepper".
pub(super) fn unknown(
    report: &mut FindingList,
    place: SourcePlace,
    refusal: &str,
    wanted: &str,
    known: impl IntoIterator<Item = impl AsRef<str>>,
) {
    report.say(place, format!("{refusal} {}", quoted(wanted)), choice(wanted, known));
}

fn plain_text(report: &FindingList, node: &TomlNode) -> Option<String> {
    match &node.kind {
        TomlKind::Text(text, _) => Some(text.clone()),
        // The shell removes quotes on the command line, so `title=1984` means text.
        TomlKind::Integer(_) | TomlKind::Float(_) | TomlKind::Truth(_) | TomlKind::Date => {
            report.typed_at(node.place).map(str::to_owned)
        }
        TomlKind::List(_) | TomlKind::Table(_) => None,
    }
}

pub(super) fn text(report: &mut FindingList, name: &str, node: &TomlNode) -> Option<String> {
    let Some(text) = plain_text(report, node) else {
        wrong_kind(report, name, node, "text", "write it in quotes");
        return None;
    };
    if text.trim().is_empty() {
        let message = format!("{} is empty", quoted(name));
        report.say(node.place, message, "fill it in or leave it out");
        return None;
    }
    Some(text)
}

/// Returns the number of `node`, called `name`, in SI, within its range.
pub(super) fn number(
    report: &mut FindingList,
    name: &str,
    node: &TomlNode,
    quantity: Quantity,
) -> Option<f64> {
    let value = match &node.kind {
        TomlKind::Integer(value) => *value as f64,
        TomlKind::Float(value) => *value,
        TomlKind::Text(text, _) => match quantity::parse(text, quantity.unit) {
            Ok(value) => value,
            Err(refusal) => {
                refuse(report, name, node.place, text, &refusal, quantity);
                return None;
            }
        },
        TomlKind::Truth(_) | TomlKind::Date | TomlKind::List(_) | TomlKind::Table(_) => {
            let help = format!("give {}", quantity.show_range());
            wrong_kind(report, name, node, "a number", &help);
            return None;
        }
    };
    if !quantity.allows(value) {
        let message = format!("{} is {}, out of range", quoted(name), quantity.show(value));
        report.say(node.place, message, format!("give {}", quantity.show_range()));
        return None;
    }
    Some(value)
}

/// Returns the whole number of `node`, called `name`, within its range of small positive numbers.
pub(super) fn whole(
    report: &mut FindingList,
    name: &str,
    node: &TomlNode,
    quantity: Quantity,
) -> Option<u32> {
    let value = number(report, name, node, quantity)?;
    if 0.0 < value.fract() {
        let message = format!("{} is {value}, not a whole number", quoted(name));
        report.say(node.place, message, format!("round it, as {}", value.round()));
        return None;
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the range was checked and is far inside that of u32"
    )]
    let whole = value as u32;
    Some(whole)
}

pub(super) fn tables<'a>(
    report: &mut FindingList,
    name: &str,
    node: &'a TomlNode,
) -> &'a [TomlNode] {
    node.items().unwrap_or_else(|| {
        wrong_kind(report, name, node, "a list", &format!("write it as [[{name}]]"));
        &[]
    })
}

fn refuse(
    report: &mut FindingList,
    name: &str,
    place: SourcePlace,
    text: &str,
    refusal: &QuantityError,
    quantity: Quantity,
) {
    let name = quoted(name);
    let example = |value: f64| match quantity.unit {
        "1" => format!("it has none, write {}", quantity::number(value)),
        unit => format!("give it in {unit}, as \"{}\"", quantity.show(value)),
    };
    let (message, help) = match refusal {
        QuantityError::NoNumber => (
            format!("{name} is {}, not a number", quoted(text)),
            format!("give {}", quantity.show_range()),
        ),
        QuantityError::NoUnit(value) => (format!("{name} is text without a unit"), example(*value)),
        // The number in another unit is not meant: 4 kHz is not 4 Hz.
        QuantityError::WrongUnit(value, unit) => (
            format!("{name} has the wrong unit {}", quoted(unit)),
            match quantity.unit {
                "1" => example(*value),
                unit => format!("give it in {unit}, {}", quantity.show_range()),
            },
        ),
    };
    report.say(place, message, help);
}
