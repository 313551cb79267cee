//! Instruments as differences from another one: `base`, `[differences]` and `[base_values]`.
//!
//! ```toml
//! base = "grand"
//! base_hash = "9f2c04d1b35e8a67"       # of the base's values when the file was written
//! [differences]                        # points; straight between, none outside
//! button = { offset = [["C7", 1e-5], ["C8", 3e-5]] }
//! mh = [{ factor = [["C4", 1.1]] }, { value = [["D4", 0.009]] }]
//! [base_values]                        # one value, or one for each key
//! g = 9.81
//! ```
//!
//! With `[base_values]` the instrument is played as it was saved, else it follows its base.

use std::sync::Arc;

use crc::{CRC_64_XZ, Crc};
use instruments::Parameter;
use keyboard::{Difference, KEYS, KeyIndex};
use mechanism::Library;
use toml_edit::{Array, DocumentMut, InlineTable, Item, Table, Value, value};

use super::based::{Based, CompassDifferences, CompassValues, InstrumentEdit};
use super::embedded::INSTRUMENTS;
use super::instrument::Instrument;
use super::quantity::Quantity;
use super::read::{self, TableReader, unknown, wrong_kind};
use super::source::{SourceError, SourceText};
use documents::quoted;
use documents::toml::{FindingList, SourcePlace, TomlKind, TomlNode};

const KINDS: [(&str, Difference); 3] = [
    ("offset", Difference::Offset(0.0)),
    ("factor", Difference::Factor(1.0)),
    ("value", Difference::Value(0.0)),
];

const POINTS: &str = "write { offset = [[\"C4\", 0.0001], [\"C5\", 0.0002]] }, or factor, or value";

fn values_of(instrument: &Instrument) -> Vec<CompassValues> {
    let by_key: Vec<_> = KeyIndex::all().map(|key| instrument.values(key.number())).collect();
    let parameters = 0..instrument.model().parameters.len();
    parameters.map(|index| std::array::from_fn(|key| by_key[key][index])).collect()
}

fn hash(parameters: &[Parameter], values: &[CompassValues]) -> String {
    let crc = Crc::<u64>::new(&CRC_64_XZ);
    let mut digest = crc.digest();
    for (parameter, values) in parameters.iter().zip(values) {
        digest.update(parameter.name.as_bytes());
        for value in values {
            digest.update(&value.to_bits().to_le_bytes());
        }
    }
    format!("{:016x}", digest.finalize())
}

impl Instrument {
    /// Returns this instrument with `edit` laid over it, as the text of a file with `title`.
    /// `name` is its own name, or a path that is valid everywhere.
    ///
    /// An instrument that is itself based on another one is written as differences from that one.
    pub fn edited(&self, name: &str, title: &str, edit: &InstrumentEdit) -> String {
        let parameters = &self.model().parameters;
        let own = values_of(self);
        let (base, values, edit) = match &self.based {
            None => (name.to_owned(), own, edit.clone()),
            Some(based) => (based.base.clone(), based.values.clone(), based.with(parameters, edit)),
        };
        let mut document = DocumentMut::new();
        document["title"] = value(title);
        document["doc"] = value(format!("{base} with {} parameters changed.", edit.len()));
        document["base"] = value(base);
        document["base_hash"] = value(hash(parameters, &values));
        let differences = edit.iter().map(|(name, differences)| (name, written(differences)));
        document["differences"] = Item::Table(differences.collect());
        let all = parameters.iter().zip(&values);
        let all = all.map(|(parameter, values)| (parameter.name, written_values(values)));
        document["base_values"] = Item::Table(all.collect::<Table>());
        document.to_string()
    }

    /// Returns this instrument with its differences laid over the present values of its base.
    ///
    /// # Errors
    /// A sentence if it has no base, or if a value is out of range.
    pub fn on_present_base(mut self) -> Result<Self, String> {
        let Some(mut based) = self.based.take() else { return Err("it has no base".to_owned()) };
        let refused = |(message, help): (String, String)| format!("{message}; {help}");
        self.lay(&based.present, &based.edit).map_err(refused)?;
        based.values.clone_from(&based.present);
        self.based = Some(Based { has_changed: false, ..based });
        Ok(self)
    }

    /// Sets all values to `values` with `edit` laid over them; the error is a message and help.
    fn lay(
        &mut self,
        values: &[CompassValues],
        edit: &InstrumentEdit,
    ) -> Result<(), (String, String)> {
        let parameters = self.model().parameters.clone();
        for (index, (parameter, values)) in parameters.iter().zip(values).enumerate() {
            let edited = edited(values, edit.get(parameter.name));
            let quantity = Quantity { unit: parameter.unit, range: parameter.range };
            if let Some(value) = edited.iter().find(|value| !quantity.allows(**value)) {
                let (name, value) = (quoted(parameter.name), quantity.show(*value));
                let help = format!("stay in {}", quantity.show_range());
                return Err((format!("{name} becomes {value}, out of range"), help));
            }
            self.voicing.set_values(index, Arc::new(edited));
        }
        Ok(())
    }

