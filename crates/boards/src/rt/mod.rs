//! Exchange with the boards in a tick, and its losses.
//!
//! No heap, no lock, no clock; the only system calls are those of the links.

pub mod board;
pub mod board_supervisor;
pub mod bus;
pub mod key_fault;
mod key_guard;
pub mod lateness;
pub mod link_monitor;
pub mod link_snapshot;
pub mod loss;
mod multicast;
pub mod plausible;
mod round_trips;
pub mod sample_interval;
pub mod terms;
