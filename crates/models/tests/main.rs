//! The models against closed forms, references and what every model promises.

mod certain_steps;
mod common;
mod conformance;
mod described;
mod drawing;
mod drawing_to_scale;
mod drawn;
mod every_model;
mod grand;
mod guard_bounds;
mod impacts;
mod oracle;
mod passivity;
mod playable;
mod random;
mod reduced_grand;
mod reduced_grand_modes;
mod reduced_grand_playing;
mod reduced_grand_pressed;
mod reference;
mod sketch;
mod stroke;
