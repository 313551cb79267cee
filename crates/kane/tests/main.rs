//! Expressions, tapes and what is made of them, against independent computations.

mod common;
mod emit;
#[path = "emitted/example.rs"]
mod emitted;
mod graph;
mod readable;
mod tape;
