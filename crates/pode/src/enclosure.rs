//! How far a computed orbit moves over one step, and what a guard can do there.
//!
//! A step is certain when no guard can have come to zero along the orbit as it was computed: the
//! dense output between the step's two ends, with the input of the same time. The orbit encloses
//! itself: sums of the magnitudes of its polynomial's coefficients bound its move, its speed and
//! its bend, whatever the method has made of the equations. A model says how its guards follow
//! from the state ([`Guarded::guard_bound`](crate::Guarded::guard_bound)), and nothing of the
//! future has to be believed.
//!
//! How far the computed orbit is from the true one is another question, which the step's error
//! answers.

use crate::input::Motion;
use crate::state::State;

/// Bounds of a computed orbit over one step, as the fraction τ of the step goes from 0 to 1.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Enclosure<S, I> {
    /// Length of the step (s).
    pub h: f64,
    /// State at the start of the step.
    pub start: S,
    /// Bound of |x(τ) − x(0)|, entry by entry.
    pub moves: S,
    /// Bound of |dx/dτ|.
    pub speeds: S,
    /// Bound of |d²x/dτ²|.
    pub bends: S,
    /// Input at the start of the step.
    pub input_start: I,
    /// Largest magnitudes of the input and its rates over the step (unit/s, unit/s² and so on);
    /// `None` where the signal does not know them.
    pub input: Option<I>,
}

/// What a guard does over a step, at most.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct GuardBound {
    /// Bound of |g(τ) − g(0)|.
    pub moves: f64,
    /// Bound of |d²g/dτ²|.
    pub bend: f64,
}

impl GuardBound {
    /// The bound of a guard of which nothing is known.
    pub const UNKNOWN: Self = Self { moves: f64::INFINITY, bend: f64::INFINITY };
    /// The bound of a guard that keeps its value.
    pub const STILL: Self = Self { moves: 0.0, bend: 0.0 };

    /// A bound from those of |g(τ) − g(0)| and of |d²g/dτ²|.
    #[inline]
    pub const fn new(moves: f64, bend: f64) -> Self {
        Self { moves, bend }
    }

    /// The bound of the sum of two guards.
    #[inline]
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        Self { moves: self.moves + other.moves, bend: self.bend + other.bend }
    }

    /// The bound of a guard times `factor`.
    #[inline]
    #[must_use]
    pub const fn times(self, factor: f64) -> Self {
        Self { moves: self.moves * factor.abs(), bend: self.bend * factor.abs() }
    }
}

impl<S: State, I> Enclosure<S, I> {
    /// The bound of the entry `index` of the state as a guard; unknown where there is none.
    #[inline]
    pub fn entry(&self, index: usize) -> GuardBound {
        let at = |x: &S| x.entries().get(index).copied().unwrap_or(f64::INFINITY);
        GuardBound { moves: at(&self.moves), bend: at(&self.bends) }
    }
}

impl<S: State> Enclosure<S, Motion> {
    /// The bound of the input's position as a guard.
    #[inline]
    pub fn position(&self) -> GuardBound {
        self.input.map_or(GuardBound::UNKNOWN, |most| {
            GuardBound::new(self.h * most.rate, self.h * self.h * most.acceleration)
        })
    }

    /// The bound of the input's rate as a guard.
    #[inline]
    pub fn rate(&self) -> GuardBound {
        self.input.map_or(GuardBound::UNKNOWN, |most| {
            GuardBound::new(self.h * most.acceleration, self.h * self.h * most.jerk)
        })
    }

    /// The bound of the input's acceleration as a guard; its bend would take a fourth derivative.
    #[inline]
    pub fn acceleration(&self) -> GuardBound {
        self.input
            .map_or(GuardBound::UNKNOWN, |most| GuardBound::new(self.h * most.jerk, f64::INFINITY))
    }
}

/// Least value over a step of a guard whose values at its ends, less the rounding, are `g0` and
/// `g1`, and whose second derivative stays within ±`bend` (per step²).
///
/// Below the chord between both ends lies at most a parabola: g ≥ chord − ½ bend τ (1 − τ).
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
