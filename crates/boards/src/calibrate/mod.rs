//! Calibration of encoders and motors by small forces.
//!
//! ```text
//! rest      no force: the mean of 0.3 s
//! trip      pushed down until it moves, until it stops; then up until it moves, until it is
//!           back: the bottom, and the friction as half the difference of the two pushes
//! balance   the same with a known weight on it: the shift of the middle of the two pushes is
//!           the command to the motor for the weight
//! range     a spring, a dashpot and a mass on it, raised until it shakes: the renderable range
//! ```
//!
//! [`rest`], [`trip`], [`balance`] and [`range`] turn times and positions into pushes, without
//! boards; [`mod@bench`] connects them to the keys of armed boards. A push is down positive. Except
//! for a range it changes slowly, and only while the key is at rest.

pub mod balance;
pub mod bench;

mod key_push;
pub mod range;
pub mod rest;
pub mod trip;

use firmware_protocol::acyclic::calibration as wire;

use crate::calibration::KeyCalibration;

pub use crate::calibration::CalibrationFault;
pub use balance::Balance;
pub use bench::{Bench, Ending};
pub use range::{RangeEnd, RangeFound, RangeMeasurement, RangeTerms, RangedObject};
pub use rest::{RestMeasurement, Rested};
pub use trip::{Travelled, TripMeasurement};

/// Largest push on a key without a weight (N).
pub const MOST_PUSH: f64 = 1.5;
/// Possible travels of a key (m).
pub const TRAVELS: (f64, f64) = (5e-3, 20e-3);
/// Weights that differ from friction, and that a finger's key carries (kg).
pub const WEIGHTS: (f64, f64) = (0.03, 0.15);
/// Standard acceleration of free fall (m/s^2).
pub const G: f64 = 9.806_65;

/// Next action of a measurement.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Next<T> {
    /// A push on the key (N, down positive).
    Push(f64),
    Done(T),
}

/// Returns a key's calibration; measurements were read by `nominal`, `gain` is per newton (1).
pub fn calibrated(
    nominal: &KeyCalibration,
    rested: &Rested,
    travelled: &Travelled,
    gain: f64,
) -> KeyCalibration {
    KeyCalibration {
        rest: nominal.counts(rested.position),
        bottom: nominal.counts(travelled.bottom),
        quantum: nominal.quantum,
        friction: travelled.friction / gain,
        gain,
    }
}

pub fn record(slot: u8, key: &KeyCalibration) -> wire::KeyCalibration {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
    let gain_permille = (1e3 / key.gain).round() as u16;
    wire::KeyCalibration { slot, rest: key.rest.get(), bottom: key.bottom.get(), gain_permille }
}

#[cfg(test)]
mod tests;
