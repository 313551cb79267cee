//! Implementations of the scheduler's ports.

pub mod key_set;
pub mod observer;
pub mod tick_recorder;
