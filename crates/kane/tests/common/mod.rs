//! An example of a model: its table, and its functions.
#![allow(dead_code, unreachable_pub, reason = "each test program uses its own part")]

pub mod example;
#[path = "../../../expressions/tests/common/lever.rs"]
pub mod lever;
