//! Errors of `letoff simulate`, in sentences for users.

use std::fmt::Write as _;
use std::io;
use std::path::PathBuf;

use super::input::InputMistake;
use documents::{nearest, shown};
use mechanism::MissingModel;

/// Error of a simulation.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SimulateError {
    /// Wrong usage or invalid file, with every mistake; nothing was run.
    #[error("{}", lines(.0))]
    Usage(Vec<SimulateMistake>),
    /// The model failed; the files contain everything before.
    #[error("{model} failed after t = {t:?} s in mode {mode}: {why}")]
    Fault {
        model: &'static str,
        /// Last instant with a finite state (s).
        t: f64,
        mode: String,
        why: &'static str,
    },
    /// Ticks reached a declared maximum and held their state; the files are complete.
    #[error(
        "{model} reached a maximum in {capped} of {ticks} ticks ({kinds}) and held its state for \
         the rest of each, so what comes after the first of them is not the model's motion: take \
         a shorter --step{}", if *tolerance { " or a larger --tolerance" } else { "" }
    )]
    Capped {
        model: &'static str,
        capped: u64,
        ticks: u64,
        /// Reached maxima with their counts.
        kinds: String,
        tolerance: bool,
    },
    #[error("cannot write {}: {cause}; make room there or choose another file", shown(path))]
    Write { path: PathBuf, cause: csv::Error },
    /// The summary could not be written; the files are complete.
    #[error("cannot write the summary: {0}")]
    Summary(io::Error),
}

impl SimulateError {
    /// Returns the exit code: 1 for a failure during the run, 2 for wrong usage or files.
    pub const fn exit_code(&self) -> u8 {
        match self {
            Self::Fault { .. } | Self::Capped { .. } | Self::Write { .. } | Self::Summary(_) => 1,
            Self::Usage(_) => 2,
        }
    }
}

/// A mistake in the arguments or in the input file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SimulateMistake {
    #[error("{}", .0.rendered())]
    Model(MissingModel),
    #[error("{model} needs {condition}, which does not hold: choose other parameters")]
    Unmet {
        model: &'static str,
        /// Condition as in the description.
        condition: String,
    },
    #[error("there is no {what} `{name}`{}; there are {}", suggestion(name, known), known.join(", "))]
    Unknown {
        /// Kind of the name: `mode`, `parameter`, …
        what: &'static str,
        name: String,
        known: Vec<&'static str>,
    },
    #[error("`{option} {text}` must be NAME=VALUE")]
    NotNameValue { option: &'static str, text: String },
    #[error("`{option} {name}={text}`: `{text}` is not a finite number")]
    NotANumber {
        option: &'static str,
        name: String,
        /// Text after the `=`.
        text: String,
    },
    #[error("`{option} {name}` is given twice")]
    Twice { option: &'static str, name: String },
    #[error(
        "{what} = {} is out of range: {} to {}{}",
        short(*value), short(*low), short(*high), after_number(unit)
    )]
    OutOfRange {
        what: String,
        value: f64,
        low: f64,
        high: f64,
        /// Unit of all three; `1` for a ratio.
        unit: &'static str,
    },
    /// A tolerance for a method without error control.
    #[error("--tolerance is not for {method}, which has no say in its steps; it is for {}", known.join(", "))]
    NoTolerance {
        method: String,
        /// Methods with error control.
        known: Vec<&'static str>,
    },
    /// A time that is not positive and finite.
    #[error("{option} = {value:?}: it must be a positive, finite number of seconds")]
    NotADuration { option: &'static str, value: f64 },
    /// More ticks than can be computed in a day.
    #[error("--until / --step are {ticks:e} ticks, more than {most:e}: take a longer --step")]
    TooManyTicks { ticks: f64, most: f64 },
    #[error("the model is not at rest anywhere at t = 0: give --initial for every state")]
    NoStart,
    #[error(transparent)]
    Input(#[from] InputMistake),
    #[error("{first} and {second} are the same file, {}", shown(path))]
    SameFile { first: &'static str, second: &'static str, path: PathBuf },
    #[error("cannot create {}: {cause}", shown(path))]
    Create { path: PathBuf, cause: io::Error },
}

impl SimulateMistake {
    pub(super) fn unknown(what: &'static str, name: &str, known: &[&'static str]) -> Self {
        Self::Unknown { what, name: name.to_owned(), known: known.to_vec() }
    }
}

fn lines(mistakes: &[SimulateMistake]) -> String {
    let mut text = String::new();
    for (index, mistake) in mistakes.iter().enumerate() {
        let separator = if index == 0 { "" } else { "\n" };
        let _written = write!(text, "{separator}{mistake}");
    }
    text
}

fn suggestion(name: &str, known: &[&'static str]) -> String {
    nearest(name, known).map_or_else(String::new, |near| format!(" (did you mean `{near}`?)"))
}

/// Formats a number as people write it: 88, not 88.0.
fn short(number: f64) -> String {
    let text = format!("{number:?}");
    text.strip_suffix(".0").map_or_else(|| text.clone(), str::to_owned)
}

fn after_number(unit: &str) -> String {
    if unit == "1" { String::new() } else { format!(" {unit}") }
}
