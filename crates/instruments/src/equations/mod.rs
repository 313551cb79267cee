//! Models made of functions by number: what native code and the interpreter both fill in.
//!
//! [`table`] is what a model is apart from its arithmetic, and [`table::Functions`] that arithmetic;
//! [`functions`] has what an expression can apply beyond the elementary functions of `pode`.
//! [`EquationModel`] is a model of `pode` made of both, and one with contacts is
//! `WithContacts<EquationModel<..>>`.
//!
//! # What is not here
//! Where the functions come from. Jacobians of friction: a mode that sticks is resolved by its
//! structure's rates.

#![expect(
    clippy::same_name_method,
    reason = "an instrument passes on what its equations are asked"
)]

mod about;
mod balance;
mod find_natures;
pub mod functions;
mod guards;
mod jacobian_bound;
mod mode_number;
mod model;
mod motion;
mod natures;
mod projection;
mod rates;
mod relax;
mod rest;
mod rows;
mod series;
mod softplus;
mod structure;
mod structure_balance;
pub mod table;

pub use mode_number::ModeNumber;
pub use model::{DoesNotFit, EquationModel};
pub use natures::MAX_MODES;
pub use rest::RestPose;

pub use softplus::{FAR_SOFTPLUS, Softplus};
