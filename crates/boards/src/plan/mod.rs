//! Capacity of a bus: planned before boards are armed, metered while they run.
//!
//! | module | content |
//! |---|---|
//! | [`can`], [`uart`], [`usb`] | time of a frame on each kind of wire |
//! | [`medium`] | time of a frame on any of them |
//! | [`packing`] | bytes of a board's keys |
//! | [`response`] | wait of a frame behind others |
//! | [`bus`] | boards and rates on one bus: its load, its highest rate |
//! | [`verdict`], [`propose`] | verdict on a plan, and an alternative |
//! | [`meter`] | the same arithmetic over observed frames |
//!
//! Times in microseconds, rates in hertz, loads as shares of 1 with the worst payloads.

pub mod bus;
pub mod can;
pub mod medium;
pub mod meter;
pub mod packing;
pub mod propose;
pub mod response;
pub mod uart;
pub mod usb;
pub mod verdict;

pub use bus::{BusPlan, Extras, standard};
pub use medium::{Medium, NoPlan};
pub use meter::{LinkMeter, MeterWindow};
pub use packing::{ForcePacking, SamplePacking};
pub use propose::Proposal;
pub use verdict::BusVerdict;
