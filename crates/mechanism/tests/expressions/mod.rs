//! Expressions against trees that are evaluated by recursion, tapes against both, and series
//! against closed forms and the committed code.

pub(crate) mod common;
mod graph;
mod tape;
mod taylor;
