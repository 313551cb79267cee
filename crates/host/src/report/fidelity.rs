//! The fidelities that a run has chosen.

use std::fmt;

use serde::Serialize;

/// The fidelity that a range of keys has got, for people and as JSON.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ChosenFidelity {
    pub keys: String,
    pub fidelity: &'static str,
    /// The instrument that renders it.
    pub instrument: String,
    /// The share of each lane's time that the range takes when all its keys move.
    pub share: f64,
    /// The levels above it.
    pub refused: Vec<RefusedFidelity>,
}

/// A fidelity that the budget does not allow.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct RefusedFidelity {
    pub fidelity: &'static str,
    /// The share of each lane's time that it would take.
    pub share: f64,
}

impl fmt::Display for ChosenFidelity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { keys, fidelity, instrument, share, refused } = self;
        write!(f, "{keys} play {instrument}, fidelity {fidelity}: ")?;
        write!(f, "{:.1} % of each lane when all these keys move", 100.0 * share)?;
        refused
            .iter()
            .try_for_each(|it| write!(f, "; {} would take {:.1} %", it.fidelity, 100.0 * it.share))
    }
}
