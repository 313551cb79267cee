//! Detects and prevents a key that returns more energy than the hand put in. The observer reports
//! excess energy as a fault. The controller is stricter: it limits each force before it is sent.

mod controller;
mod observer;

pub use controller::PassivityController;
pub use observer::{EnergyBound, PassivityObserver};
