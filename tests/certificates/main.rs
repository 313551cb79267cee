//! `cargo xtask certificates`: searches random systems for a certain step that hides a crossing.
//!
//! A step is certain if no root of a guard can have been missed on the computed orbit. Random
//! oscillators with random guards and inputs are advanced by every method, far beyond the limits of
//! some: stiff for the step, inputs faster than the tick, guards faster than the declared rate.
//! Each computed orbit is sampled in `LOOKS` places a piece, and more densely near the minimum of a
//! guard. A guard that is negative in a certain step, without an event before, is a violation.
//!
//! ```text
//! input    inputs over one tick, with right bounds or none
//! guard    guards of state and input, with their bounds
//! system   oscillators with guards, as a model
//! orbit    follows what is computed, and samples the guards
//! trial    one system from its start to its end
//! ```
#![forbid(unsafe_code)]

mod guard;
mod input;
mod orbit;
mod system;
#[cfg(test)]
mod tests;
mod trial;

use std::fmt;
use std::process::ExitCode;

use clap::Parser;
use orbit::LOOKS;
use trial::Trial;

const MAX_DESCRIBED: usize = 10;

/// Looks for a certain step that hides a crossing, in random systems.
#[derive(Clone, Copy, PartialEq, Debug, Parser)]
#[command(
    name = "cargo xtask certificates",
    after_help = "Examples:
  cargo xtask certificates --seed 7 --systems 20000
  cargo xtask certificates --seed 7 --first 1234 --systems 1

Exit codes: 0 no violation; 1 a step was called certain and was not; 2 wrong usage."
)]
struct CertificateChoice {
    /// Seed of all random numbers.
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Number of the first system.
    #[arg(long, value_name = "N", default_value_t = 0)]
    first: u64,
    /// Number of systems.
    #[arg(long, value_name = "N", default_value_t = 2000)]
    systems: u64,
    /// Factor on every bound that the models state: 1 is right, less is too low.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    bound_factor: f64,
}

/// A guard that was negative in a step that was called certain.
#[derive(Clone, PartialEq, Debug)]
struct CertificateViolation {
    /// The system's number: the seed and this number make the system again.
    system: u64,
    method: &'static str,
    tick: u64,
    /// Fraction of the tick at which the guard is negative, 0 ..= 1.
    theta: f64,
    /// The guard's value there, relative to its size.
    value: f64,
    system_text: String,
}

#[derive(Clone, PartialEq, Debug, Default)]
struct CertificateReport {
    steps: u64,
    certain: u64,
    unknown: u64,
    events: u64,
    /// Steps in which a guard was negative before an event ended them: missed, or negative since a
    /// located crossing.
    negative: u64,
    violations: u64,
    described: Vec<CertificateViolation>,
}

impl fmt::Display for CertificateReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { steps, certain, unknown, events, negative, violations, described } = self;
        writeln!(f, "{steps} steps, {events} events")?;
        writeln!(
            f,
            "certain     {certain} steps: no crossing of the computed orbit is missed there"
        )?;
        writeln!(
            f,
            "unknown     {unknown} steps; a guard was negative in {negative} of all steps"
        )?;
        writeln!(
            f,
            "violations  {violations} steps were called certain with a guard below zero in one of \
             {LOOKS} places"
        )?;
        described.iter().try_for_each(|violation| writeln!(f, "{violation:?}"))
    }
}

#[expect(clippy::print_stdout, reason = "a command for people")]
fn main() -> ExitCode {
    let report = try_certificates(&CertificateChoice::parse());
    print!("{report}");
    ExitCode::from(u8::from(0 < report.violations))
}

fn try_certificates(choice: &CertificateChoice) -> CertificateReport {
    let mut report = CertificateReport::default();
    for system in choice.first..choice.first.saturating_add(choice.systems) {
        Trial::new(choice, system).run(&mut report);
    }
    report.described.truncate(MAX_DESCRIBED);
    report
}
