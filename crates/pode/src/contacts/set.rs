//! States of the contacts and their frictions: bits beside the structural mode.

use core::fmt;

/// Maximum of contacts and bearings of one model: one bit each.
pub const MAX_CONTACTS: usize = 64;

/// State of one contact.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ContactState {
    Open,
    Closed,
    Stick,
    SlideUp,
    SlideDown,
}

impl ContactState {
    /// Returns the sign of the slip speed while it slides, 0 otherwise.
    pub const fn slip_sign(self) -> f64 {
        match self {
            Self::SlideUp => 1.0,
            Self::SlideDown => -1.0,
            Self::Open | Self::Closed | Self::Stick => 0.0,
        }
    }

    pub(super) fn slide(slip: f64) -> Self {
        if slip < 0.0 { Self::SlideDown } else { Self::SlideUp }
    }
}

/// The states of all contacts of a model, by their numbers.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
pub struct ContactSet {
    closed: u64,
    /// Closed contacts with a friction that holds; `up` and `down` slide.
    stick: u64,
    up: u64,
    down: u64,
}

impl ContactSet {
    pub const OPEN: Self = Self { closed: 0, stick: 0, up: 0, down: 0 };

    /// Returns the set with `contact` in `state`; a number beyond all contacts is ignored.
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

    #[inline]
    pub const fn is_closed(&self, contact: usize) -> bool {
        self.closed & bit(contact) != 0
    }

    /// Returns the contacts that touch, in the order of their numbers.
    #[inline]
    pub const fn closed(&self) -> ContactIndices {
        ContactIndices(self.closed)
    }

    #[inline]
    pub const fn sticking(&self) -> ContactIndices {
        ContactIndices(self.stick)
    }

    #[inline]
    pub const fn sliding(&self) -> ContactIndices {
        ContactIndices(self.up | self.down)
    }
}

const fn bit(contact: usize) -> u64 {
    if contact < MAX_CONTACTS { 1 << contact } else { 0 }
}

impl fmt::Debug for ContactSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map()
            .entries(self.closed().iter().map(|contact| (contact, self.state(contact))))
            .finish()
    }
}

/// A set of contacts by their numbers; iterating costs one step per member.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ContactIndices(u64);

impl ContactIndices {
    #[inline]
    pub const fn contains(self, contact: usize) -> bool {
        self.0 & bit(contact) != 0
    }

    #[inline]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    #[inline]
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

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
