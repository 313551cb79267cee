//! TOML as a plain tree that knows where each part was written.

use toml_edit::{Document, InlineTable, Item, Key, Table, TableLike};

use super::report::{Location, MistakeList};

/// Lines that are left out in turn because they are no TOML, to find more mistakes after them.
const MOST_BROKEN_LINES: usize = 20;

/// A value and where it stands.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct DocumentNode {
    pub(super) place: Location,
    pub(super) value: TomlValue,
}

/// A value of TOML.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum TomlValue {
    Text(String),
    Integer(i64),
    Float(f64),
    Truth(bool),
    Date,
    List(Vec<DocumentNode>),
    Table(Vec<DocumentEntry>),
}

/// A name with its value.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct DocumentEntry {
    pub(super) name: String,
    /// The place of the name.
    pub(super) place: Location,
    pub(super) node: DocumentNode,
}

impl DocumentNode {
    /// Returns the kind of its value in words.
    pub(super) const fn kind(&self) -> &'static str {
        match self.value {
            TomlValue::Text(_) => "text",
            TomlValue::Integer(_) | TomlValue::Float(_) => "a number",
            TomlValue::Truth(_) => "true or false",
            TomlValue::Date => "a date",
            TomlValue::List(_) => "a list",
            TomlValue::Table(_) => "a table",
        }
    }

    /// Returns the entries, if it is a table.
    pub(super) fn entries(&self) -> Option<&[DocumentEntry]> {
        match &self.value {
            TomlValue::Table(entries) => Some(entries),
            TomlValue::Text(_)
            | TomlValue::Integer(_)
            | TomlValue::Float(_)
            | TomlValue::Truth(_)
            | TomlValue::Date
            | TomlValue::List(_) => None,
        }
    }

    /// Returns the items, if it is a list.
    pub(super) fn items(&self) -> Option<&[Self]> {
        match &self.value {
            TomlValue::List(nodes) => Some(nodes),
            TomlValue::Text(_)
            | TomlValue::Integer(_)
            | TomlValue::Float(_)
            | TomlValue::Truth(_)
            | TomlValue::Date
            | TomlValue::Table(_) => None,
        }
    }

    /// Returns the item with this index, if it is a list with so many.
    pub(super) fn item_mut(&mut self, index: usize) -> Option<&mut Self> {
        if let TomlValue::List(nodes) = &mut self.value { nodes.get_mut(index) } else { None }
    }

    /// Returns the value of an override: TOML, or text without its quotes.
    pub(super) fn overriding(text: &str, place: Location) -> Self {
        match text.parse::<toml_edit::Value>() {
            Ok(value) => from_value(&value, &|_| place),
            Err(_no_toml) => Self { place, value: TomlValue::Text(text.to_owned()) },
        }
    }
}

/// Reads the report's file; reports every line that is no TOML and reads on without it.
///
/// Nothing comes back where what is left could not be understood.
pub(super) fn parse(report: &mut MistakeList<'_>) -> Option<DocumentNode> {
    let mut text = report.source().text.clone();
    let mut left_out = Vec::new();
    for _ in 0..MOST_BROKEN_LINES {
        let error = match Document::parse(text.as_str()) {
            Ok(document) => return Some(from_item(document.as_item(), &at)),
            Err(error) => error,
        };
        report.broken = true;
        let offset = error.span().map_or(text.len(), |span| span.start).min(text.len());
        let start =
            text.as_bytes()[..offset].iter().rposition(|b| *b == b'\n').map_or(0, |n| n + 1);
        let len = text.as_bytes()[start..].iter().position(|b| *b == b'\n');
        let end = len.map_or(text.len(), |len| start + len);
        if left_out.contains(&start) {
            return None;
        }
        let message = error.message().replace(['\n', '\r'], " ");
        report.say(
            Location::At(offset),
            format!("this is not TOML, {message}"),
            "correct the line",
        );
        let was_header = text[start..end].trim_start().starts_with('[');
        text.replace_range(start..end, &" ".repeat(end - start));
        left_out.push(start);
        // What follows a header would be taken for something that it is not.
        if was_header {
            return None;
        }
    }
    None
}

/// Returns the place of something that was parsed.
fn at(span: Option<std::ops::Range<usize>>) -> Location {
    Location::At(span.map_or(0, |span| span.start))
}

type Locate<'a> = &'a dyn Fn(Option<std::ops::Range<usize>>) -> Location;

fn from_item(item: &Item, locate: Locate<'_>) -> DocumentNode {
    match item {
        Item::None => DocumentNode { place: locate(None), value: TomlValue::Table(Vec::new()) },
        Item::Value(value) => from_value(value, locate),
        Item::Table(table) => from_table(table, table.span(), locate),
        Item::ArrayOfTables(tables) => {
            let nodes = tables.iter().map(|table: &Table| from_table(table, table.span(), locate));
            DocumentNode { place: locate(tables.span()), value: TomlValue::List(nodes.collect()) }
        }
    }
}

fn from_value(value: &toml_edit::Value, locate: Locate<'_>) -> DocumentNode {
    use toml_edit::Value as Toml;
    let plain = match value {
        Toml::String(text) => TomlValue::Text(text.value().clone()),
        Toml::Integer(number) => TomlValue::Integer(*number.value()),
        Toml::Float(number) => TomlValue::Float(*number.value()),
        Toml::Boolean(truth) => TomlValue::Truth(*truth.value()),
        Toml::Datetime(_) => TomlValue::Date,
        Toml::Array(list) => {
            TomlValue::List(list.iter().map(|value| from_value(value, locate)).collect())
        }
        Toml::InlineTable(table) => return from_inline(table, locate),
    };
    DocumentNode { place: locate(value.span()), value: plain }
}

fn from_inline(table: &InlineTable, locate: Locate<'_>) -> DocumentNode {
    from_table(table, table.span(), locate)
}

fn from_table(
    table: &dyn TableLike,
    span: Option<std::ops::Range<usize>>,
    locate: Locate<'_>,
) -> DocumentNode {
    let entries = table.iter().map(|(name, item)| {
        let node = from_item(item, locate);
        let place = match table.key(name).and_then(Key::span) {
            Some(span) => locate(Some(span)),
            None => node.place,
        };
        DocumentEntry { name: name.to_owned(), place, node }
    });
    DocumentNode { value: TomlValue::Table(entries.collect()), place: locate(span) }
}
