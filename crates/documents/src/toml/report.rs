//! The mistakes that are found while a file is read.

use std::path::{Path, PathBuf};

use crate::{Diagnostic, Diagnostics, escaped, shortened};

/// A text to read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TomlSource {
    /// Name in mistakes, as `my-action.toml`.
    pub name: String,
    pub text: String,
}

/// A position in one of several sources.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct SourcePlace {
    pub source: usize,
    /// Byte offset in its text.
    pub offset: usize,
}

impl SourcePlace {
    #[must_use]
    pub const fn after(self, bytes: usize) -> Self {
        Self { offset: self.offset + bytes, ..self }
    }
}

/// Byte offsets at which the lines of a source start; `None` for text from the command line.
type LineStarts = Option<Vec<usize>>;

/// The mistakes found so far in a file, in the files it starts from, and in overrides.
#[derive(Debug, Default)]
pub struct FindingList {
    sources: Vec<(TomlSource, LineStarts)>,
    /// Folder to which relative paths in the file are relative.
    folder: PathBuf,
    /// `true` if a stretch of the file is unreadable, which may contain what seems missing.
    pub is_broken: bool,
    found: Vec<Diagnostic>,
}

impl FindingList {
    /// Most mistakes that are reported.
    pub const MOST: usize = 100;

    pub fn in_folder(folder: PathBuf) -> Self {
        Self { folder, ..Self::default() }
    }

    /// Adds a source; returns its index.
    pub fn source(&mut self, source: TomlSource) -> usize {
        let ends = source.text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let starts = std::iter::once(0).chain(ends.map(|(end, _)| end + 1)).collect();
        self.sources.push((source, Some(starts)));
        self.sources.len() - 1
    }

    /// Adds an override, `value` as typed in `words`; returns its index.
    pub fn typed(&mut self, words: &str, value: &str) -> usize {
        let name = shortened(words).into_owned();
        self.sources.push((TomlSource { name, text: value.to_owned() }, None));
        self.sources.len() - 1
    }

    /// Returns the text of the source with this index; empty if there is none.
    pub fn text(&self, source: usize) -> &str {
        self.sources.get(source).map_or("", |(source, _)| &source.text)
    }

    /// Returns the typed value of the override at `place`, if `place` is in an override.
    pub fn typed_at(&self, place: SourcePlace) -> Option<&str> {
        let (source, lines) = self.sources.get(place.source)?;
        lines.is_none().then_some(source.text.as_str())
    }

    pub fn folder(&self, place: SourcePlace) -> &Path {
        if self.typed_at(place).is_some() { Path::new("") } else { &self.folder }
    }

    /// Records the mistake `message` at `place` with the remedy `help`.
    pub fn say(&mut self, place: SourcePlace, message: impl Into<String>, help: impl Into<String>) {
        if self.found.len() >= Self::MOST {
            return;
        }
        let position = self.position(place);
        let file = self.sources.get(place.source).map(|(source, _)| source.name.clone());
        self.found.push(Diagnostic {
            file: file.unwrap_or_default(),
            line: position.map(|(line, _)| line),
            column: position.map(|(_, column)| column),
            message: message.into(),
            help: help.into(),
        });
    }

    /// Records a mistake instead of all others, which may follow from it.
    pub fn replace(&mut self, place: SourcePlace, message: String, help: &str) {
        self.found.clear();
        self.say(place, message, help);
    }

    /// Records a missing entry, unless the file is unreadable in part.
    pub fn miss(
        &mut self,
        place: SourcePlace,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        if !self.is_broken {
            self.say(place, message, help);
        }
    }

    pub fn absorb(&mut self, others: Diagnostics) {
        self.found.extend(others.into_vec());
    }

    /// Returns line and column (characters), from 1; `None` in an override.
    pub fn position(&self, place: SourcePlace) -> Option<(usize, usize)> {
        let (source, starts) = self.sources.get(place.source)?;
        let starts = starts.as_ref()?;
        let line = starts.partition_point(|start| *start <= place.offset).max(1);
        let start = starts.get(line - 1).copied().unwrap_or(0);
        let end = source.text.floor_char_boundary(place.offset);
        let before = source.text.get(start..end).unwrap_or("");
        Some((line, before.chars().count() + 1))
    }

    pub fn file_position(&self, place: SourcePlace) -> Option<(String, usize, usize)> {
        let (line, column) = self.position(place)?;
        let (source, _) = self.sources.get(place.source)?;
        Some((source.name.clone(), line, column))
    }

    /// Returns "line 3, column 1", "other.toml:3:1" or the override, for a message at `from`.
    pub fn describe(&self, place: SourcePlace, from: SourcePlace) -> String {
        let name = self.sources.get(place.source).map_or("", |(source, _)| &source.name);
        match self.position(place) {
            None => name.to_owned(),
            Some((line, column)) if place.source == from.source => {
                format!("line {line}, column {column}")
            }
            Some((line, column)) => format!("{}:{line}:{column}", escaped(name)),
        }
    }

    /// Returns "line 3", or the override.
    pub fn line(&self, place: SourcePlace) -> String {
        let name = || self.sources.get(place.source).map(|(source, _)| source.name.clone());
        let line = self.position(place).map(|(line, _)| format!("line {line}"));
        line.or_else(name).unwrap_or_default()
    }

    pub const fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    pub const fn len(&self) -> usize {
        self.found.len()
    }

    /// Returns all sources with their texts.
    pub fn texts(&self) -> Vec<TomlSource> {
        self.sources.iter().map(|(source, _)| source.clone()).collect()
    }

    /// Returns `checked`, or all mistakes if there are any or `checked` is `None`.
    pub fn verdict<T>(self, checked: Option<T>) -> Result<T, Diagnostics> {
        match checked {
            Some(checked) if self.found.is_empty() => Ok(checked),
            _ => Err(Diagnostics::new(self.found)),
        }
    }
}
