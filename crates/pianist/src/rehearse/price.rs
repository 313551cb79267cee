//! The price of what a listener hears, in milliseconds of lateness.
//!
//! | fault | price |
//! |---|---|
//! | early or late by 1 ms | 1, beyond 20 ms 1.5 |
//! | too loud by 1 MIDI velocity | 3 |
//! | too soft by 1 MIDI velocity | 2.5, at most 30 in all |
//! | struck again by a bouncing hammer | 30 |
//! | struck only if no tick is lost | 10 |
//! | no strike | 40: see [`MISSING`] |
//! | a part of a note cut off | 30 for the whole note, by the square of the part beyond 20 ms |
//! | 1 ms of a gap before the next stroke | 0.012, from 20 to 420 ms |
//! | a note end early or late by 1 ms, when it is not cut | 1 |
//! | release velocity off by 1 | 0.1 |
//!
//! A velocity that a key at rest does not give counts from the nearest one that it gives; from there
//! to the written one, a velocity costs 0.1.

use super::{Practice, Strike};
use crate::stroke::PlannedStroke;

/// Price of a missing note. A worse stroke is left out: one that is 33 ms late, or 13 velocities
/// too loud.
pub const MISSING: f64 = 40.0;

/// Price up to which a stroke is as good as written: 2 ms, or less than a velocity.
pub(super) const ACCEPTABLE: f64 = 2.0;

/// Price with which a search among everything ends.
pub(super) const FAIR: f64 = 4.0;

pub(super) const SECOND_STRIKE: f64 = 30.0;

/// Price of a stroke that fails if a tick is lost.
pub(super) const FRAGILE: f64 = 10.0;

pub(super) const LOUD: f64 = 3.0;
const SOFT: f64 = 2.5;
const SOFTEST: f64 = 30.0;
const BETWEEN: f64 = 0.1;
const WHOLE_NOTE: f64 = 30.0;

/// Distance from an onset that disturbs the rhythm (ms).
const UNEVEN: f64 = 20.0;

/// Price of a gap between two notes (1/s), and the gap beyond which no listener asks for legato (s).
const GAP: f64 = 12.0;
const LONG_GAP: f64 = 0.4;

/// Cut that no listener notices (s).
const UNHEARD: f64 = 20e-3;

impl Practice<'_> {
    pub(super) fn price(&self, wanted: &PlannedStroke, strike: Option<Strike>) -> f64 {
        let Some(strike) = strike else { return MISSING };
        let level = self.curve.level(strike.speed).clamp(0.0, 128.0);
        let [reached, written] = self.levels(wanted);
        let louder = (level - reached.max(written)).max(0.0);
        let softer = (reached.min(written) - level).max(0.0);
        let between = (level - written).abs() - louder - softer;
        LOUD * louder
            + (SOFT * softer).min(SOFTEST)
            + BETWEEN * between
            + late(strike.at - wanted.onset)
    }

    /// Returns the nearest velocity that the key gives at rest, and the wanted one.
    fn levels(&self, wanted: &PlannedStroke) -> [f64; 2] {
        [self.reach(wanted.speed), wanted.speed].map(|it| self.curve.level(it).clamp(0.0, 128.0))
    }

    /// Returns `true` if the key at rest gives the wanted velocity.
    pub(super) fn is_within_reach(&self, wanted: &PlannedStroke) -> bool {
        self.reach(wanted.speed).to_bits() == wanted.speed.to_bits()
    }

    /// Returns the hammer speed at rest that is nearest to `speed` (m/s).
    pub(super) fn reach(&self, speed: f64) -> f64 {
        self.tables.range().map_or(speed, |(softest, loudest)| speed.clamp(softest, loudest))
    }
}

/// Returns the price of a strike that is `by` early or late (s).
fn late(by: f64) -> f64 {
    let by = 1e3 * by.abs();
    by + 0.5 * (by - UNEVEN).max(0.0)
}

/// Returns the price of a note of `length` (s) that ends `lost` (s) early.
pub(super) fn cut(length: f64, lost: f64) -> f64 {
    let heard = (lost - UNHEARD).max(0.0);
    let part = (heard / length).min(1.0);
    WHOLE_NOTE * part * part + GAP * heard.min(LONG_GAP)
}

/// Returns the price of a note end that is `off` (s), with a release velocity off by `units`.
pub(super) fn end(off: f64, units: f64) -> f64 {
    1e3 * off.abs() + 0.1 * units.abs()
}
