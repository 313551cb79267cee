//! TOML as a plain tree with the position of each value.

use std::ops::Range;

use toml_edit::{Document, Item, Key, Table, TableLike};

use super::report::{FindingList, SourcePlace};
use crate::quoted;

/// Invalid lines that are blanked one after the other, to find more mistakes after them.
const MOST_BROKEN_LINES: usize = 20;

/// Size above which no person wrote the file (bytes).
const LARGE: usize = 1 << 17;

/// Most dots on a line: a key with thousands of parts would give a tree as deep.
const MOST_DOTS: usize = 2_000;

/// A value and its position.
#[derive(Clone, PartialEq, Debug)]
pub struct TomlNode {
    /// Position of the first character; for a text see [`TextPlace`].
    pub place: SourcePlace,
    pub kind: TomlKind,
}

/// A value of TOML.
#[derive(Clone, PartialEq, Debug)]
pub enum TomlKind {
    /// Text, and `true` if the file contains it unchanged, without escapes.
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

    pub fn entries(&self) -> Option<&[TomlEntry]> {
        if let TomlKind::Table(entries) = &self.kind { Some(entries) } else { None }
    }

    pub fn items(&self) -> Option<&[Self]> {
        if let TomlKind::List(items) = &self.kind { Some(items) } else { None }
    }

    pub fn text(&self) -> Option<&str> {
        if let TomlKind::Text(text, _) = &self.kind { Some(text) } else { None }
    }

    pub fn item_mut(&mut self, index: usize) -> Option<&mut Self> {
        if let TomlKind::List(items) = &mut self.kind { items.get_mut(index) } else { None }
    }

    /// Returns the value of an override at `place`: TOML, or text without quotes.
    pub fn typed(text: &str, place: SourcePlace) -> Self {
        let tree = TreeMaker { source: place.source, text: None, texts: TextPlace::Quote };
        match text.parse::<toml_edit::Value>() {
            Ok(value) => tree.value(&value),
            Err(_no_toml) => Self { place, kind: TomlKind::Text(text.to_owned(), false) },
        }
    }

    pub fn get(&self, name: &str) -> Option<&TomlEntry> {
        self.entries()?.iter().find(|entry| entry.name == name)
    }
}

/// Position that a text is given.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TextPlace {
    Quote,
    /// First character after the quotes, if the text has no escapes.
    FirstCharacter,
}

/// Parses the source with this index; reports every line that is not TOML and continues without it.
///
/// Returns `None` if the rest is invalid, too.
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
    // Read a large file that is not TOML only twice.
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
        // The entries after a broken header would be attributed to another table.
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
    /// Text that the spans refer to; `None` if the spans have no meaning.
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
