//! Power series of what a tape computes, for Taylor's method.
//!
//! [`Recursion`] says for each value of a tape how its next coefficient follows from those before;
//! [`SeriesTapes`] makes straight lines of it that compile like any other function. `[JZ05]`

mod carried;
mod coefficients;
mod conditions;
mod functions;
mod lanes;
mod recursion;
mod rules;
mod step_terms;
mod straight;
mod writing;

pub use coefficients::SeriesCoefficients;
pub use recursion::Recursion;
pub use rules::SeriesRule;
pub use straight::SeriesTapes;
