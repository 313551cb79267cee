//! Offline studies with reports.
//!
//! ```text
//! scenario/   problems with known answers: models, inputs, references
//! accuracy/   runs each with every method and step, judges it, times it
//! report/     what was measured, as CSV, SVG and one HTML page
//! ```
//!
//! A study is run by hand on an idle machine; its counts are the same everywhere, its
//! nanoseconds belong to the machine that the report names.
//!
//! Not here: the command line, the methods themselves, anything of real time.
#![forbid(unsafe_code)]

pub mod accuracy;
pub mod report;
pub mod scenario;
pub mod simulate;
