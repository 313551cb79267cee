//! Power series of the values of a tape, for Taylor's method.
//!
//! [`Recursion`] derives the next coefficient of each value from lower orders; [`SeriesTapes`]
//! turns it into straight-line tapes that compile like any other function. `[JZ05]`

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
