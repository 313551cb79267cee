use std::path::PathBuf;

use documents::shown;

/// A mistake in an input.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum InputMistake {
    #[error("--input {name}=…: the model's input is called `s`")]
    Name { name: String },
    #[error("--input, column {column}: {problem}")]
    Spelling {
        /// Character of the argument, from 1.
        column: usize,
        problem: String,
    },
    #[error("--input: the expression and its three derivatives are too long; give a CSV file")]
    TooLong,
    /// The expression is infinite or undefined at its start.
    #[error("--input: s or one of its first three derivatives is not finite at t = 0")]
    NotFinite,
    #[error("cannot read {}: {cause}", shown(path))]
    Read { path: PathBuf, cause: csv::Error },
    #[error("{}, line {line}, column {column}: {problem}", shown(path))]
    Cell {
        path: PathBuf,
        /// Line of the file, from 1.
        line: u64,
        /// Column of the table, from 1.
        column: usize,
        problem: String,
    },
    /// Number of further mistakes in the same file.
    #[error("{}: {more} more mistakes", shown(path))]
    More {
        path: PathBuf,
        /// Mistakes that are not shown.
        more: usize,
    },
    #[error("--reconstruct is for an --input from a CSV file")]
    NothingToReconstruct,
    #[error("{} has {rows} rows: an input needs at least 2", shown(path))]
    TooShort { path: PathBuf, rows: usize },
}
