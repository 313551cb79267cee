//! What a player and a technician would measure of an action.
//!
//! The key's front is driven by position and its force is what comes out: a comparison by force
//! flatters any model (Thorin, Boutillon & Lozada 2014).
//!
//! `drive` how keys are driven, `key` one key that is, `stroke` what a stroke gives, `slope` force
//! over travel, `again` repetition and return, `grands` the measured grands, `figure` the figures
//! with their limits, `gather` all of it for one instrument.

mod again;
mod drive;
mod figure;
mod gather;
mod grands;
mod key;
mod slope;
mod stroke;
mod subject;

pub use drive::StrokeTouch;
pub use figure::{Figure, figure_names};
pub use gather::{Examination, JOBS, examine};
pub use grands::{StrokeTime, speeds};
pub use key::{ActionSample, DrivenKey, Opener, StringContact};
pub use slope::{ForceCurve, Hump};
pub use stroke::{Stroke as PlayedStroke, durations};
pub use subject::PianoSubject;
