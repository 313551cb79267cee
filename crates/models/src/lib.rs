//! The instruments: what each key can be.
//!
//! One folder per model: `mod.rs` (parameters with units, names, presets),
//! `equations.rs` (the equations themselves), `model.toml` (the same model as a description),
//! `emitted.rs` (the Rust that the description gives; nothing runs it yet but tests and benches),
//! `drawing.rs` (what it looks like from the side, to scale)
//! and `README.md` (coordinates, modes and guards, source, where it stops being true).
//! [`catalogue`] is the only file that knows all of them; to add one, copy
//! `bouncing_ball/` and add a line there. Models that are read from files are in [`registry`].
//!
//! Not here: time stepping, estimation of the key's motion, forces in newtons at the
//! finger. A model's input and readout are in its own generalised coordinate.
#![cfg_attr(not(any(test, feature = "std")), no_std)]
#![forbid(unsafe_code)]

mod bounds;
mod describe;
mod entry;
mod impact;
mod mode_code;
mod mode_name;
mod parameters;
mod shapes;

pub mod bouncing_ball;
pub mod cart_pendulum;
pub mod catalogue;
pub mod descriptions;
pub mod draw;
mod equation_model;
pub mod key_hammer;
pub mod key_hammer_rigid;
pub mod key_hammer_springs;
pub mod reduced_grand;
pub mod registry;
pub mod spring_wall;
mod visitor;

pub use bouncing_ball::BouncingBall;
pub use cart_pendulum::CartPendulum;
pub use describe::{Damper, Described, Playable, Sounding};
pub use entry::{GuardEntry, ModeEntry, ModelEntry, Parameter, Preset};
pub use equation_model::{CataloguedFunctions, LoadedFunctions};
pub use key_hammer_rigid::KeyHammerRigid;
pub use key_hammer_springs::KeyHammerSprings;
pub use mode_code::ModeCode;
pub use mode_name::ModeName;
pub use reduced_grand::ReducedGrand;
pub use spring_wall::SpringWall;
