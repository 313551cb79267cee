//! Studies with a report: the program `letoff-lab`, which `letoff lab` starts.
//!
//! ```text
//! command/    what people type: a file for each study, and the list of them
//! scenario/   problems with known answers: models, inputs, references
//! accuracy/   runs each with every method and step, judges it, times it
//! report/     the page of every study with its tables and pictures; the accuracy of all methods
//! piano/      an instrument beside measured grands
//! fit/        an instrument from a measured action
//! figure6/    the paper's experiment at the paper's rates, and how wrong its step was
//! stability/  where a wall or an instrument is stable on a key
//! impedance/  the mechanical impedance at a key's front
//! random.rs   numbers that a seed repeats
//! ```
//!
//! `scenario` does not know `accuracy`, and `accuracy` does not know `report`.
//!
//! A study is run by hand on an idle machine; its counts are the same everywhere, its
//! nanoseconds belong to the machine that the report names.
//!
//! Not here: the methods themselves, figures of one key, anything of real time.
#![forbid(unsafe_code)]

pub mod accuracy;
pub mod command;
pub mod figure6;
pub mod fit;
pub mod impedance;
pub mod piano;
pub mod random;
pub mod report;
pub mod scenario;
pub mod stability;
