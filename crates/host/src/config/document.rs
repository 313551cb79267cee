//! TOML as a plain tree that knows where each part was written.

use toml_edit::{Document, InlineTable, Item, Key, Table, TableLike};

use super::report::{Place, Report};

/// Lines that are left out in turn because they are no TOML, to find more mistakes after them.
const MOST_BROKEN_LINES: usize = 20;

/// A value and where it stands.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Node {
    pub(super) place: Place,
    pub(super) value: Value,
}

/// What TOML can say.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Value {
    Text(String),
    Integer(i64),
    Float(f64),
    Truth(bool),
    Date,
    List(Vec<Node>),
    Table(Vec<Entry>),
}

/// A name with its value.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Entry {
    pub(super) name: String,
    /// Where the name stands.
    pub(super) place: Place,
    pub(super) node: Node,
}

impl Node {
    /// What it is, for people.
    pub(super) const fn kind(&self) -> &'static str {
        match self.value {
            Value::Text(_) => "text",
            Value::Integer(_) | Value::Float(_) => "a number",
            Value::Truth(_) => "true or false",
            Value::Date => "a date",
            Value::List(_) => "a list",
            Value::Table(_) => "a table",
        }
    }

    /// The entries, if it is a table.
    pub(super) fn entries(&self) -> Option<&[Entry]> {
        match &self.value {
            Value::Table(entries) => Some(entries),
            Value::Text(_)
            | Value::Integer(_)
            | Value::Float(_)
            | Value::Truth(_)
            | Value::Date
            | Value::List(_) => None,
        }
    }

    /// The items, if it is a list.
    pub(super) fn items(&self) -> Option<&[Self]> {
        match &self.value {
            Value::List(nodes) => Some(nodes),
            Value::Text(_)
            | Value::Integer(_)
            | Value::Float(_)
            | Value::Truth(_)
            | Value::Date
            | Value::Table(_) => None,
        }
    }

    /// The item with this index, if it is a list with so many.
    pub(super) fn item_mut(&mut self, index: usize) -> Option<&mut Self> {
        if let Value::List(nodes) = &mut self.value { nodes.get_mut(index) } else { None }
    }

    /// The value of an override: TOML, or text without its quotes.
    pub(super) fn overriding(text: &str, place: Place) -> Self {
        match text.parse::<toml_edit::Value>() {
            Ok(value) => from_value(&value, &|_| place),
            Err(_no_toml) => Self { place, value: Value::Text(text.to_owned()) },
        }
    }
}

/// Reads the report's file; says every line that is no TOML and reads on without it.
///
/// Nothing comes back where what is left could not be understood.
pub(super) fn parse(report: &mut Report<'_>) -> Option<Node> {
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
        report.say(Place::At(offset), format!("this is not TOML, {message}"), "correct the line");
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

/// The place of something that was parsed.
fn at(span: Option<std::ops::Range<usize>>) -> Place {
    Place::At(span.map_or(0, |span| span.start))
}

type Locate<'a> = &'a dyn Fn(Option<std::ops::Range<usize>>) -> Place;

fn from_item(item: &Item, locate: Locate<'_>) -> Node {
    match item {
        Item::None => Node { place: locate(None), value: Value::Table(Vec::new()) },
        Item::Value(value) => from_value(value, locate),
        Item::Table(table) => from_table(table, table.span(), locate),
        Item::ArrayOfTables(tables) => {
            let nodes = tables.iter().map(|table: &Table| from_table(table, table.span(), locate));
            Node { place: locate(tables.span()), value: Value::List(nodes.collect()) }
        }
    }
}

fn from_value(value: &toml_edit::Value, locate: Locate<'_>) -> Node {
    use toml_edit::Value as Toml;
    let plain = match value {
        Toml::String(text) => Value::Text(text.value().clone()),
        Toml::Integer(number) => Value::Integer(*number.value()),
        Toml::Float(number) => Value::Float(*number.value()),
        Toml::Boolean(truth) => Value::Truth(*truth.value()),
        Toml::Datetime(_) => Value::Date,
        Toml::Array(list) => {
            Value::List(list.iter().map(|value| from_value(value, locate)).collect())
        }
        Toml::InlineTable(table) => return from_inline(table, locate),
    };
    Node { place: locate(value.span()), value: plain }
}

fn from_inline(table: &InlineTable, locate: Locate<'_>) -> Node {
    from_table(table, table.span(), locate)
}

fn from_table(
    table: &dyn TableLike,
    span: Option<std::ops::Range<usize>>,
    locate: Locate<'_>,
) -> Node {
    let entries = table.iter().map(|(name, item)| {
        let node = from_item(item, locate);
        let place = match table.key(name).and_then(Key::span) {
            Some(span) => locate(Some(span)),
            None => node.place,
        };
        Entry { name: name.to_owned(), place, node }
    });
    Node { value: Value::Table(entries.collect()), place: locate(span) }
}
