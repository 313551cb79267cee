//! Models from functions by number, which native code and the interpreter both fill in.
//!
//! [`table`] is a model without its arithmetic, [`table::Functions`] that arithmetic;
//! [`functions`] contains functions of expressions beyond the elementary ones of `pode`.
//! [`EquationModel`] combines both into a model of `pode`, and one with contacts is
//! `WithContacts<EquationModel<..>>`.
//!
//! Not here: the origin of the functions, and Jacobians of friction: a mode that sticks is resolved
//! by its structure's rates.

#![expect(
    clippy::same_name_method,
    reason = "an instrument passes on what its equations are asked"
)]

mod about;
mod apart;
mod balance;
mod find_natures;
pub mod functions;
mod guards;
mod impacts;
mod jacobian_bound;
mod mechanical;
mod mode_number;
mod model;
mod motion;
mod natures;
mod projection;
mod rates;
mod relax;
mod rest;
mod rows;
mod softplus;
mod structure;
mod structure_balance;
pub mod table;

pub use impacts::MOST_RIGID;
pub use mode_number::ModeNumber;
pub use model::{DoesNotFit, EquationModel};
pub use natures::MAX_MODES;
pub use rest::RestPose;

pub use softplus::{FAR_SOFTPLUS, Softplus};
