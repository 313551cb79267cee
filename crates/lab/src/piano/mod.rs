//! `letoff lab piano`: what a player and a technician would measure of an instrument, beside three
//! measured grands.
//!
//! The key's front is driven by position and its force is what comes out: a comparison by force
//! flatters any model (Thorin, Boutillon & Lozada 2014).
//!
//! `drive` how keys are driven, `key` one key that is, `stroke` what a stroke gives, `slope` force
//! over travel, `again` repetition and return, `grands` the measured grands, `figure` the figures
//! with their limits, `gather` all of it for one instrument, `sheet` the report.

mod again;
mod drive;
mod figure;
mod gather;
mod grands;
mod key;
mod sheet;
mod slope;
mod stroke;
mod subject;

pub use figure::{Figure, figure_names};
pub use gather::{Examination, JOBS, examine};
pub(crate) use key::Opener;
pub use sheet::write_sheet;
pub use subject::PianoSubject;
