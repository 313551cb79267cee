//! What plugs into the scheduler's ports.

pub mod audit;
pub mod damper;
pub mod input;
pub mod lookout;
pub mod observer;
pub mod tap;
pub mod voice;
