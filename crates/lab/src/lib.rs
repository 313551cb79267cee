//! All that is offline: one key in simulation, and studies with reports.
//!
//! ```text
//! simulate/   one model under one input: trajectory, events, picture, summary
//! scenario/   problems with known answers: models, inputs, references
//! accuracy/   runs each with every method and step, judges it, times it
//! report/     the page of every study with its tables and pictures; the accuracy of all methods
//! piano/      an instrument beside measured grands
//! fit/        an instrument from a measured action
//! figure6/    the paper's experiment at the paper's rates, and how wrong its step was
//! stability/  where a wall or an instrument is stable on a key
//! parallel.rs work on all processors
//! digits.rs   numbers as people write them
//! random.rs   numbers that a seed repeats
//! studied_method.rs   any method by its name
//! plot/       pictures as SVG, for simulate, piano, fit, stability and report
//! ```
//!
//! `scenario` does not know `accuracy`, `accuracy` does not know `report`, and none of them knows
//! `simulate`.
//!
//! A study is run by hand on an idle machine; its counts are the same everywhere, its
//! nanoseconds belong to the machine that the report names.
//!
//! Not here: the command line, the methods themselves, anything of real time.
#![forbid(unsafe_code)]

pub mod accuracy;
pub mod digits;
pub mod figure6;
pub mod fit;
pub mod impedance;
pub mod parallel;
pub mod piano;
pub mod plot;
pub mod random;
pub mod report;
pub mod scenario;
pub mod simulate;
pub mod stability;
mod studied_method;
