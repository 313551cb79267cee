//! Tests of what a mechanism's equations are, against closed forms, models written by hand, and
//! other programs.
#![expect(clippy::expect_used, clippy::panic, reason = "a test that cannot go on fails")]

mod builder;
mod closed_forms;
mod contacts;
mod energy;
mod errors;
mod evaluation;
mod hand_written;
mod models_ab;
mod oracle;
mod plain_equations;
mod small_models;
