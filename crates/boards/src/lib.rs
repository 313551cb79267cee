//! The keys' side of the tick: boards, calibration, and the simulated keybed.
//!
//! [`rt::bus::KeybedBus`] is the host's end of eight boards on any [`crate::links::Link`]s: samples in,
//! forces out, what was lost counted. [`sim::keybed::SimulatedKeybed`] puts simulated
//! boards on the other end and fills the scheduler's `KeyBus`, byte for byte as real ones
//! would. [`plan`] says what a bus can carry before a board is armed, and measures what it
//! carries after.
//!
//! Not here: what carries frames ([`links`]), threads, clocks, and what a force should be.
#![forbid(unsafe_code)]

pub mod calibrate;
pub mod calibration;
pub mod clock;
pub mod conformance;
mod error;
pub mod hello_values;
pub mod identity;
pub mod keybed;
pub mod links;
mod periods;
pub mod plan;
pub mod refusal;
pub mod request_channel;
pub mod rt;
pub mod sim;
pub mod topology;
pub mod untaken;

pub use error::Error;
