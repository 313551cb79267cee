//! A table and functions become a model that a key can play.
//!
//! [`equations`] makes a model of `pode` from functions by number, without the standard library;
//! the rest makes of that what voices, commands and panels use.
//!
//! One folder per model of the paper and its neighbours: `model.toml` is its description, and
//! `README.md` says what its coordinates, modes and guards are, where it comes from, and where it
//! stops being true. The crate `descriptions` reads them, and whatever a user writes, into a
//! [`LoadedModel`], which all voices and commands that use the model share by `Arc`.
//!
//! Not here: time stepping, estimation of the key's motion, forces in newtons at the
//! finger. A model's input and readout are in its own generalised coordinate.
#![cfg_attr(not(any(test, feature = "std")), no_std)]
#![forbid(unsafe_code)]

extern crate alloc;

pub mod equations;
#[cfg(any(test, feature = "std"))]
mod model;

pub use crate::equations::table::{MidiTable, PressureKind, PressureTable};
#[cfg(any(test, feature = "std"))]
pub use model::{
    Damper, Described, DoesNotLoad, FileContents, GuardEntry, LARGEST, LoadedModel,
    MAX_CODED_CONTACTS, ModeCode, ModeEntry, ModeName, ModelEntry, ModelParts, ModelSource,
    NamedModes, Parameter, Playable, Preset, SharedFunctions, SmallModel, Sounding, Visitor, draw,
    hammer_speed,
};
