//! Tests of what a mechanism's equations are, against closed forms, models written by hand, and
//! other programs.

mod builder;
mod closed_forms;
mod evaluation;
mod hand_written;
mod models_ab;
mod small_models;
