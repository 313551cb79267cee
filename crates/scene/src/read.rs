//! Typed access to a table: wrong entries are reported, and so are unknown ones.

use super::document::{DocumentEntry, DocumentNode, TomlValue};
use super::quantity::{self, Quantity, QuantityError};
use super::report::{Location, MistakeList};
use diagnostics::{choice, quoted};

/// Reads the entries of one table.
#[derive(Debug)]
pub(super) struct TableReader<'a> {
    entries: &'a [DocumentEntry],
    /// The place of the table.
    pub(super) place: Location,
    /// Every name that was asked for.
    known: Vec<&'static str>,
}

impl<'a> TableReader<'a> {
    /// Returns a reader of `node`, called `name`; reports what is not a table.
    pub(super) fn new(
        report: &mut MistakeList<'_>,
        name: &str,
        node: &'a DocumentNode,
    ) -> Option<Self> {
        let Some(entries) = node.entries() else {
            let help = match node.place {
                Location::At(_) => format!("write it as [{name}]"),
                Location::Override(_) => "set the values in it one by one".to_owned(),
            };
            wrong_type(report, name, node, "a table", &help);
            return None;
        };
        Some(Self { entries, place: node.place, known: Vec::new() })
    }

    /// Returns the entry called `name`, if it is there.
    pub(super) fn take(&mut self, name: &'static str) -> Option<&'a DocumentEntry> {
        if !self.known.contains(&name) {
            self.known.push(name);
        }
        self.entries.iter().find(|entry| entry.name == name)
    }

    /// Returns the table called `name`, if it is there.
    pub(super) fn table(
        &mut self,
        report: &mut MistakeList<'_>,
        name: &'static str,
    ) -> Option<Self> {
        let entry = self.take(name)?;
        Self::new(report, name, &entry.node)
    }

    /// Returns the number called `name`, if it is there and right.
    pub(super) fn number(
        &mut self,
        report: &mut MistakeList<'_>,
        name: &'static str,
        quantity: Quantity,
    ) -> Option<f64> {
        let entry = self.take(name)?;
        number(report, name, &entry.node, quantity)
    }

    /// Returns the whole number called `name`, if it is there and right.
    pub(super) fn whole(
        &mut self,
        report: &mut MistakeList<'_>,
        name: &'static str,
        quantity: Quantity,
    ) -> Option<u32> {
        let entry = self.take(name)?;
        whole(report, name, &entry.node, quantity)
    }

    /// Returns the text called `name`, if it is there and not empty, with its place.
    pub(super) fn text(
        &mut self,
        report: &mut MistakeList<'_>,
        name: &'static str,
    ) -> Option<(String, Location)> {
        let entry = self.take(name)?;
        text(report, name, &entry.node).map(|text| (text, entry.node.place))
    }

    /// Returns the one of `all` whose name is the text called `name`, if it is there and right.
    ///
    /// `refusal` is said before a wrong name, as "there is no stepper".
    pub(super) fn choice<T: Copy>(
        &mut self,
        report: &mut MistakeList<'_>,
        name: &'static str,
        refusal: &str,
        all: &[(&str, T)],
    ) -> Option<T> {
        let node = &self.take(name)?.node;
        let names = all.iter().map(|(known, _)| *known);
        let Some(wanted) = plain_text(report, node) else {
            wrong_type(report, name, node, "text", &choice("", names));
            return None;
        };
        let found = all.iter().find(|(known, _)| *known == wanted).map(|(_, value)| *value);
        if found.is_none() {
            unknown(report, node.place, refusal, &wanted, names);
        }
        found
    }

    /// Reports every entry that was never asked for.
    pub(super) fn finish(self, report: &mut MistakeList<'_>) {
        for entry in self.entries {
            if !self.known.contains(&entry.name.as_str()) {
                let message = format!("there is no key {} here", quoted(&entry.name));
                report.say(entry.place, message, choice(&entry.name, self.known.iter().copied()));
            }
        }
    }
}

/// Reports that nothing is called `wanted`, and which names there are.
///
/// `refusal` is said before the name, as "there is no stepper".
pub(super) fn unknown(
    report: &mut MistakeList<'_>,
    place: Location,
    refusal: &str,
    wanted: &str,
    known: impl IntoIterator<Item = impl AsRef<str>>,
) {
    report.say(place, format!("{refusal} {}", quoted(wanted)), choice(wanted, known));
}

/// Reports that `node`, called `name`, should be something else.
pub(super) fn wrong_type(
    report: &mut MistakeList<'_>,
    name: &str,
    node: &DocumentNode,
    expected: &str,
    help: &str,
) {
    let message = format!("{} is {}, not {expected}", quoted(name), node.kind());
    report.say(node.place, message, help);
}

/// Returns the text of `node`, if it is any.
fn plain_text(report: &MistakeList<'_>, node: &DocumentNode) -> Option<String> {
    match &node.value {
        TomlValue::Text(text) => Some(text.clone()),
        // On the command line quotes are the shell's, so `title=1984` is meant as text.
        TomlValue::Integer(_) | TomlValue::Float(_) | TomlValue::Truth(_) | TomlValue::Date => {
            report.overriding(node.place).map(str::to_owned)
        }
        TomlValue::List(_) | TomlValue::Table(_) => None,
    }
}

/// Returns the text of `node`, called `name`; not empty.
pub(super) fn text(
    report: &mut MistakeList<'_>,
    name: &str,
    node: &DocumentNode,
) -> Option<String> {
    let Some(text) = plain_text(report, node) else {
        wrong_type(report, name, node, "text", "write it in quotes");
        return None;
    };
    if text.trim().is_empty() {
        let message = format!("{} is empty", quoted(name));
        report.say(node.place, message, "fill it in or leave it out");
        return None;
    }
    Some(text)
}

/// Returns the number of `node`, called `name`, in SI; within its range.
pub(super) fn number(
    report: &mut MistakeList<'_>,
    name: &str,
    node: &DocumentNode,
    quantity: Quantity,
) -> Option<f64> {
    let value = match &node.value {
        TomlValue::Integer(value) => *value as f64,
        TomlValue::Float(value) => *value,
        TomlValue::Text(text) => match quantity::parse(text, quantity.unit) {
            Ok(value) => value,
            Err(refusal) => {
                refuse(report, name, node.place, text, &refusal, quantity);
                return None;
            }
        },
        TomlValue::Truth(_) | TomlValue::Date | TomlValue::List(_) | TomlValue::Table(_) => {
            let help = format!("give {}", quantity.show_range());
            wrong_type(report, name, node, "a number", &help);
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

/// Returns the whole number of `node`, called `name`; within its range of small positive numbers.
pub(super) fn whole(
    report: &mut MistakeList<'_>,
    name: &str,
    node: &DocumentNode,
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

/// Returns the nodes of a list of tables.
pub(super) fn tables<'a>(
    report: &mut MistakeList<'_>,
    name: &str,
    node: &'a DocumentNode,
) -> &'a [DocumentNode] {
    node.items().unwrap_or_else(|| {
        wrong_type(report, name, node, "a list", &format!("write it as [[{name}]]"));
        &[]
    })
}

/// Reports that `text` is not the quantity called `name`.
fn refuse(
    report: &mut MistakeList<'_>,
    name: &str,
    place: Location,
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
        // Its number is not the one that is meant: 4 kHz is not 4 Hz.
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
