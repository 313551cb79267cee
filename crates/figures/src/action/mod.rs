//! Measurements of an action as by a player and a technician.
//!
//! The front's position is driven: a comparison by force flatters models (Thorin et al. 2014).
//!
//! `drive` is the input, `key` a driven key, `stroke` one stroke, `slope` force over travel,
//! `again` repetition and return, `grands` the measured grands, `figure` figures with limits,
//! `gather` all of an instrument, `regulation` the quick ones of one key.

mod again;
mod drive;
mod figure;
mod gather;
mod grands;
mod key;
mod regulation;
mod slope;
mod stroke;
mod subject;

pub use drive::StrokeTouch;
pub use figure::{Figure, figure_names};
pub use gather::{Examination, JOBS, examine};
pub use grands::{StrokeTime, speeds};
pub use key::{ActionSample, DrivenKey, Opener, StringContact};
pub use regulation::{Regulation, regulation};
pub use slope::{ForceCurve, Hump};
pub use stroke::{Stroke as PlayedStroke, durations};
pub use subject::PianoSubject;
