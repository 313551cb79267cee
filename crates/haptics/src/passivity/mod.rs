//! Whether a key gives back more energy than a hand put into it, and a force that does not.
//!
//! The observer tells a key that made too much, which is a fault. The controller is stricter and
//! comes before it: it lets no force be sent that could give back more than there is.

mod controller;
mod observer;

pub use controller::PassivityController;
pub use observer::{EnergyBound, PassivityObserver};
