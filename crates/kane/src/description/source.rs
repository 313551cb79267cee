//! Texts of a description and its bases, and places in them.

/// A text that a description was read from.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DescriptionSource {
    /// Its name in mistakes, as `my-action.toml`.
    pub name: String,
    pub text: String,
}

/// A place in one of several sources.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub(super) struct SourcePlace {
    pub(super) source: usize,
    /// Byte of its text.
    pub(super) offset: usize,
}

impl SourcePlace {
    pub(super) const fn after(self, bytes: usize) -> Self {
        Self { offset: self.offset + bytes, ..self }
    }
}

/// Finds lines and columns in a text.
#[derive(Debug)]
pub(super) struct LineIndex {
    starts: Vec<usize>,
}

impl LineIndex {
    pub(super) fn new(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Self { starts: std::iter::once(0).chain(ends.map(|(end, _)| end + 1)).collect() }
    }

    /// Returns line and column (characters), from 1.
    pub(super) fn position(&self, text: &str, offset: usize) -> (usize, usize) {
        let line = self.starts.partition_point(|start| *start <= offset).max(1);
        let start = self.starts.get(line - 1).copied().unwrap_or(0);
        let end = text.floor_char_boundary(offset);
        let before = text.get(start..end).unwrap_or("");
        (line, before.chars().count() + 1)
    }
}
