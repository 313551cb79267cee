//! Text for a reached maximum: its kind, and the limit to raise.

use core::fmt::{self, Display, Formatter};

use crate::limits::Limits;
use crate::outcome::Cap;

impl Cap {
    /// Returns the counted quantity, as in `events in one tick`.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Events => "events in one tick",
            Self::Cascade => "transitions at one instant",
            Self::Guards => "guard evaluations in one tick",
            Self::Pieces => "steps in one tick",
            Self::Work(_) => "evaluations in one tick",
        }
    }

    /// Returns the field of [`Limits`] to raise.
    pub const fn limit(self) -> &'static str {
        match self {
            Self::Events => "Limits::events",
            Self::Cascade => "Limits::cascade",
            Self::Guards => "Limits::guards",
            Self::Pieces => "Limits::pieces",
            Self::Work(_) => "Limits::work",
        }
    }
}

impl Display for Cap {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "too many {}: raise {}", self.unit(), self.limit())
    }
}

/// A maximum reached by a tick, displayed as `64 events in one tick: raise Limits::events`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ReachedMaximum {
    pub cap: Cap,
    pub maximum: u32,
}

impl Display for ReachedMaximum {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}: raise {}", self.maximum, self.cap.unit(), self.cap.limit())
    }
}

impl Limits {
    /// Returns the maximum that a tick ended with `cap` has reached, for display.
    pub const fn reached(&self, cap: Cap) -> ReachedMaximum {
        let maximum = match cap {
            Cap::Events => self.events,
            Cap::Cascade => self.cascade,
            Cap::Guards => self.guards,
            Cap::Pieces => self.pieces,
            Cap::Work(limit) => limit,
        };
        ReachedMaximum { cap, maximum }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_maximum_names_the_limit_to_raise() {
        let limits = Limits { events: 1, cascade: 2, guards: 3, pieces: 4, ..Limits::default() };
        let told = [
            (Cap::Events, "1 events in one tick: raise Limits::events"),
            (Cap::Cascade, "2 transitions at one instant: raise Limits::cascade"),
            (Cap::Guards, "3 guard evaluations in one tick: raise Limits::guards"),
            (Cap::Pieces, "4 steps in one tick: raise Limits::pieces"),
            (Cap::Work(5), "5 evaluations in one tick: raise Limits::work"),
        ];
        for (cap, words) in told {
            assert_eq!(limits.reached(cap).to_string(), words);
        }
        assert_eq!(Cap::Events.to_string(), "too many events in one tick: raise Limits::events");
    }
}
