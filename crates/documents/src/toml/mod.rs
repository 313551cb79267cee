//! TOML files read with places: all mistakes of a file at once, each with its line.
//!
//! [`parse`] makes a plain tree of a source of a [`FindingList`], [`KeyReader`] reads the entries of
//! a table and reports the others.

mod reader;
mod report;
mod tree;

pub use reader::{KeyReader, list, text, wrong_kind};
pub use report::{FindingList, SourcePlace, TomlSource};
pub use tree::{TextPlace, TomlEntry, TomlKind, TomlNode, parse};
