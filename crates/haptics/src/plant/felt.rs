//! A felt: the unilateral spring and damper that ends a key's travel.

/// One felt: position at first contact (m), stiffness (N/m), damping while compressed (N s/m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Felt {
    pub position: f64,
    pub stiffness: f64,
    pub damping: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FeltSide {
    /// Touched by a key that is up; pushes it down.
    Rest,
    /// Touched by a key that is down; pushes it up.
    Bottom,
}

impl FeltSide {
    const fn sign(self) -> f64 {
        match self {
            Self::Rest => -1.0,
            Self::Bottom => 1.0,
        }
    }
}

/// Force of a felt over one substep, as a function of the velocity at its end.
///
/// With the compression `d` at the start and the velocity `w` into the felt at the end, it pushes
/// back with max(0, k (d + h w) + c w): spring at the end of the substep, damper only if already
/// compressed. As the gradient of a convex energy, it never returns more than it stored.
#[derive(Clone, Copy, Debug)]
pub(super) struct Resistance {
    sign: f64,
    /// Push at zero velocity, before the `max` (N).
    preload: f64,
    /// Push per velocity (N s/m).
    slope: f64,
}

impl Felt {
    /// Returns the resistance to a key at `position` (m) over `h` (s).
    pub(super) fn resistance(&self, side: FeltSide, position: f64, h: f64) -> Resistance {
        let sign = side.sign();
        let depth = sign * (position - self.position);
        let damping = if 0.0 < depth { self.damping } else { 0.0 };
        Resistance { sign, preload: self.stiffness * depth, slope: self.stiffness * h + damping }
    }
}

impl Resistance {
    /// Returns the force on a key at rest (N), down positive.
    pub(super) fn holding(&self) -> f64 {
        -self.sign * self.preload.max(0.0)
    }

    /// Returns the only velocity `v` (m/s) with inertia · v = impulse + h · push(v), where push
    /// never rises with `v`. `inertia` (kg) and `impulse` (N s) contain all other forces.
    pub(super) fn solve(&self, inertia: f64, impulse: f64, h: f64) -> f64 {
        let free = impulse / inertia;
        if self.preload + self.slope * self.sign * free <= 0.0 {
            return free;
        }
        (impulse - h * self.sign * self.preload) / (inertia + h * self.slope)
    }
}
