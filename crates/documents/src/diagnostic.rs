//! What is wrong with a file, for people and for programs.

use std::fmt;

use serde::Serialize;

use crate::escaped;

/// One mistake, where it stands and what to do about it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize)]
pub struct Diagnostic {
    /// The file, or the override (`--set name=value`) in which the mistake was made.
    pub file: String,
    /// Line, from 1; none for an override or a file that cannot be read.
    pub line: Option<usize>,
    /// Column in characters, from 1.
    pub column: Option<usize>,
    pub message: String,
    pub help: String,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&escaped(&self.file))?;
        if let (Some(line), Some(column)) = (self.line, self.column) {
            write!(f, ":{line}:{column}")?;
        }
        write!(f, ": {}; {}", self.message, self.help)
    }
}

/// All that is wrong: at least one mistake, overrides first, then by file, line and column.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
#[serde(transparent)]
pub struct Diagnostics(Vec<Diagnostic>);

impl Diagnostics {
    /// Sorts what was found and drops what was found twice.
    pub fn new(mut found: Vec<Diagnostic>) -> Self {
        let rank = |mistake: &Diagnostic| (mistake.line.is_some(), mistake.clone());
        found.sort_by_cached_key(rank);
        found.dedup();
        Self(found)
    }

    /// The mistakes, in order.
    pub fn as_slice(&self) -> &[Diagnostic] {
        &self.0
    }

    /// Returns the mistakes, in order.
    pub fn into_vec(self) -> Vec<Diagnostic> {
        self.0
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, diagnostic) in self.0.iter().enumerate() {
            let separator = if index == 0 { "" } else { "\n" };
            write!(f, "{separator}{diagnostic}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostics {}
