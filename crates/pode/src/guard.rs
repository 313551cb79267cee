//! What a guard is, and when it fires.

use core::ops::Neg;

/// Guards that one mode can have.
pub const MAX_GUARDS: usize = 32;

/// A guard's name within its model, stable over modes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct GuardId(pub u8);

/// When a guard fires.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fires {
    /// Whenever it is negative: a mode entered with the wrong sign is left at once.
    ///
    /// Once for each time that it becomes so: where its own reset map stays in the mode and leaves
    /// it negative, it has fired and fires again only after it has been positive, or where it sinks
    /// further and the reset map would turn it. [`Work::ineffective`](crate::Work::ineffective)
    /// counts such resets.
    WhileNegative,
    /// On a crossing from above only: a mode may be entered with it negative.
    OnCrossing,
}

/// What a guard is a function of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Reads {
    /// State and input: where the input jumps between two ticks, the guard does too.
    StateAndInput,
    /// The state alone, in a mode that slaves no coordinate to the input.
    State,
}

/// The constant description of one guard of one mode.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct GuardSpec {
    pub id: GuardId,
    /// Its name in logs and files.
    pub name: &'static str,
    /// Who goes first when several cross at one instant: the lowest.
    pub priority: u8,
    /// Typical size of the guard's terms, in its own unit; what is smaller than
    /// rounding at that size counts as zero.
    pub scale: f64,
    pub fires: Fires,
    /// What it is a function of.
    pub reads: Reads,
}

impl GuardSpec {
    /// A guard that must stay positive, of size 1 and priority equal to its id.
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

    /// The same guard with terms of size `scale`.
    #[must_use]
    pub const fn scaled(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    /// The same guard with another priority.
    #[must_use]
    pub const fn with_priority(self, priority: u8) -> Self {
        Self { priority, ..self }
    }

    /// The same guard, firing on crossings only.
    #[must_use]
    pub const fn on_crossing(self) -> Self {
        Self { fires: Fires::OnCrossing, ..self }
    }

    /// The same guard, a function of the state alone: it is not taken again where only the
    /// input jumped.
    #[must_use]
    pub const fn of_state(self) -> Self {
        Self { reads: Reads::State, ..self }
    }

    /// Width of the band around zero that rounding alone can fill.
    pub const fn band(&self) -> f64 {
        /// Rounding steps at the guard's size that may add up in one evaluation.
        const ROUNDINGS: f64 = 16.0;
        ROUNDINGS * f64::EPSILON * self.scale
    }
}

/// A guard's value and its rate along the motion.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct GuardValue {
    /// The guard; positive while the mode is valid.
    pub value: f64,
    /// Its total time derivative along the solution (1/s).
    pub rate: f64,
}

impl GuardValue {
    /// A value with its rate.
    #[inline]
    pub const fn new(value: f64, rate: f64) -> Self {
        Self { value, rate }
    }
}

impl GuardValue {
    /// Whether value and rate are finite numbers.
    #[inline]
    pub(crate) const fn is_finite(&self) -> bool {
        self.value.is_finite() && self.rate.is_finite()
    }
}

impl Neg for GuardValue {
    type Output = Self;

    /// The guard with the opposite sign.
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, rate: -self.rate }
    }
}

/// A set of guards by their ids.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct GuardSet([u64; 4]);

impl GuardSet {
    pub(crate) const EMPTY: Self = Self([0; 4]);

    /// The word that holds `id`, and its bit there.
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
