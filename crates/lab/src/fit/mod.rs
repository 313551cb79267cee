//! `letoff lab fit`: a measured action becomes an instrument.
//!
//! A key of the instrument is driven by position as the measured one went, and the force that
//! comes out is compared with the measured force. Parameters are changed within their ranges until
//! the sum of squares of the differences, each over its noise, is least.
//!
//! `data` reads strokes, `smooth` tells motion from noise, `driven` is a key that follows a
//! stroke, `task` runs all strokes for any values, `sensitivity` has steps and derivatives, `solve`
//! the search, `certainty` what the data can tell and how well, `outcome` all of it, `sheet` the
//! report.
//!
//! The travel is measured with noise, too, of which smoothing leaves some; a hammer that rings on its
//! felt answers it with a force. So the noise is drawn anew a dozen times, smoothed as the data
//! were, and what each draw would do to the values is part of their covariance.
//!
//! A search goes downhill from the instrument's values, and where it ends one parameter after the
//! other is tried some steps away; if that is better, it goes on from there. It may still end in a
//! place that is not the best: its differences are then several times the noise, which is told.
//!
//! What the intervals take for granted: the differences that remain are noise, Gaussian, and
//! alike but for their stated sizes; the model is linear in its parameters over an interval. Their
//! size is that of the differences that remain, neighbours that are alike count as fewer rows
//! (their correlation from row to row is taken out), and Student's t has the rows that are left. A
//! model that cannot follow the data has differences that are no noise: its intervals tell how well
//! the best values are determined, not that they are a real action's.
//!
//! Let-off, pluck and contacts make the force a function of the parameters that is smooth in pieces
//! only. So each derivative is taken by central differences over a step that moves the force by
//! about half of the differences that there are, at least half of their noise, and again over half
//! that step; how far the two are apart is in the report.

mod certainty;
mod data;
mod driven;
mod outcome;
mod sensitivity;
mod sheet;
mod smooth;
mod solve;
mod task;
#[cfg(test)]
mod tests;

pub use data::{DataMistake, MeasuredStroke, read_stroke};
pub use outcome::{FitOutcome, FittedParameter, FittedStroke, fit};
pub use sheet::write_fit;
pub use task::FitSubject;
