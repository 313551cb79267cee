//! Expressions that are held once, their exact derivatives, and the programs that compute them.
//!
//! [`graph`] holds expressions that share their parts; [`tape`] is the straight-line program of
//! some of them; [`taylor`] has the power series of what a tape computes.
//!
//! Not here: what the expressions are about, how they are written in a file.

pub mod graph;
pub mod tape;
pub mod taylor;
