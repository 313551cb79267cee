//! An example of a model: its table, and its functions.
#![allow(dead_code, unreachable_pub, reason = "each test program uses its own part")]

#[path = "../../../expressions/tests/common/lever.rs"]
pub mod lever;
