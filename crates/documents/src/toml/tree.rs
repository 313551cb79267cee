//! TOML as a plain tree that knows where each part was written.

use std::ops::Range;

use toml_edit::{Document, Item, Key, Table, TableLike};

use super::report::{FindingList, SourcePlace};
use crate::quoted;

/// Lines that are left out in turn because they are no TOML, to find more mistakes after them.
const MOST_BROKEN_LINES: usize = 20;

/// A file that is larger than any that a person writes (bytes).
const LARGE: usize = 1 << 17;

/// Most dots on a line: a key with thousands of parts would make a tree as deep.
const MOST_DOTS: usize = 2_000;

/// A value and where it stands.
#[derive(Clone, PartialEq, Debug)]
pub struct TomlNode {
    /// Its first character; of a text see [`TextPlace`].
    pub place: SourcePlace,
    pub kind: TomlKind,
}

/// A value of TOML.
#[derive(Clone, PartialEq, Debug)]
pub enum TomlKind {
    /// A text, and whether it stands in the file as it is, without escapes.
    Text(String, bool),
    Integer(i64),
    Float(f64),
    Truth(bool),
    Date,
    List(Vec<TomlNode>),
    Table(Vec<TomlEntry>),
}

/// A name with its value.
#[derive(Clone, PartialEq, Debug)]
pub struct TomlEntry {
    pub name: String,
    pub place: SourcePlace,
    pub node: TomlNode,
}

impl TomlNode {
    /// Returns the kind of its value in words.
    pub const fn words(&self) -> &'static str {
        match self.kind {
            TomlKind::Text(..) => "text",
            TomlKind::Integer(_) | TomlKind::Float(_) => "a number",
            TomlKind::Truth(_) => "true or false",
            TomlKind::Date => "a date",
            TomlKind::List(_) => "a list",
            TomlKind::Table(_) => "a table",
        }
    }

    /// Returns the entries, if it is a table.
    pub fn entries(&self) -> Option<&[TomlEntry]> {
        if let TomlKind::Table(entries) = &self.kind { Some(entries) } else { None }
    }

    /// Returns the items, if it is a list.
    pub fn items(&self) -> Option<&[Self]> {
        if let TomlKind::List(items) = &self.kind { Some(items) } else { None }
    }

    /// Returns the text, if it is any.
    pub fn text(&self) -> Option<&str> {
        if let TomlKind::Text(text, _) = &self.kind { Some(text) } else { None }
    }

    /// Returns the item with this index, if it is a list with so many.
    pub fn item_mut(&mut self, index: usize) -> Option<&mut Self> {
        if let TomlKind::List(items) = &mut self.kind { items.get_mut(index) } else { None }
    }

    /// Returns the value of an override at `place`: TOML, or text without its quotes.
    pub fn typed(text: &str, place: SourcePlace) -> Self {
        let tree = TreeMaker { source: place.source, text: None, texts: TextPlace::Quote };
        match text.parse::<toml_edit::Value>() {
            Ok(value) => tree.value(&value),
            Err(_no_toml) => Self { place, kind: TomlKind::Text(text.to_owned(), false) },
        }
    }

    /// Returns the value of an entry of a table.
    pub fn get(&self, name: &str) -> Option<&TomlEntry> {
        self.entries()?.iter().find(|entry| entry.name == name)
    }
}

/// The place of a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TextPlace {
    Quote,
    /// The character after the quotes, if the text has no escapes.
    FirstCharacter,
}

/// Reads the source with this number; reports every line that is not TOML and reads on without it.
///
/// Returns `None` if the rest could not be understood.
pub fn parse(report: &mut FindingList, source: usize, texts: TextPlace) -> Option<TomlNode> {
    let mut text = report.text(source).to_owned();
    if let Some(line) = text.lines().position(|it| it.matches('.').count() > MOST_DOTS) {
        let offset = text.lines().take(line).map(|it| it.len() + 1).sum();
        report.is_broken = true;
        let help = "break it into several";
        report.say(SourcePlace { source, offset }, "the line is too long", help);
        return None;
    }
    let mut left_out = Vec::new();
    // A large file that is something else is not read twenty times.
    let most = if text.len() > LARGE { 2 } else { MOST_BROKEN_LINES };
    for _ in 0..most {
        let error = match Document::parse(text.as_str()) {
            Ok(document) => {
                let tree = TreeMaker { source, text: Some(&text), texts };
                return Some(tree.table(document.as_table(), Some(0..0)));
            }
            Err(error) => error,
        };
        report.is_broken = true;
        let span = error.span().unwrap_or(text.len()..text.len());
        let line = line_around(&text, span.start);
        if left_out.contains(&line.start) {
            return None;
        }
        say_error(
            report,
            SourcePlace { source, offset: span.start },
            error.message(),
            text.get(span),
        );
        let was_header = text.get(line.clone()).is_some_and(|it| it.trim_start().starts_with('['));
        let (start, len) = (line.start, line.len());
        text.replace_range(line, &" ".repeat(len));
        left_out.push(start);
        // What follows a header would be taken for something that it is not.
        if was_header {
            return None;
        }
    }
    None
}

