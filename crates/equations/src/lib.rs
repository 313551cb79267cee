//! Models made of functions by number: what emitted Rust and native code both fill in.
//!
//! [`table`] is what a model is apart from its arithmetic, and [`table::Functions`] that arithmetic;
//! [`functions`] has what an expression can apply beyond the elementary functions of `pode`.
#![cfg_attr(not(any(test, feature = "std")), no_std)]
#![forbid(unsafe_code)]

pub mod functions;
mod softplus;
pub mod table;

pub use softplus::{FAR_SOFTPLUS, Softplus};
