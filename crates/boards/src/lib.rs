//! The keys' side of the tick: boards, calibration, and the simulated keybed.
//!
//! [`rt::bus::KeybedBus`] is the host's end of eight boards on any [`crate::links::Link`]s: it
//! exchanges samples and forces, and counts losses. [`sim::keybed::SimulatedKeybed`] puts simulated
//! boards on the other end, byte for byte as real ones. [`plan`] computes the capacity of a bus
//! before a board is armed, and measures its load afterwards.
//!
//! Not here: carriers of frames ([`links`]), threads, clocks, and the computation of forces.
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
