//! Which contacts are closed, and what their frictions do: bits beside the structural mode.

use core::fmt;

/// Most contacts and bearings of one model: one bit each.
pub const MAX_CONTACTS: usize = 64;

/// What one contact does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ContactState {
    /// The surfaces are apart.
    Open,
    /// They touch, without friction.
    Closed,
    /// They touch, and friction holds them at slip speed zero.
    Stick,
    /// They touch, and the slip speed is positive.
    SlideUp,
    /// They touch, and the slip speed is negative.
    SlideDown,
}

impl ContactState {
    /// The sign of the slip speed while it slides, 0 otherwise.
    pub const fn slip_sign(self) -> f64 {
        match self {
            Self::SlideUp => 1.0,
            Self::SlideDown => -1.0,
            Self::Open | Self::Closed | Self::Stick => 0.0,
        }
    }

    /// The slide in the direction of `slip`, a number with that sign.
    pub(super) fn slide(slip: f64) -> Self {
        if slip < 0.0 { Self::SlideDown } else { Self::SlideUp }
    }
}

/// The states of all contacts of a model, by their numbers.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
pub struct ContactSet {
    /// Those that touch, with or without friction.
    closed: u64,
    /// Of these, those whose friction holds, and those that slide.
    stick: u64,
    up: u64,
    down: u64,
}

impl ContactSet {
    /// The set in which all contacts are open.
    pub const OPEN: Self = Self { closed: 0, stick: 0, up: 0, down: 0 };

    /// The same with `contact` in the state `state`; a number that no contact has is ignored.
    #[must_use]
    pub const fn with(self, contact: usize, state: ContactState) -> Self {
        let bit = bit(contact);
        let mut set = Self {
            closed: self.closed | bit,
            stick: self.stick & !bit,
            up: self.up & !bit,
            down: self.down & !bit,
        };
        match state {
            ContactState::Open => set.closed &= !bit,
            ContactState::Closed => {}
            ContactState::Stick => set.stick |= bit,
            ContactState::SlideUp => set.up |= bit,
            ContactState::SlideDown => set.down |= bit,
        }
        set
    }

    /// Returns what `contact` does.
    pub const fn state(&self, contact: usize) -> ContactState {
        let bit = bit(contact);
        if self.closed & bit == 0 {
            ContactState::Open
        } else if self.stick & bit != 0 {
            ContactState::Stick
        } else if self.up & bit != 0 {
            ContactState::SlideUp
        } else if self.down & bit != 0 {
            ContactState::SlideDown
        } else {
            ContactState::Closed
        }
    }

    /// Whether the surfaces of `contact` touch.
    #[inline]
    pub const fn is_closed(&self, contact: usize) -> bool {
        self.closed & bit(contact) != 0
    }

    /// Returns the contacts that touch, in the order of their numbers.
    #[inline]
    pub const fn closed(&self) -> ContactIndices {
        ContactIndices(self.closed)
    }

    /// Returns the contacts whose friction holds.
    #[inline]
    pub const fn sticking(&self) -> ContactIndices {
        ContactIndices(self.stick)
    }

    /// Returns the contacts that slide, in either direction.
    #[inline]
    pub const fn sliding(&self) -> ContactIndices {
        ContactIndices(self.up | self.down)
    }
}

/// The bit of a contact; none beyond the last one.
const fn bit(contact: usize) -> u64 {
    if contact < MAX_CONTACTS { 1 << contact } else { 0 }
}

impl fmt::Debug for ContactSet {
    /// Names what is not open, as in `{0: Closed, 5: Stick}`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map()
            .entries(self.closed().iter().map(|contact| (contact, self.state(contact))))
            .finish()
    }
}

/// A set of contacts by their numbers: going through it takes as many steps as there are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ContactIndices(u64);

impl ContactIndices {
    /// Whether `contact` is one of them.
    #[inline]
    pub const fn contains(self, contact: usize) -> bool {
        self.0 & bit(contact) != 0
    }

    /// Whether there are none.
    #[inline]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// How many numbers there are.
    #[inline]
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// Returns those that are not among `others`.
    #[inline]
    #[must_use]
    pub const fn without(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    /// Returns the numbers in ascending order.
    #[inline]
    pub const fn iter(self) -> IndexIter {
        IndexIter(self.0)
    }
}

impl IntoIterator for ContactIndices {
    type Item = usize;
    type IntoIter = IndexIter;

    #[inline]
    fn into_iter(self) -> IndexIter {
        IndexIter(self.0)
    }
}

/// Runs through the numbers of [`ContactIndices`].
#[derive(Clone, Debug)]
pub struct IndexIter(u64);

impl Iterator for IndexIter {
    type Item = usize;

    #[inline]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let contact = self.0.trailing_zeros() as usize;
        self.0 &= self.0 - 1;
        Some(contact)
    }
}
