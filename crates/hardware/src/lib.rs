//! The keys' side of the tick: links, boards, calibration, and the simulated keybed.
//!
//! [`rt::bus::Bus`] is the host's end of eight boards on any [`link::Link`]s: samples in,
//! forces out, what was lost counted. [`sim::keybed::SimulatedKeybed`] puts simulated
//! boards on the other end and fills the scheduler's `KeyBus`, byte for byte as real ones
//! would. [`discovery`] says what this machine has, and why it cannot be used.
//!
//! Not here: threads, clocks, and what a force should be.
#![forbid(unsafe_code)]

pub mod calibration;
pub mod discovery;
mod error;
pub mod link;
pub mod rt;
pub mod sim;

pub use error::Error;
