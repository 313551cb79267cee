//! Power series of what a tape computes, for Taylor's method.
//!
//! [`Recursion`] says for each value of a tape how its next coefficient follows from those before;
//! [`TapeSeries`] follows it, [`SeriesTapes`] makes straight lines of it that compile like any other
//! function, and [`emit`] writes it as Rust. `[JZ05]`

mod carried;
mod conditions;
mod emit;
mod evaluate;
mod functions;
mod lanes;
mod recursion;
mod rules;
mod step_terms;
mod straight;
mod writing;

pub use emit::{SeriesNames, emit};
pub use evaluate::{SeriesStart, TapeSeries};
pub use recursion::Recursion;
pub use rules::SeriesRule;
pub use straight::SeriesTapes;
