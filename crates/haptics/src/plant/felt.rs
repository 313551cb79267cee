//! A felt: the unilateral spring and damper that ends a key's travel.

/// One felt of a key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Felt {
    /// Key position at which it is touched (m).
    pub position: f64,
    /// Stiffness (N/m).
    pub stiffness: f64,
    /// Damping while compressed (N s/m).
    pub damping: f64,
}

/// The side of the key on which a felt lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FeltSide {
    /// Touched by a key that is up; pushes it down.
    Rest,
    /// Touched by a key that is down; pushes it up.
    Bottom,
}

impl FeltSide {
    /// Direction into the felt, down positive.
    const fn sign(self) -> f64 {
        match self {
            Self::Rest => -1.0,
            Self::Bottom => 1.0,
        }
    }
}

/// What a felt does over one substep, as a function of the velocity at its end.
///
/// With the compression `d` at the start and the velocity `w` into the felt at the end, it
/// pushes back with max(0, k (d + h w) + c w): spring at the end of the substep, damper only
/// if it is compressed already. Being the gradient of a convex energy taken at the end, it
/// can take energy from the key but never give more than it stored.
#[derive(Clone, Copy, Debug)]
pub(super) struct Resistance {
    sign: f64,
    /// Push at zero velocity, before the `max` (N).
    preload: f64,
    /// Push per velocity (N s/m).
    slope: f64,
}

impl Felt {
    /// Resistance to a key at `position` (m) over `h` (s).
    pub(super) fn resistance(&self, side: FeltSide, position: f64, h: f64) -> Resistance {
        let sign = side.sign();
        let depth = sign * (position - self.position);
        let damping = if 0.0 < depth { self.damping } else { 0.0 };
        Resistance { sign, preload: self.stiffness * depth, slope: self.stiffness * h + damping }
    }
}

impl Resistance {
    /// Force on a key that does not move (N), down positive.
    pub(super) fn holding(&self) -> f64 {
        -self.sign * self.preload.max(0.0)
    }

    /// Velocity `v` that solves inertia · v = impulse + h · push(v), in (m/s).
    ///
    /// `inertia` (kg) includes what else resists the velocity, `impulse` (N s) is everything
    /// that does not depend on it. The right side never rises with `v`, so there is exactly
    /// one solution: with the felt or without it.
    pub(super) fn solve(&self, inertia: f64, impulse: f64, h: f64) -> f64 {
        let free = impulse / inertia;
        if self.preload + self.slope * self.sign * free <= 0.0 {
            return free;
        }
        (impulse - h * self.sign * self.preload) / (inertia + h * self.slope)
    }
}
