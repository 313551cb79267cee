//! The mistakes that are found while a description is read.

use diagnostics::{Diagnostic, Diagnostics, escaped};

use super::source::{DescriptionSource, LineIndex, SourcePlace};

/// The mistakes found so far in a description and its bases.
#[derive(Debug, Default)]
pub(super) struct FindingList {
    sources: Vec<(DescriptionSource, LineIndex)>,
    /// ExpressionPart of a file could not be read, so what seems missing may stand there.
    pub(super) is_broken: bool,
    found: Vec<Diagnostic>,
}

impl FindingList {
    /// Most mistakes that are reported.
    pub(super) const MOST: usize = 100;

    /// Adds a source; returns its number.
    pub(super) fn source(&mut self, source: DescriptionSource) -> usize {
        let lines = LineIndex::new(&source.text);
        self.sources.push((source, lines));
        self.sources.len() - 1
    }

    pub(super) fn text(&self, source: usize) -> &str {
        self.sources.get(source).map_or("", |(source, _)| &source.text)
    }

    /// Records the mistake `message` at `place` with the remedy `help`.
    pub(super) fn say(
        &mut self,
        place: SourcePlace,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
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

    /// Records a mistake in the place of all others, which may follow from it.
    pub(super) fn replace(&mut self, place: SourcePlace, message: String, help: &str) {
        self.found.clear();
        self.say(place, message, help);
    }

    /// Records what is missing, unless part of the file is unreadable.
    pub(super) fn miss(
        &mut self,
        place: SourcePlace,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        if !self.is_broken {
            self.say(place, message, help);
        }
    }

    /// Returns line and column, from 1.
    pub(super) fn position(&self, place: SourcePlace) -> Option<(usize, usize)> {
        let (source, lines) = self.sources.get(place.source)?;
        Some(lines.position(&source.text, place.offset))
    }

    /// Returns the file with line and column, from 1.
    pub(super) fn file_position(&self, place: SourcePlace) -> Option<(String, usize, usize)> {
        let (line, column) = self.position(place)?;
        let (source, _) = self.sources.get(place.source)?;
        Some((source.name.clone(), line, column))
    }

    /// Returns "line 3", or "other.toml:3", for a message that points at a second place.
    pub(super) fn describe(&self, place: SourcePlace, from: SourcePlace) -> String {
        let (line, column) = self.position(place).unwrap_or((1, 1));
        match self.sources.get(place.source) {
            Some((source, _)) if place.source != from.source => {
                format!("{}:{line}:{column}", escaped(&source.name))
            }
            _ => format!("line {line}, column {column}"),
        }
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    pub(super) const fn len(&self) -> usize {
        self.found.len()
    }

    /// Returns the texts, or all mistakes.
    pub(super) fn verdict(self) -> Result<Vec<DescriptionSource>, Diagnostics> {
        if self.found.is_empty() {
            Ok(self.sources.into_iter().map(|(source, _)| source).collect())
        } else {
            Err(Diagnostics::new(self.found))
        }
    }
}
