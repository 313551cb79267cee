//! `letoff lab fit`: fits an instrument to a measured action.
//!
//! The measured motion drives a key of the instrument, and the computed force is compared with the
//! measured force. Parameters change within their ranges until the sum of the squared differences,
//! each over its noise, is least.
//!
//! `data` reads strokes, `smooth` removes noise, `driven` is a key that follows a stroke, `task`
//! runs all strokes for any values, `sensitivity` has steps and derivatives, `solve` the search,
//! `certainty` the intervals, `outcome` the whole fit, `sheet` the report.
//!
//! Smoothing leaves some noise in the travel, and a hammer that rings on its felt responds to it
//! with a force. So the noise is drawn a dozen times, smoothed like the data, and the effect of
//! each draw on the values is part of their covariance.
//!
//! A search goes downhill from the instrument's values. At its end each parameter is tried some
//! steps away; if that is better, the search continues there. In a local minimum the differences
//! are several times the noise, and the report warns.
//!
//! The intervals assume that the remaining differences are Gaussian noise, alike but for their
//! stated sizes, and that the model is linear over an interval. Correlated neighbours count as
//! fewer rows, and Student's t has the rows that are left. Of a model that cannot follow the data,
//! the intervals describe the best values, not a real action.
//!
//! Let-off, pluck and contacts make the force only piecewise smooth in the parameters. So each
//! derivative is a central difference over a step that moves the force by half of the present
//! differences or noise, and again over half that step. The report states the distance of the two.

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
