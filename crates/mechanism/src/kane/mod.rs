//! Mechanisms described in files, as equations of motion by Kane's method.
//!
//! In the order of processing: [`text`] reads expressions with units, [`description`] a whole file
//! with all its mistakes; [`graph`] stores all expressions once, with exact derivatives;
//! [`mechanism`] is a checked description; [`mechanics`] derives [`system`] from it, mode by mode;
//! [`tape`] is the straight-line program of some expressions; [`assemble`] builds the table and the
//! functions of a model for `instruments::equations`; [`readable`] writes a system as text.
//!
//! Not here: time stepping, keys, sound.

pub mod assemble;
mod bound;
pub mod description;
pub mod mechanics;
pub mod mechanism;
mod program;
pub mod readable;
mod rest_check;
pub mod system;

pub use crate::expressions::{graph, tape};
pub use crate::formulas as text;
pub use program::{DerivedModel, derive_model, derive_unless_cancelled};
