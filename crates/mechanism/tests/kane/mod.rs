//! Mechanisms and their programs against closed forms, models by hand, and other programs.
#![expect(clippy::expect_used, clippy::panic, reason = "a test that cannot go on fails")]
#![expect(clippy::large_stack_frames, reason = "a test has a thread of its own")]

mod assembled;
mod beside_by_hand;
mod bounds;
mod builder;
mod by_hand;
mod by_hand_models;
mod certain_steps;
mod closed_forms;
mod conserved;
mod contacts;
mod description;
mod energy;
mod errors;
mod evaluation;
mod grand;
mod guard_bounds;
mod impacts;
mod lagrange;
mod oracle;
mod passivity;
mod plain_equations;
mod playable;
mod rates;
mod readable;
mod reference;
mod resting;
mod rigid;
mod runnable;
mod series;
mod shipped;
mod sounding;
mod stated;
mod stroke;
mod touching;
mod work;
