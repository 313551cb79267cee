//! The three objects.

use haptics::KeyMotion;

/// An object that a rig should render before it renders an instrument.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RangedObject {
    /// A force for the way from the middle.
    Spring,
    /// A force for the speed.
    Dashpot,
    /// A force for the acceleration.
    Mass,
}

impl RangedObject {
    /// All of them, the easiest first.
    pub const ALL: [Self; 3] = [Self::Spring, Self::Dashpot, Self::Mass];

    /// Returns its name, which is that of its instrument.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Spring => "spring",
            Self::Dashpot => "dashpot",
            Self::Mass => "mass",
        }
    }

    /// Returns the unit of its value.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Spring => "N/m",
            Self::Dashpot => "N·s/m",
            Self::Mass => "kg",
        }
    }

    /// Returns the value that is tried first: a fifth of the paper's limits, and 2 g.
    pub const fn first(self) -> f64 {
        match self {
            Self::Spring => 20.0,
            Self::Dashpot => 0.2,
            Self::Mass => 2e-3,
        }
    }

    /// Returns the largest value that is tried: walls, and what no finger moves.
    pub const fn most(self) -> f64 {
        match self {
            Self::Spring => 50e3,
            Self::Dashpot => 500.0,
            Self::Mass => 2.0,
        }
    }

    /// Returns its push on a key in `motion` (N, down positive), with the spring at rest at
    /// `middle` (m).
    pub(super) fn push(self, value: f64, motion: &KeyMotion, middle: f64) -> f64 {
        match self {
            Self::Spring => value * (middle - motion.position),
            Self::Dashpot => -value * motion.velocity,
            Self::Mass => -value * motion.acceleration,
        }
    }
}
