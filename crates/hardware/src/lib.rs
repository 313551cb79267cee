//! The keys' side of the tick: links, boards, calibration, and the simulated keybed.
//!
//! [`rt::bus::Bus`] is the host's end of eight boards on any [`link::Link`]s: samples in,
//! forces out, what was lost counted. [`sim::keybed::SimulatedKeybed`] puts simulated
//! boards on the other end and fills the scheduler's `KeyBus`, byte for byte as real ones
//! would. [`plan`] says what a bus can carry before a board is armed, and measures what it
//! carries after. [`discovery`] says what this machine has, and why it cannot be used.
//!
//! Not here: threads, clocks, and what a force should be.
#![forbid(unsafe_code)]

pub mod calibrate;
pub mod calibration;
pub mod clock;
pub mod courier;
pub mod discovery;
mod error;
pub mod keybed;
pub mod link;
mod pause;
pub mod plan;
pub mod refusal;
pub mod rt;
pub mod sim;
pub mod topology;

pub use error::Error;