    /// Reads the rest of an instrument with a base; `place` is that of `base`.
    pub(super) fn read_edited(
        report: &mut FindingList,
        reader: &mut TableReader<'_>,
        (name, place): (&str, SourcePlace),
        library: &Library,
    ) -> Option<Self> {
        let base = find_base(report, (name, place), library);
        let hash_text = reader.text(report, "base_hash");
        let (differences, saved) = (reader.take("differences"), reader.take("base_values"));
        let mut instrument = base?;
        let parameters = instrument.model().parameters.clone();
        let present = values_of(&instrument);
        let mut values = present.clone();
        if let Some(entry) = saved {
            read_values(report, &entry.node, &parameters, &mut values);
        }
        let hash_of_values = hash(&parameters, &values);
        let other_hash = hash_text.filter(|(text, _)| saved.is_some() && *text != hash_of_values);
        if let Some((_, place)) = other_hash {
            let message = "the base values are not those that were saved with this hash";
            let help = "remove base_hash to keep them, or [base_values] to follow the base";
            report.say(place, message, help);
        }
        let edit = differences.map(|entry| read_edit(report, &entry.node, &parameters));
        let edit = edit.unwrap_or_default();
        let has_changed = hash_of_values != hash(&parameters, &present);
        if let Err((message, help)) = instrument.lay(&values, &edit) {
            report.say(place, message, help);
        }
        instrument.based =
            Some(Based { base: name.to_owned(), has_changed, edit, values, present });
        Some(instrument)
    }
}

impl Based {
    fn with(&self, parameters: &[Parameter], edit: &InstrumentEdit) -> InstrumentEdit {
        let mut all = self.edit.clone();
        for (name, after) in edit {
            let Some(index) = parameters.iter().position(|it| it.name == *name) else { continue };
            let differences = all.entry(name.clone()).or_insert([None; KEYS]);
            let bases = &self.values[index];
            for ((difference, after), base) in differences.iter_mut().zip(after).zip(bases) {
                let both = difference.zip(*after);
                let both = both.map(|(before, after)| before.then(after, *base));
                *difference = both.or(*after).or(*difference);
            }
        }
        all
    }
}

fn edited(values: &CompassValues, differences: Option<&CompassDifferences>) -> CompassValues {
    std::array::from_fn(|key| {
        let difference = differences.and_then(|it| it[key]);
        difference.map_or(values[key], |difference| difference.applied_to(values[key]))
    })
}

fn find_base(
    report: &mut FindingList,
    (name, place): (&str, SourcePlace),
    library: &Library,
) -> Option<Instrument> {
    let source = match SourceText::find(&INSTRUMENTS, name, report.folder(place)) {
        Ok(source) => source,
        Err(SourceError::Unknown((message, help))) => {
            report.say(place, message, help);
            return None;
        }
        Err(SourceError::Unreadable(diagnostics)) => {
            report.absorb(diagnostics);
            return None;
        }
    };
    match Instrument::check_base(library, &source) {
        Ok(base) => Some(base),
        Err(diagnostics) => {
            report.absorb(diagnostics);
            None
        }
    }
}

/// Reads the values of all keys into `values`; parameters that are not listed keep theirs.
fn read_values(
    report: &mut FindingList,
    node: &TomlNode,
    parameters: &[Parameter],
    values: &mut [CompassValues],
) {
    for (index, node) in by_parameter(report, "base_values", node, parameters) {
        let Parameter { name, unit, range, .. } = parameters[index];
        let quantity = Quantity { unit, range };
        let TomlKind::List(items) = &node.kind else {
            let value = read::number(report, name, node, quantity);
            values[index] = value.map_or(values[index], |value| [value; KEYS]);
            continue;
        };
        if items.len() != KEYS {
            let message = format!("{} has {} values", quoted(name), items.len());
            report.say(node.place, message, "give one for all keys, or one for each of 88");
            continue;
        }
        for (value, item) in values[index].iter_mut().zip(items) {
            *value = read::number(report, name, item, quantity).unwrap_or(*value);
        }
    }
}

/// Returns the entries of a table by parameters; reports unknown names.
fn by_parameter<'a>(
    report: &mut FindingList,
    table: &str,
    node: &'a TomlNode,
    parameters: &[Parameter],
) -> Vec<(usize, &'a TomlNode)> {
    let Some(entries) = node.entries() else {
        wrong_kind(report, table, node, "a table", &format!("write it as [{table}]"));
        return Vec::new();
    };
    let mut found = Vec::new();
    for entry in entries {
        if let Some(index) = parameters.iter().position(|it| it.name == entry.name) {
            found.push((index, &entry.node));
        } else {
            let known = parameters.iter().map(|it| it.name);
            unknown(report, entry.place, "the base has no parameter", &entry.name, known);
        }
    }
    found
}

