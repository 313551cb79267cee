//! Machine code against the tapes that it was made of.

#[path = "../../expressions/tests/common/mod.rs"]
mod common;

mod bits;
