//! Expressions against trees that are evaluated by recursion, tapes against both, and series
//! against what is committed.
#![expect(clippy::expect_used, clippy::panic, reason = "a test that cannot go on fails")]

mod common;
mod graph;
mod tape;
mod taylor;
