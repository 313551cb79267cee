//! Models that a key can play, from a table and functions.
//!
//! [`equations`] builds a model of `pode` from functions by number, without the standard library;
//! the other modules build from it the model for voices, commands and panels.
//!
//! Each model of the paper and its neighbours has a folder: `model.toml` is its description;
//! `README.md` states its coordinates, modes and guards, its origin and its validity. The crate
//! `mechanism` reads these and a user's descriptions into a [`LoadedModel`], which all voices and
//! commands share by `Arc`.
//!
//! Not here: time stepping, estimation of the key's motion, forces in newtons at the finger. A
//! model's input and readout are in its own generalised coordinate.
#![cfg_attr(not(any(test, feature = "std")), no_std)]
#![forbid(unsafe_code)]

extern crate alloc;

pub mod equations;
#[cfg(any(test, feature = "std"))]
mod model;

pub use crate::equations::table::{MidiTable, PressureKind, PressureTable, Reading};
#[cfg(any(test, feature = "std"))]
pub use model::{
    Damper, Described, DoesNotLoad, FileContents, GuardEntry, LARGEST, LoadedModel,
    MAX_CODED_CONTACTS, ModeCode, ModeEntry, ModeName, ModelEntry, ModelParts, ModelSource,
    NamedModes, Parameter, Playable, Preset, SharedFunctions, SmallModel, Sounding, Visitor, draw,
    hammer_speed,
};
