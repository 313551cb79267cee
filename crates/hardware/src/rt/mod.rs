//! What a tick may call: exchanges with the boards, and what was lost on the way.
//!
//! No heap, no lock, no clock; the only system calls are those of the links.

pub mod board;
pub mod bus;
pub mod glance;
pub mod lateness;
pub mod loss;
mod multicast;
pub mod plausible;
pub mod steward;
mod trips;
