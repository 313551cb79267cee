//! The models by hand against closed forms and references, and the described ones against them.

mod certain_steps;
mod common;
mod described;
mod every_model;
mod grand;
mod guard_bounds;
mod impacts;
mod oracle;
mod passivity;
mod playable;
#[path = "../../models/tests/random/mod.rs"]
mod random;
mod reduced_grand;
mod reduced_grand_modes;
mod reduced_grand_playing;
mod reduced_grand_pressed;
mod reference;
#[path = "../../models/tests/stroke/mod.rs"]
mod stroke;
