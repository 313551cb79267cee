//! Tests of what a mechanism's equations are, and of the programs that are assembled from them,
//! against closed forms, models written by hand, and other programs.
#![expect(clippy::expect_used, clippy::panic, reason = "a test that cannot go on fails")]

mod assembled;
mod beside_hand_written;
mod bounds;
mod builder;
mod by_hand;
mod certain_steps;
mod closed_forms;
mod common;
mod conserved;
mod contacts;
mod derived;
mod description;
mod energy;
mod errors;
mod evaluation;
mod hand_written;
mod models_ab;
mod oracle;
mod plain_equations;
mod readable;
mod resting;
mod rigid;

mod series;
mod shipped;
mod small_models;
mod sounding;
mod spring_wall;
mod stated;
mod touching;
mod work;
