//! What plugs into the scheduler's ports.

pub mod lookout;
pub mod observer;
pub mod tap;
