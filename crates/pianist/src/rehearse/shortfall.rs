//! Reasons why a stroke is not played as written.

use std::fmt;

use super::price::{LOUD, MISSING};
use super::search::Try;
use super::{Practice, Strike};
use crate::stroke::PlannedStroke;

/// Lateness above which a stroke is reported (s).
const LATE: f64 = 5e-3;

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
    /// The key can be struck in time, but so loud that the stroke is left out.
    TooLoud {
        speed: f64,
        wanted: f64,
    },
    /// No gesture throws the hammer to the string; the stroke is left out.
    Silent,
    /// The stroke is played late (s).
    Late {
        by: f64,
    },
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
        matches!(self, Self::TooSoon { .. } | Self::TooLoud { .. } | Self::Silent)
    }

    /// Returns the shortfall of `found`, the best try for `wanted`.
    pub(super) fn of<R>(
        practice: &Practice<'_>,
        wanted: &PlannedStroke,
        found: &Try<R>,
        is_free: IsFree,
    ) -> Option<Self> {
        let Some(Strike { at, speed }) = found.strike else {
            return Some(match is_free {
                IsFree::Yes => Self::Silent,
                IsFree::No => Self::TooSoon { late: None },
            });
        };
        let (by, wanted_speed) = (at - wanted.onset, wanted.speed);
        let louder = practice.curve.level(speed) - practice.curve.level(wanted_speed);
        let is_late = LOUD * louder.abs() < 1e3 * by;
        if MISSING <= found.price {
            // A hammer that still moves may fly early, at the touch of the finger.
            return Some(if is_late {
                Self::TooSoon { late: Some(by) }
            } else if by < -LATE {
                Self::TooSoon { late: None }
            } else {
                Self::TooLoud { speed, wanted: wanted_speed }
            });
        }
        if found.n_extra > 0 {
            return Some(Self::Repeated);
        }
        if LATE < by && is_late {
            return Some(Self::Late { by });
        }
        let is_off = louder.abs() > LEVEL;
        is_off.then_some(Self::Level { speed, wanted: wanted_speed })
    }
}

/// Certainty that the key was at rest long before a stroke.
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
            Self::TooLoud { speed, wanted } => write!(
                f,
                "left out, since its key is struck again only too loud: {speed:.2} m/s, not {wanted:.2} m/s"
            ),
            Self::Late { by } => {
                write!(f, "{:.0} ms late, since its key cannot be struck again sooner", by * 1e3)
            }
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
