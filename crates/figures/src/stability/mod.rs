//! Whether the keys of a scene are stable in their loop, found out before anybody is at them.
//!
//! A trial (`trial`) plays one key of the scene on its rig, with the very loop that will run:
//! estimator, model, limits, wire, motor, key, and each corner of what fingers do. `examine` tries
//! some keys of each range, and looks for the nearest settings with which those are stable that are
//! not.

mod examine;
mod remedy;
mod trial;

pub use examine::{RangeStability, UnstableKey, examine, examine_keys, instabilities};
