//! Expressions that are stored once, their exact derivatives, and the programs that compute them.
//!
//! [`graph`] holds expressions with shared parts; [`tape`] is the straight-line program of some of
//! them.

pub mod graph;
pub mod tape;
