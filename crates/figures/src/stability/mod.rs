//! Tests the stability of a scene's keys in their loop, before anyone plays.
//!
//! A trial (`trial`) plays one key on its rig with the loop of the running host (estimator, model,
//! limits, wire, motor, key) under extreme fingers. `examine` tries some keys of each range, and
//! searches the nearest stable settings for unstable ones.

mod examine;
mod remedy;
mod trial;

pub use examine::{RangeStability, UnstableKey, examine, examine_keys, instabilities};
