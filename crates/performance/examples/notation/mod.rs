//! A small notation for scores, and its encoding as MIDI.
//!
//! Explained for people in `configs/performances/README.md`.

mod curve;
mod line;
mod piece;
mod smf;
mod token;

use std::fmt;

use piece::Piece;

/// What is wrong in a score, and where.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct NotationError {
    line: usize,
    problem: String,
}

impl fmt::Display for NotationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.line, self.problem)
    }
}

/// Encodes a score as a Standard MIDI File.
pub(crate) fn encode(text: &str) -> Result<Vec<u8>, NotationError> {
    let mut piece = Piece::default();
    let mut n_lines = 0;
    for (line, content) in (1..).zip(text.lines()) {
        let content = content.split(" --").next().unwrap_or_default().trim();
        if !content.is_empty() && !content.starts_with("--") {
            line::read(&mut piece, content).map_err(|problem| NotationError { line, problem })?;
        }
        n_lines = line;
    }
    let at_end = |problem| NotationError { line: n_lines, problem };
    piece.finish_bar().map_err(at_end)?;
    smf::encode(&piece).map_err(|error| at_end(error.to_string()))
}
