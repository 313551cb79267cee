//! Why a stroke is not played as it is written.

use std::fmt;

use super::search::{Try, level_error};
use super::{Practice, Strike};
use crate::stroke::PlannedStroke;

/// A stroke that would be later than this is left out (s): rhythm bears no more, and the next
/// stroke of the key would be late as well.
pub const LATEST: f64 = 0.01;

/// A velocity that is off by more than this is named, in MIDI units.
const LEVEL: f64 = 2.0;

/// Why a stroke is not played as it is written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Shortfall {
    /// The key cannot be struck again so soon; the stroke is left out.
    TooSoon {
        /// How late the strike would be (s); none where there would be none.
        late: Option<f64>,
    },
    /// No gesture throws the hammer to the string; the stroke is left out.
    Silent,
    /// The key gives no such speed; the nearest is played.
    Level {
        /// Speed of the hammer at the string (m/s).
        speed: f64,
        /// The speed that is written (m/s).
        wanted: f64,
    },
    /// The hammer strikes more than once.
    Repeated,
}

impl Shortfall {
    /// Whether the stroke is left out.
    pub const fn is_left_out(&self) -> bool {
        matches!(self, Self::TooSoon { .. } | Self::Silent)
    }

    /// What `found` lacks, which is the best for `wanted`; `is_free` says whether the key was at
    /// rest long before.
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
            // A hammer that is still on its way flies at the touch of the finger.
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

/// Whether the key was at rest long before a stroke.
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
