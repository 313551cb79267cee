//! Forecast of a guard, carried from step to step and from tick to tick.
//!
//! `[GC93]` 5.1: prior steps can share the burden of the root finder by predicting the root. Two
//! numbers per guard do it: `room` is a lower bound of the guard: each step subtracts the most that
//! the guard can have moved along the computed orbit, and the guard is not evaluated until nothing
//! is left. Its curvature over the last step predicts its root: a step that would pass the root
//! ends just behind it, so that the crossing lies at a step's end, where the method is most exact,
//! not on its dense output.

use crate::crossing::GuardSpan;
use crate::enclosure::GuardBound;
use crate::epoch::Stand;
use crate::guard::{GuardSpec, GuardValue};
use crate::math::sqrt;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct GuardSlot {
    pub(crate) stand: Stand,
    /// Value and rate at the present instant, or at the last evaluation.
    pub(crate) value: GuardValue,
    /// Value and rate at the start of the last step.
    pub(crate) start: GuardValue,
    pub(crate) is_fresh: bool,
    /// `true` if it has moved beyond the model's bound, which is then not used.
    pub(crate) is_doubted: bool,
    /// Lower bound of its distance above the rounding around zero; 0 unless it is armed.
    pub(crate) room: f64,
    /// Bound of its bend over the last step (per step²).
    pub(crate) bend: f64,
    /// Its second derivative (1/s²) over the last step; infinite if unknown.
    pub(crate) curvature: f64,
}

impl GuardSlot {
    pub(crate) const EMPTY: Self = Self {
        stand: Stand::Resting,
        value: GuardValue { value: 0.0, rate: 0.0 },
        start: GuardValue { value: 0.0, rate: 0.0 },
        is_fresh: false,
        is_doubted: false,
        room: 0.0,
        bend: f64::INFINITY,
        curvature: f64::INFINITY,
    };
    pub(crate) const UNWATCHED: Self = Self { stand: Stand::Unwatched, ..Self::EMPTY };

    #[inline]
    pub(crate) const fn new(stand: Stand, spec: &GuardSpec, value: GuardValue) -> Self {
        let slot = Self { stand, value, start: value, is_fresh: true, ..Self::EMPTY };
        Self { room: slot.room_of(spec), ..slot }
    }

    #[inline]
    pub(crate) const fn room_of(&self, spec: &GuardSpec) -> f64 {
        match self.stand {
            Stand::Armed => self.value.value - spec.band(),
            Stand::Departing
            | Stand::Resting
            | Stand::Disarmed
            | Stand::Spent
            | Stand::Sinking
            | Stand::Leaving
            | Stand::Unwatched => 0.0,
        }
    }

    /// Returns `true` if the guard, moving within `bound`, is positive over the whole step.
    #[inline]
    pub(crate) fn is_clear_of(&self, bound: &GuardBound) -> bool {
        self.room > bound.moves
    }

    /// Returns `true` if its value after the step is not needed either: both ends of the last step
    /// before the one in which it may vanish are known.
    #[inline]
    pub(crate) fn is_asleep(&self, bound: &GuardBound) -> bool {
        self.room > 4.0 * bound.moves
    }

    /// Sets the guard's value at the `end` of a step of `h` (s) that moves it within `bound`;
    /// returns `true` if it has moved further, which makes the bound useless.
    #[inline]
    pub(crate) fn step_to(
        &mut self,
        end: GuardValue,
        bound: &GuardBound,
        h: f64,
        spec: &GuardSpec,
    ) -> bool {
        let start = self.value;
        let moved = (end.value - start.value).abs();
        let is_doubted = self.is_fresh && moved > bound.moves + spec.band();
        let curvature = if self.is_fresh { (end.rate - start.rate) / h } else { f64::INFINITY };
        (self.start, self.value, self.curvature) = (start, end, curvature);
        self.bend = if is_doubted { f64::INFINITY } else { bound.bend };
        self.is_doubted |= is_doubted;
        self.is_fresh = true;
        is_doubted
    }

    #[inline]
    pub(crate) const fn span(&self, spec: GuardSpec, h: f64) -> GuardSpan {
        let Self { stand, start, value: end, bend, .. } = *self;
        GuardSpan { spec, stand, start, end, h, bend }
    }

    /// Returns the time (s) until it is predicted to vanish, if within `h` (s); infinite otherwise.
    #[inline]
    pub(crate) fn due_within(&self, h: f64) -> f64 {
        // A sleeping guard is not due, and most others cannot fall to zero within `h`.
        let fall = h * (self.value.rate.abs() + 0.5 * self.curvature.abs() * h);
        let is_far = !self.is_fresh || fall < self.value.value;
        if is_far { f64::INFINITY } else { due(self.value, self.curvature) }
    }

    /// Advances the slot over a step without an evaluation; the guard moves within `bound`.
    #[inline]
    pub(crate) fn pass(&mut self, bound: &GuardBound) {
        self.room -= bound.moves;
        self.is_fresh = false;
    }
}

/// Returns the time (s) until a guard with this curvature falls to zero; infinite if never.
fn due(guard: GuardValue, curvature: f64) -> f64 {
    let discriminant = guard.rate * guard.rate - 2.0 * curvature * guard.value;
    if discriminant < 0.0 || discriminant.is_nan() || guard.value <= 0.0 {
        return f64::INFINITY;
    }
    let root = sqrt(discriminant);
    let due = if guard.rate > 0.0 {
        -(guard.rate + root) / curvature
    } else {
        2.0 * guard.value / (root - guard.rate)
    };
    if due > 0.0 { due } else { f64::INFINITY }
}
