//! Reasons why a stroke is not played as written.

use std::fmt;

use super::search::{Try, level_error};
use super::{Practice, Strike};
use crate::stroke::PlannedStroke;

/// Lateness above which a stroke is left out (s): rhythm bears no more, and the next stroke of the
/// key would be late, too.
pub const LATEST: f64 = 0.01;

/// Velocity error above which the stroke is reported (MIDI units).
const LEVEL: f64 = 2.0;

/// Reason why a stroke is not played as written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Shortfall {
    /// The key cannot be struck again so soon; the stroke is left out.
    TooSoon {
        /// Lateness of the strike (s), if there would be one.
        late: Option<f64>,
    },
    /// No gesture throws the hammer to the string; the stroke is left out.
    Silent,
    /// The key does not reach the speed; the nearest is played.
    Level {
        /// Hammer speed at the string (m/s).
        speed: f64,
        /// Written hammer speed (m/s).
        wanted: f64,
    },
    Repeated,
}

impl Shortfall {
    pub const fn is_left_out(&self) -> bool {
        matches!(self, Self::TooSoon { .. } | Self::Silent)
    }

    /// Returns the shortfall of `found`, the best try for `wanted`.
    pub(super) fn of(
        practice: &Practice<'_>,
        wanted: &PlannedStroke,
        found: &Try,
        is_free: IsFree,
    ) -> Option<Self> {
        let Some(Strike { at, speed }) = found.strike else {
            return Some(match is_free {
                IsFree::Yes => Self::Silent,
                IsFree::No => Self::TooSoon { late: None },
            });
        };
        let late = at - wanted.onset;
        if late < -LATEST {
            // A hammer that still moves flies at the touch of the finger.
            return Some(Self::TooSoon { late: None });
        }
        if late > LATEST {
            return Some(Self::TooSoon { late: Some(late) });
        }
        if found.n_extra > 0 {
            return Some(Self::Repeated);
        }
        let is_off = level_error(practice, wanted, found.strike) > LEVEL;
        is_off.then_some(Self::Level { speed, wanted: wanted.speed })
    }
}

/// Yes if the key was at rest long before a stroke.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum IsFree {
    Yes,
    No,
}

impl fmt::Display for Shortfall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooSoon { late: Some(late) } => {
                let late = late * 1e3;
                write!(f, "left out, since its key can be struck again only {late:.0} ms later")
            }
            Self::TooSoon { late: None } => {
                write!(f, "left out, since its key cannot be struck again so soon")
            }
            Self::Silent => write!(f, "left out, since no stroke of the finger reaches the string"),
            Self::Level { speed, wanted } if speed < wanted => {
                write!(f, "softer than written: the key gives {speed:.2} m/s of {wanted:.2} m/s")
            }
            Self::Level { speed, wanted } => {
                write!(f, "louder than written: the key gives {speed:.2} m/s, not {wanted:.2} m/s")
            }
            Self::Repeated => write!(f, "struck more than once by its hammer"),
        }
    }
}
