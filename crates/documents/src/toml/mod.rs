//! TOML files with positions: all mistakes of a file at once, each with its line.
//!
//! [`parse`] builds a plain tree from a source of a [`FindingList`]; [`KeyReader`] reads a table.

mod reader;
mod report;
mod tree;

pub use reader::{KeyReader, list, text, wrong_kind};
pub use report::{FindingList, SourcePlace, TomlSource};
pub use tree::{TextPlace, TomlEntry, TomlKind, TomlNode, parse};
