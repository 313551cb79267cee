//! The mistakes that are found while a file is read.

use std::path::Path;

use super::source::{Override, SourceText};
use descriptions::Library;
use diagnostics::{Diagnostic, Diagnostics, shortened};

/// Most mistakes that are reported of one file.
const MOST: usize = 100;

/// The place of a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Location {
    /// At a byte of the file.
    At(usize),
    /// In the override with this index.
    Override(usize),
}

/// The mistakes found so far in one file and its overrides.
#[derive(Debug)]
pub(super) struct MistakeList<'a> {
    source: &'a SourceText,
    overrides: &'a [Override],
    /// Reads the descriptions that the file names.
    library: Library,
    /// Byte at which each line starts.
    lines: Vec<usize>,
    /// Part of the file could not be read, so what seems missing may stand there.
    pub(super) broken: bool,
    found: Vec<Diagnostic>,
}

impl<'a> MistakeList<'a> {
    /// Returns an empty list for `source` and its overrides.
    pub(super) fn new(
        source: &'a SourceText,
        overrides: &'a [Override],
        library: &Library,
    ) -> Self {
        let ends = source.text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let lines = std::iter::once(0).chain(ends.map(|(end, _)| end + 1)).collect();
        let library = library.clone();
        Self { source, overrides, library, lines, broken: false, found: Vec::new() }
    }

    /// Returns the file that is read.
    pub(super) const fn source(&self) -> &'a SourceText {
        self.source
    }

    /// Returns the reader of the descriptions that the file names.
    pub(super) const fn library(&self) -> &Library {
        &self.library
    }

    /// Returns what a relative path written at `place` is relative to.
    pub(super) fn folder(&self, place: Location) -> &'a Path {
        match place {
            Location::At(_) => &self.source.folder,
            Location::Override(_) => Path::new(""),
        }
    }

    /// Returns the value of the override at `place`, as it was written, if there is one.
    pub(super) fn overriding(&self, place: Location) -> Option<&'a str> {
        match place {
            Location::At(_) => None,
            Location::Override(index) => self.overrides.get(index).map(|it| it.value.as_str()),
        }
    }

    /// Records the mistake `message` at `place` with the remedy `help`.
    pub(super) fn say(
        &mut self,
        place: Location,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        if self.found.len() >= MOST {
            return;
        }
        let (file, position) = self.locate(place);
        self.found.push(Diagnostic {
            file,
            line: position.map(|(line, _)| line),
            column: position.map(|(_, column)| column),
            message: message.into(),
            help: help.into(),
        });
    }

    /// Records a missing value as [`MistakeList::say`] does, unless part of the file is unreadable.
    pub(super) fn miss(
        &mut self,
        place: Location,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        if !self.broken {
            self.say(place, message, help);
        }
    }

    /// Adds what is wrong with another file.
    pub(super) fn absorb(&mut self, others: Diagnostics) {
        self.found.extend(others.into_vec());
    }

    /// Returns `checked`, or all mistakes.
    pub(super) fn verdict<T>(self, checked: Option<T>) -> Result<T, Diagnostics> {
        match checked {
            Some(checked) if self.found.is_empty() => Ok(checked),
            _ => Err(Diagnostics::new(self.found)),
        }
    }

    /// Returns "line 3", or the override, for a message that points at a second place.
    pub(super) fn describe(&self, place: Location) -> String {
        match self.locate(place) {
            (_, Some((line, _))) => format!("line {line}"),
            (file, None) => file,
        }
    }

    fn locate(&self, place: Location) -> (String, Option<(usize, usize)>) {
        match place {
            Location::At(offset) => (self.source.file.clone(), Some(self.position(offset))),
            Location::Override(index) => {
                let typed = self.overrides.get(index).map(|it| &it.typed);
                (shortened(typed.unwrap_or(&self.source.file)).into_owned(), None)
            }
        }
    }

    /// Returns line and column, from 1.
    fn position(&self, offset: usize) -> (usize, usize) {
        let line = self.lines.partition_point(|start| *start <= offset).max(1);
        let start = self.lines.get(line - 1).copied().unwrap_or(0);
        let end = self.source.text.floor_char_boundary(offset);
        let before = self.source.text.get(start..end).unwrap_or("");
        (line, before.chars().count() + 1)
    }
}
