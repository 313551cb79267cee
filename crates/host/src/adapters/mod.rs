//! What plugs into the scheduler's ports.

pub mod link_monitor;
pub mod observer;
pub mod tick_recorder;
