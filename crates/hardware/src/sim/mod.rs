//! Simulated boards and the keybed of eight of them.
//!
//! They speak the wire format on links in memory, through the same bus as real boards.

pub mod board;
mod bus_time;
mod guard;
mod history;
pub mod key;
pub mod keybed;
mod law;
mod multicast;
mod requests;
#[cfg(test)]
mod tests;
