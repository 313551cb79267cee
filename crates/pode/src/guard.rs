//! Guards: specification, value, and the condition under which they fire.

use core::ops::Neg;

pub const MAX_GUARDS: usize = 32;

/// A guard's number within its model, stable over modes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct GuardId(pub u8);

/// Condition under which a guard fires.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fires {
    /// Whenever it is negative: a mode entered with the wrong sign is left at once. It fires once
    /// each time that it becomes negative. If its own reset map stays in the mode and leaves it
    /// negative, it fires again only after it has been positive, or where it sinks further and the
    /// reset map would turn it. [`Work::ineffective`](crate::Work::ineffective) counts such resets.
    WhileNegative,
    /// On a crossing from above only: a mode may be entered with it negative.
    OnCrossing,
}

/// Arguments of a guard.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Reads {
    /// State and input: the guard jumps where the input jumps between two ticks.
    StateAndInput,
    /// The state alone, in a mode that slaves no coordinate to the input.
    State,
}

/// The constant description of one guard of one mode.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct GuardSpec {
    pub id: GuardId,
    pub name: &'static str,
    /// Order of guards that cross at one instant: the lowest fires first.
    pub priority: u8,
    /// Typical size of the guard's terms, in its own unit; rounding at that size counts as zero.
    pub scale: f64,
    pub fires: Fires,
    pub reads: Reads,
}

impl GuardSpec {
    /// Builds a guard that must stay positive, of size 1 and priority equal to its id.
    pub const fn new(id: u8, name: &'static str) -> Self {
        Self {
            id: GuardId(id),
            name,
            priority: id,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::StateAndInput,
        }
    }

    #[must_use]
    pub const fn scaled(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    #[must_use]
    pub const fn with_priority(self, priority: u8) -> Self {
        Self { priority, ..self }
    }

    #[must_use]
    pub const fn on_crossing(self) -> Self {
        Self { fires: Fires::OnCrossing, ..self }
    }

    /// Returns the guard as a function of the state, not evaluated where only the input jumped.
    #[must_use]
    pub const fn of_state(self) -> Self {
        Self { reads: Reads::State, ..self }
    }

    /// Returns the width of the band around zero that rounding alone can fill.
    pub const fn band(&self) -> f64 {
        /// Rounding steps at the guard's size that may add up in one evaluation.
        const ROUNDINGS: f64 = 16.0;
        ROUNDINGS * f64::EPSILON * self.scale
    }
}

/// A guard's value and its rate along the motion.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct GuardValue {
    /// Positive while the mode is valid.
    pub value: f64,
    /// Total time derivative along the solution (1/s).
    pub rate: f64,
}

impl GuardValue {
    #[inline]
    pub const fn new(value: f64, rate: f64) -> Self {
        Self { value, rate }
    }
}

impl GuardValue {
    #[inline]
    pub(crate) const fn is_finite(&self) -> bool {
        self.value.is_finite() && self.rate.is_finite()
    }
}

impl Neg for GuardValue {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, rate: -self.rate }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct GuardSet([u64; 4]);

impl GuardSet {
    pub(crate) const EMPTY: Self = Self([0; 4]);

    const fn place(id: GuardId) -> (usize, u64) {
        ((id.0 / 64) as usize, 1 << (id.0 % 64))
    }

    pub(crate) const fn insert(&mut self, id: GuardId) {
        let (word, bit) = Self::place(id);
        self.0[word] |= bit;
    }

    pub(crate) const fn remove(&mut self, id: GuardId) {
        let (word, bit) = Self::place(id);
        self.0[word] &= !bit;
    }

    pub(crate) const fn contains(&self, id: GuardId) -> bool {
        let (word, bit) = Self::place(id);
        self.0[word] & bit != 0
    }
}
