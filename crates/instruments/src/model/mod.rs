//! A model with the names, units, drawing and sound of an instrument.

mod describe;
pub mod draw;
mod entry;
mod equation_model;
mod loaded_model;
mod mode_code;
mod mode_name;
mod parts;
mod source;

pub use crate::equations::table::MAX_CODED_CONTACTS;
pub use describe::{Damper, Described, NamedModes, Playable, Sounding, hammer_speed};
pub use entry::{GuardEntry, ModeEntry, ModelEntry, Parameter, Preset};
pub use loaded_model::{DoesNotLoad, LARGEST, LoadedModel, SharedFunctions, SmallModel, Visitor};
pub use mode_code::ModeCode;
pub use mode_name::ModeName;
pub use parts::ModelParts;
pub use source::{FileContents, ModelSource};
