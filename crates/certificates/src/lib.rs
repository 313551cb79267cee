//! Whether a step that is called certain hides a crossing: random systems, looked at closely.
//!
//! A step is certain if no root of a guard can have been missed on the orbit as it was computed.
//! Here random oscillators with random guards and inputs are advanced by every method, far past
//! the limits of some: stiff for the step, inputs faster than the tick, guards faster than the
//! rate that the model declares. Each computed orbit is looked at in [`LOOKS`] places a piece and
//! more where a guard is lowest, and a guard that is negative in a certain step, without an event
//! before, is a violation.
//!
//! ```text
//! random   numbers by a seed
//! input    inputs over one tick, with right bounds or none
//! guard    guards of state and input, with their bounds
//! system   oscillators with guards, as a model
//! orbit    follows what is computed, and looks at the guards
//! trial    one system from its start to its end
//! ```
#![forbid(unsafe_code)]

mod guard;
mod input;
mod orbit;
mod random;
mod system;
#[cfg(test)]
mod tests;
mod trial;

use serde::Serialize;

pub use orbit::LOOKS;
pub use random::SeededRandom;
use trial::Trial;

/// Violations that are described in a report; all are counted.
const MOST_DESCRIBED: usize = 10;

/// Which random systems are tried, and with which bounds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CertificateChoice {
    /// The seed of all random numbers.
    pub seed: u64,
    /// The first system that is tried.
    pub first: u64,
    /// How many systems are tried.
    pub systems: u64,
    /// Factor on every bound that the models state: 1 is right, less is too low.
    pub bound_factor: f64,
}

impl Default for CertificateChoice {
    fn default() -> Self {
        Self { seed: 1, first: 0, systems: 2000, bound_factor: 1.0 }
    }
}

/// A guard that was negative in a step that was called certain.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct CertificateViolation {
    /// The system's number: the seed and this make it again.
    pub system: u64,
    pub method: &'static str,
    pub tick: u64,
    /// Where in the tick the guard is negative, 0 ..= 1.
    pub theta: f64,
    /// The guard's value there, in parts of its size.
    pub value: f64,
    /// The guard, the oscillators and the input in short.
    pub system_text: String,
}

/// What all trials gave.
#[derive(Clone, PartialEq, Debug, Default, Serialize)]
pub struct CertificateReport {
    pub seed: u64,
    pub systems: u64,
    /// Steps that were kept, whole or up to an event.
    pub steps: u64,
    /// Steps that were called certain.
    pub certain: u64,
    pub unknown: u64,
    pub events: u64,
    /// Steps in which a guard was seen to be negative before an event ended them: missed, or
    /// negative since a crossing that was found.
    pub negative: u64,
    /// Those among them that were called certain.
    pub violations: u64,
    /// The first of these.
    pub described: Vec<CertificateViolation>,
}

/// Tries the systems of `choice`, and tells `after` of each that is done.
pub fn try_certificates(choice: &CertificateChoice, after: &mut dyn FnMut()) -> CertificateReport {
    let mut report = CertificateReport { seed: choice.seed, ..CertificateReport::default() };
    for system in choice.first..choice.first.saturating_add(choice.systems) {
        Trial::new(choice, system).run(&mut report);
        report.systems += 1;
        after();
    }
    report.described.truncate(MOST_DESCRIBED);
    report
}
