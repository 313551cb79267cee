//! The instruments: what each key can be.
//!
//! One folder per model that is part of the program: `model.toml` is its description,
//! `emitted.rs` the Rust that `letoff model emit` makes of it, and `README.md` says what its
//! coordinates, modes and guards are, where it comes from, and where it stops being true.
//! [`catalogue`] finds a model by its name, whether it is part of the program or was read from a
//! file ([`registry`]): both are tables with functions by number.
//! To add one, copy `bouncing_ball/` and add a line to `built_in.rs`.
//!
//! Not here: time stepping, estimation of the key's motion, forces in newtons at the
//! finger. A model's input and readout are in its own generalised coordinate.
#![forbid(unsafe_code)]

mod describe;
mod entry;
mod mode_code;
mod mode_name;

pub mod built_in;
pub mod catalogue;
pub mod descriptions;
pub mod draw;
pub mod emitted;
pub mod entry_of_table;
mod equation_model;
mod loaded_model;
pub mod registry;

pub use describe::{Damper, Described, Playable, Sounding, hammer_speed};
pub use entry::{GuardEntry, ModeEntry, ModelEntry, Parameter, Preset};
pub use equation_model::LoadedFunctions;
pub use equations::table::{MidiTable, PressureKind, PressureTable};
pub use mode_code::ModeCode;
pub use mode_name::ModeName;
