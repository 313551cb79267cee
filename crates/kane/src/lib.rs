//! Mechanisms described in files, as equations of motion by Kane's method.
//!
//! In the order in which a description passes: [`graph`] holds all expressions once, with exact
//! derivatives; [`mechanism`] is a checked description; [`system`] what was derived from it, mode
//! by mode; [`tape`] is the straight-line program of some expressions, and [`taylor`] the power series
//! of what it computes.
//!
//! Not here: time stepping, keys, what an instrument sounds like.
#![forbid(unsafe_code)]

pub mod graph;
pub mod mechanism;
pub mod system;
pub mod tape;
pub mod taylor;
