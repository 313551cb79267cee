//! What a guard is known to do next, carried from step to step and from tick to tick.
//!
//! `[GC93]` 5.1: the burden of the root finder can be shared by prior steps if a root is
//! predicted in advance. Two numbers per guard do that. `room` is how far the guard is above zero
//! at least: each step takes off as much as the guard can have moved along the orbit that was
//! computed, and until nothing is left the guard is not even evaluated. And its curvature over the
//! last step tells when it is due to vanish: a step that would go past that ends just behind it
//! instead, so that the crossing lies at a step's end, where the method is at its best, and not on
//! its dense output.

use crate::crossing::GuardSpan;
use crate::enclosure::GuardBound;
use crate::epoch::Stand;
use crate::guard::{GuardSpec, GuardValue};
use crate::math::sqrt;

/// One guard of the present mode: how it stands, and what is known of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct GuardSlot {
    pub(crate) stand: Stand,
    /// Value and rate at the present instant, or where it was evaluated last.
    pub(crate) value: GuardValue,
    /// The same at the start of the step that was taken last.
    pub(crate) start: GuardValue,
    /// Whether `value` belongs to the present instant.
    pub(crate) is_fresh: bool,
    /// Whether it has moved by more than the model's bound allows: what that says is not used.
    pub(crate) is_doubted: bool,
    /// How far the guard is above the rounding around zero, at least; 0 unless it is armed.
    pub(crate) room: f64,
    /// Bound of its bend over the step that was taken last (per step²).
    pub(crate) bend: f64,
    /// Its second derivative (1/s²) over the last step; infinite where there was none.
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
    /// A guard that is not watched in the mode.
    pub(crate) const UNWATCHED: Self = Self { stand: Stand::Unwatched, ..Self::EMPTY };

    /// A guard that stands so at the present instant.
    #[inline]
    pub(crate) const fn new(stand: Stand, spec: &GuardSpec, value: GuardValue) -> Self {
        let slot = Self { stand, value, start: value, is_fresh: true, ..Self::EMPTY };
        Self { room: slot.room_of(spec), ..slot }
    }

    /// The room that its value at the present instant gives.
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

    /// Whether the guard is positive all over a step in which it moves within `bound`.
    #[inline]
    pub(crate) fn is_clear_of(&self, bound: &GuardBound) -> bool {
        self.room > bound.moves
    }

    /// Whether it is by so much that its value after the step is not needed either: it is known
    /// at both ends of the last step before the one in which it may vanish.
    #[inline]
    pub(crate) fn is_asleep(&self, bound: &GuardBound) -> bool {
        self.room > 4.0 * bound.moves
    }

    /// Takes over the guard's value at the `end` of a step of `h` (s) that moves it within
    /// `bound`; returns whether it has moved further, so that nothing is known of it.
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

    /// The guard over the step of `h` (s) that was taken last.
    #[inline]
    pub(crate) const fn span(&self, spec: GuardSpec, h: f64) -> GuardSpan {
        let Self { stand, start, value: end, bend, .. } = *self;
        GuardSpan { spec, stand, start, end, h, bend }
    }

    /// When (s) it is expected to vanish, if that is within `h` (s); infinite otherwise.
    #[inline]
    pub(crate) fn due_within(&self, h: f64) -> f64 {
        // A sleeping guard is not due, and most others are too far to fall that low.
        let fall = h * (self.value.rate.abs() + 0.5 * self.curvature.abs() * h);
        let is_far = !self.is_fresh || fall < self.value.value;
        if is_far { f64::INFINITY } else { due(self.value, self.curvature) }
    }

    /// The same a step later that moved it within `bound`, with nothing new known.
    #[inline]
    pub(crate) fn pass(&mut self, bound: &GuardBound) {
        self.room -= bound.moves;
        self.is_fresh = false;
    }
}

/// When (s) a guard with this curvature vanishes, from above; infinite if it does not.
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
