//! What a bus can carry: planned before boards are armed, metered while they run.
//!
//! | module | what stands there |
//! |---|---|
//! | [`can`], [`uart`], [`usb`] | how long a frame takes on each kind of wire |
//! | [`medium`] | the same question for any of them |
//! | [`packing`] | how many bytes a board's keys take |
//! | [`response`] | how long a frame waits behind others |
//! | [`bus`] | boards and rates on one bus: its load, its highest rate |
//! | [`verdict`], [`propose`] | whether that will do, and what would |
//! | [`meter`] | the same arithmetic over frames that were seen |
//!
//! Pure arithmetic; times in microseconds, rates in hertz, loads as shares of 1. Every load
//! is the worst case: bits that depend on the payload are charged as if it were the worst.

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
