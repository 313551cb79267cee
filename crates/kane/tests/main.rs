//! Tests of what a mechanism's equations are, against closed forms, models written by hand, and
//! other programs.

mod builder;
mod closed_forms;
mod contacts;
mod energy;
mod errors;
mod evaluation;
mod hand_written;
mod models_ab;
mod oracle;
mod small_models;