fn line_around(text: &str, offset: usize) -> Range<usize> {
    let offset = text.floor_char_boundary(offset.min(text.len()));
    let (before, after) = text.split_at(offset);
    let start = before.rfind('\n').map_or(0, |it| it + 1);
    let end = after.find('\n').map_or(text.len(), |it| offset + it);
    start..end
}

fn say_error(report: &mut FindingList, place: SourcePlace, message: &str, written: Option<&str>) {
    let message = message.replace(['\n', '\r'], " ");
    if message.contains("duplicate key") {
        let name = written.unwrap_or("a name").trim_matches(['[', ']', ' ']);
        let message = format!("{} stands here a second time", quoted(name));
        report.say(place, message, "give it another name, or remove one of the two");
    } else {
        report.say(place, format!("this is not TOML, {message}"), "correct the line");
    }
}

struct TreeMaker<'a> {
    source: usize,
    /// The text that spans are of; none if they mean nothing.
    text: Option<&'a str>,
    texts: TextPlace,
}

impl TreeMaker<'_> {
    fn place(&self, span: Option<Range<usize>>) -> SourcePlace {
        let span = span.filter(|_| self.text.is_some());
        SourcePlace { source: self.source, offset: span.map_or(0, |span| span.start) }
    }

    fn item(&self, item: &Item) -> TomlNode {
        match item {
            Item::None => TomlNode { place: self.place(None), kind: TomlKind::Table(Vec::new()) },
            Item::Value(value) => self.value(value),
            Item::Table(table) => self.table(table, table.span()),
            Item::ArrayOfTables(tables) => {
                let nodes = tables.iter().map(|table: &Table| self.table(table, table.span()));
                TomlNode { place: self.place(tables.span()), kind: TomlKind::List(nodes.collect()) }
            }
        }
    }

    fn value(&self, value: &toml_edit::Value) -> TomlNode {
        use toml_edit::Value as Toml;
        let kind = match value {
            Toml::String(text) => return self.string(text.value(), value.span()),
            Toml::Integer(number) => TomlKind::Integer(*number.value()),
            Toml::Float(number) => TomlKind::Float(*number.value()),
            Toml::Boolean(truth) => TomlKind::Truth(*truth.value()),
            Toml::Datetime(_) => TomlKind::Date,
            Toml::Array(list) => TomlKind::List(list.iter().map(|it| self.value(it)).collect()),
            Toml::InlineTable(table) => return self.table(table, table.span()),
        };
        TomlNode { place: self.place(value.span()), kind }
    }

    fn string(&self, text: &str, span: Option<Range<usize>>) -> TomlNode {
        let raw = self.text.zip(span.clone()).and_then(|(all, span)| all.get(span)).unwrap_or("");
        let quotes = if raw.starts_with("\"\"\"") || raw.starts_with("'''") { 3 } else { 1 };
        let inner = raw.get(quotes..).unwrap_or("");
        let newline = if quotes == 3 {
            inner.len() - inner.trim_start_matches(['\r', '\n']).len()
        } else {
            0
        };
        let is_exact = inner.get(newline..).is_some_and(|it| it.starts_with(text));
        let place = self.place(span);
        let place = match self.texts {
            TextPlace::FirstCharacter if is_exact => place.after(quotes + newline),
            TextPlace::FirstCharacter | TextPlace::Quote => place,
        };
        TomlNode { place, kind: TomlKind::Text(text.to_owned(), is_exact) }
    }

    fn table(&self, table: &dyn TableLike, span: Option<Range<usize>>) -> TomlNode {
        let entries = table.iter().map(|(name, item)| {
            let node = self.item(item);
            let place = match table.key(name).and_then(Key::span) {
                Some(span) => self.place(Some(span)),
                None => node.place,
            };
            TomlEntry { name: name.to_owned(), place, node }
        });
        TomlNode { kind: TomlKind::Table(entries.collect()), place: self.place(span) }
    }
}
