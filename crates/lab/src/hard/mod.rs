//! Hard cases: most are public bug reports of other tools, rebuilt as descriptions.
//!
//! `cases/cases.json` lists them with sources, settings and references, which `references.py`
//! computes. In the order of a run: `case`, `run` (one method at one step), `rows`, `picture`,
//! `sheet`.

mod case;
mod picture;
mod rows;
mod run;
mod sheet;
#[cfg(test)]
mod tests;

pub use case::{ExpectedRun, HARD_CASES, HardCase};
pub use rows::{HardChoice, HardRow, measure};
pub use run::{HardRun, HardVerdict};
pub use sheet::write_hard;
