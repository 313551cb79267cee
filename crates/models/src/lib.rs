//! Models as instruments: a description's table and functions as what a key can be.
//!
//! One folder per model of the paper and its neighbours: `model.toml` is its description, and
//! `README.md` says what its coordinates, modes and guards are, where it comes from, and where it
//! stops being true. The crate `descriptions` reads them, and whatever a user writes, into a
//! [`LoadedModel`], which all voices and commands that use the model share by `Arc`.
//!
//! Not here: time stepping, estimation of the key's motion, forces in newtons at the
//! finger. A model's input and readout are in its own generalised coordinate.
#![forbid(unsafe_code)]

mod describe;
mod entry;
mod equation_model;
mod loaded_model;
mod mode_code;
mod mode_name;
mod parts;
mod source;

pub mod draw;

pub use describe::{Damper, Described, Playable, Sounding, hammer_speed};
pub use entry::{GuardEntry, ModeEntry, ModelEntry, Parameter, Preset};
pub use equation_model::MAX_CODED_CONTACTS;
pub use equations::table::{MidiTable, PressureKind, PressureTable};
pub use loaded_model::{DoesNotLoad, LARGEST, LoadedModel, SharedFunctions, SmallModel, Visitor};
pub use mode_code::ModeCode;
pub use mode_name::ModeName;
pub use parts::ModelParts;
pub use source::{FileContents, ModelSource};
