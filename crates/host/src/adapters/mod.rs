//! What plugs into the scheduler's ports.

pub mod observer;
pub mod tick_recorder;
