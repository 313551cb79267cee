//! Expressions against trees that are evaluated by recursion, tapes against both, and series
//! against what is committed.

mod common;
mod graph;
mod tape;
mod taylor;
