//! Bounds of a computed orbit over one step, and of the guards along it.
//!
//! A step is certain if no guard can have reached zero along the computed orbit: the dense output
//! between the step's two ends, with the input of the same time. Sums of the magnitudes of the
//! polynomial's coefficients bound its move, speed and bend, whatever the method has made of the
//! equations; the model bounds its guards by those of the state
//! ([`Guarded::guard_bound`](crate::Guarded::guard_bound)). No prediction is needed.
//!
//! The distance of the computed orbit from the true one is the step's error, not bounded here.

use crate::input::Motion;
use crate::state::State;

/// Bounds of a computed orbit over one step, as the fraction τ of the step goes from 0 to 1.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Enclosure<S, I> {
    /// Length of the step (s).
    pub h: f64,
    pub start: S,
    /// Bound of |x(τ) − x(0)|, entry by entry.
    pub moves: S,
    /// Bound of |dx/dτ|.
    pub speeds: S,
    /// Bound of |d²x/dτ²|.
    pub bends: S,
    pub input_start: I,
    /// Largest magnitudes of the input and its rates (unit/s, unit/s², …); `None` if unknown.
    pub input: Option<I>,
}

/// Upper bounds of a guard's change over a step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct GuardBound {
    /// Bound of |g(τ) − g(0)|.
    pub moves: f64,
    /// Bound of |d²g/dτ²|.
    pub bend: f64,
}

impl GuardBound {
    pub const UNKNOWN: Self = Self { moves: f64::INFINITY, bend: f64::INFINITY };
    pub const STILL: Self = Self { moves: 0.0, bend: 0.0 };

    #[inline]
    pub const fn new(moves: f64, bend: f64) -> Self {
        Self { moves, bend }
    }

    #[inline]
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        Self { moves: self.moves + other.moves, bend: self.bend + other.bend }
    }

    #[inline]
    #[must_use]
    pub const fn times(self, factor: f64) -> Self {
        Self { moves: self.moves * factor.abs(), bend: self.bend * factor.abs() }
    }
}

impl<S: State, I> Enclosure<S, I> {
    /// Returns the bound of state entry `index` as a guard; unknown if there is no such entry.
    #[inline]
    pub fn entry(&self, index: usize) -> GuardBound {
        let at = |x: &S| x.entries().get(index).copied().unwrap_or(f64::INFINITY);
        GuardBound { moves: at(&self.moves), bend: at(&self.bends) }
    }
}

impl<S: State> Enclosure<S, Motion> {
    #[inline]
    pub fn position(&self) -> GuardBound {
        self.input.map_or(GuardBound::UNKNOWN, |most| {
            GuardBound::new(self.h * most.rate, self.h * self.h * most.acceleration)
        })
    }

    #[inline]
    pub fn rate(&self) -> GuardBound {
        self.input.map_or(GuardBound::UNKNOWN, |most| {
            GuardBound::new(self.h * most.acceleration, self.h * self.h * most.jerk)
        })
    }

    /// Returns the bound of the input's acceleration; its bend would need a fourth derivative.
    #[inline]
    pub fn acceleration(&self) -> GuardBound {
        self.input
            .map_or(GuardBound::UNKNOWN, |most| GuardBound::new(self.h * most.jerk, f64::INFINITY))
    }
}

/// Returns a lower bound over a step of a guard with the values `g0` and `g1` (less rounding) at
/// its ends and a second derivative within ±`bend` (per step²). The guard is at most a parabola
/// below its chord: g ≥ chord − ½ bend τ (1 − τ).
#[inline]
pub(crate) fn least(g0: f64, g1: f64, bend: f64) -> f64 {
    // bend = 0 gives an infinite or undefined place, and the lower end.
    let tau = 0.5 - (g1 - g0) / bend;
    if bend.is_nan() {
        f64::NEG_INFINITY
    } else if tau > 0.0 && tau < 1.0 {
        g0 + tau * (g1 - g0) - 0.5 * bend * tau * (1.0 - tau)
    } else {
        g0.min(g1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_guard_is_lowest_where_its_parabola_is() {
        // 1 − ½·4 τ (1 − τ) is lowest in the middle, ½; a steeper chord is lowest at its end.
        assert!((least(1.0, 1.0, 4.0) - 0.5).abs() < 1e-15);
        assert!((least(1.0, 3.0, 4.0) - 1.0).abs() < 1e-15);
        assert!((least(3.0, 1.0, 4.0) - 1.0).abs() < 1e-15);
        assert!((least(2.0, 1.0, 0.0) - 1.0).abs() < 1e-15);
        assert!(least(1.0, 1.0, f64::INFINITY) < -1e300 && least(1.0, 1.0, f64::NAN) < -1e300);
        // 1 + τ − ½·4 τ (1 − τ) at ¼: 1 + ¼ − ⅜.
        assert!((least(1.0, 2.0, 4.0) - 0.875).abs() < 1e-15);
    }
}
