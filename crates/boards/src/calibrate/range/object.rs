use haptics::KeyMotion;

/// An object that a rig should render before it renders an instrument.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RangedObject {
    Spring,
    Dashpot,
    Mass,
}

impl RangedObject {
    /// All objects, the easiest first.
    pub const ALL: [Self; 3] = [Self::Spring, Self::Dashpot, Self::Mass];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Spring => "spring",
            Self::Dashpot => "dashpot",
            Self::Mass => "mass",
        }
    }

    pub const fn unit(self) -> &'static str {
        match self {
            Self::Spring => "N/m",
            Self::Dashpot => "N·s/m",
            Self::Mass => "kg",
        }
    }

    /// Returns the first value: a fifth of the paper's limits, and 2 g.
    pub const fn first(self) -> f64 {
        match self {
            Self::Spring => 20.0,
            Self::Dashpot => 0.2,
            Self::Mass => 2e-3,
        }
    }

    /// Returns the last value: a wall, or more than a finger moves.
    pub const fn most(self) -> f64 {
        match self {
            Self::Spring => 50e3,
            Self::Dashpot => 500.0,
            Self::Mass => 2.0,
        }
    }

    /// Returns its push on a key in `motion` (N, down positive); a spring rests at `middle` (m).
    pub(super) fn push(self, value: f64, motion: &KeyMotion, middle: f64) -> f64 {
        match self {
            Self::Spring => value * (middle - motion.position),
            Self::Dashpot => -value * motion.velocity,
            Self::Mass => -value * motion.acceleration,
        }
    }
}
