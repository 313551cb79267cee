//! What can be wrong with an input, in sentences.

use std::path::PathBuf;

use documents::shown;

/// One mistake in an input.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum InputMistake {
    /// Another input than s.
    #[error("--input {name}=…: the model's input is called `s`")]
    Name { name: String },
    /// The expression cannot be read.
    #[error("--input, column {column}: {problem}")]
    Spelling {
        /// Character of the argument, from 1.
        column: usize,
        problem: String,
    },
    #[error("--input: the expression and its three derivatives are too long; give a CSV file")]
    TooLong,
    /// The expression is infinite or undefined where it starts.
    #[error("--input: s or one of its first three derivatives is not finite at t = 0")]
    NotFinite,
    /// The file cannot be read.
    #[error("cannot read {}: {cause}", shown(path))]
    Read { path: PathBuf, cause: csv::Error },
    /// Something in the file is wrong.
    #[error("{}, line {line}, column {column}: {problem}", shown(path))]
    Cell {
        path: PathBuf,
        /// Line of the file, from 1.
        line: u64,
        /// Column of the table, from 1.
        column: usize,
        problem: String,
    },
    /// The number of further mistakes in the same file.
    #[error("{}: {more} more mistakes", shown(path))]
    More {
        path: PathBuf,
        /// Mistakes that are not shown.
        more: usize,
    },
    /// A reconstruction without samples.
    #[error("--reconstruct is for an --input from a CSV file")]
    NothingToReconstruct,
    #[error("{} has {rows} rows: an input needs at least 2", shown(path))]
    TooShort { path: PathBuf, rows: usize },
}