fn read_edit(
    report: &mut FindingList,
    node: &TomlNode,
    parameters: &[Parameter],
) -> InstrumentEdit {
    let mut edit = InstrumentEdit::new();
    for (index, node) in by_parameter(report, "differences", node, parameters) {
        let name = parameters[index].name;
        let mut differences = [None; KEYS];
        for line in node.items().unwrap_or(std::slice::from_ref(node)) {
            read_line(report, (name, parameters[index].unit), line, &mut differences);
        }
        edit.insert(name.to_owned(), differences);
    }
    edit
}

fn read_line(
    report: &mut FindingList,
    (name, unit): (&str, &'static str),
    node: &TomlNode,
    differences: &mut CompassDifferences,
) {
    let kind = node.entries().and_then(|entries| match entries {
        [entry] => Some((KINDS.iter().find(|(kind, _)| *kind == entry.name)?.1, &entry.node)),
        _ => None,
    });
    let Some((kind, list)) = kind else {
        wrong_kind(report, name, node, "a line of differences", POINTS);
        return;
    };
    let is_factor = kind.is_like(Difference::Factor(1.0));
    let quantity =
        Quantity { unit: if is_factor { "1" } else { unit }, range: (f64::MIN, f64::MAX) };
    let mut points: Vec<(usize, f64)> = Vec::new();
    for point in list.items().unwrap_or_default() {
        let key = match point.items() {
            Some([key, value]) => {
                let key = key.text().and_then(|text| text.parse::<KeyIndex>().ok());
                key.zip(read::number(report, name, value, quantity))
            }
            _ => None,
        };
        let Some((key, value)) = key else {
            wrong_kind(report, name, point, "a note and a number", POINTS);
            return;
        };
        if points.last().is_some_and(|(before, _)| key.index() <= *before) {
            report.say(point.place, format!("{key} comes too early"), "sort the points by key");
            return;
        }
        points.push((key.index(), value));
    }
    if points.is_empty() {
        wrong_kind(report, name, list, "a list of points", POINTS);
    }
    lay(kind, &points, differences);
}

fn lay(kind: Difference, points: &[(usize, f64)], differences: &mut CompassDifferences) {
    for pair in points.windows(2) {
        let ((low, _), (high, _)) = (pair[0], pair[1]);
        for (key, difference) in differences.iter_mut().enumerate().take(high).skip(low) {
            *difference = Some(kind.with_amount(between(pair[0], pair[1], key)));
        }
    }
    if let Some((key, amount)) = points.last() {
        differences[*key] = Some(kind.with_amount(*amount));
    }
}

/// Returns the value at `key` of the straight line between two points; exact at both.
fn between((low, a): (usize, f64), (high, b): (usize, f64), key: usize) -> f64 {
    if key == high {
        return b;
    }
    a + (b - a) * ((key - low) as f64 / (high - low) as f64)
}

/// Returns lines through as few points as give every difference to the last bit.
fn written(differences: &CompassDifferences) -> Item {
    let mut lines = Array::new();
    let mut first = 0;
    while first < KEYS {
        let Some(kind) = differences[first] else {
            first += 1;
            continue;
        };
        let alike = |it: &&Option<Difference>| it.is_some_and(|it| it.is_like(kind));
        let amounts: Vec<f64> = differences[first..]
            .iter()
            .take_while(alike)
            .filter_map(|it| it.map(Difference::amount))
            .collect();
        let name = KINDS.iter().find(|(_, it)| it.is_like(kind)).map_or("value", |(name, _)| name);
        let mut line = InlineTable::new();
        line.insert(name, Value::Array(points(first, &amounts)));
        lines.push(line);
        first += amounts.len();
    }
    Item::Value(Value::Array(lines))
}

fn points(first: usize, amounts: &[f64]) -> Array {
    let point = |index: usize| -> Value {
        let note = KeyIndex::all().nth(first + index).map_or_else(String::new, |it| it.to_string());
        Value::Array([Value::from(note), Value::from(amounts[index])].into_iter().collect())
    };
    let last = amounts.len() - 1;
    let mut points = Array::from_iter([point(0)]);
    let mut here = 0;
    while here < last {
        let is_straight = |end: &usize| {
            let line = |key| between((here, amounts[here]), (*end, amounts[*end]), key);
            (here..*end).all(|key| line(key).to_bits() == amounts[key].to_bits())
        };
        here = (here + 1..=last).rev().find(is_straight).unwrap_or(last);
        points.push(point(here));
    }
    points
}

fn written_values(values: &CompassValues) -> Item {
    let is_one = values.iter().all(|value| value.to_bits() == values[0].to_bits());
    let all = || Value::Array(values.iter().copied().collect());
    Item::Value(if is_one { Value::from(values[0]) } else { all() })
}
