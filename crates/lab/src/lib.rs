//! Studies with a report: the program `letoff-lab`, which `letoff lab` starts.
//!
//! ```text
//! command/    the command line: a file for each study, and the list of them
//! scenario/   problems with known answers: models, inputs, references
//! accuracy/   runs each with every method and step, judges it, times it
//! hard/       cases on which other tools fail, with every method
//! report/     page, tables and pictures of every study; the accuracy of all methods
//! piano/      an instrument beside measured grands
//! fit/        an instrument from a measured action
//! figure6/    the paper's experiment at the paper's rates, and the errors of its step
//! stability/  where a wall or an instrument is stable on a key
//! impedance/  the mechanical impedance at a key's front
//! part.rs     a share of a study, for several machines
//! random.rs   random numbers from a seed
//! ```
//!
//! `scenario` does not know `accuracy`, and `accuracy` does not know `report`.
//!
//! Run a study on an idle machine: its counts are equal everywhere, its nanoseconds are not.
#![forbid(unsafe_code)]

pub mod accuracy;
pub mod command;
pub mod figure6;
pub mod fit;
pub mod hard;
pub mod impedance;
pub mod part;
pub mod piano;
pub mod random;
pub mod report;
pub mod scenario;
pub mod stability;
