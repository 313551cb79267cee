use std::fmt;

use serde::Serialize;

/// The fidelity chosen for a range of keys, for people and as JSON.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ChosenFidelity {
    pub keys: String,
    pub fidelity: &'static str,
    pub instrument: String,
    /// Share of each lane's time when all keys of the range move.
    pub share: f64,
    pub refused: Vec<RefusedFidelity>,
}

/// A fidelity above the budget.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct RefusedFidelity {
    pub fidelity: &'static str,
    /// Share of each lane's time that it would need.
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
