//! What of a mode's state moves by equations of its own, and in which independent parts.

use crate::nature::Nature;
use crate::state::State;

/// Most parts that one mode can have.
pub const MAX_PARTS: usize = 4;

/// Entries of the state whose derivatives depend on one another and on the input, and on no other
/// entry that moves by equations: a system of its own beside those of the same mode.
///
/// `[GC93]` table 1 counts the degrees of freedom of each mode: hammer and key apart are two
/// systems of one, and a hammer that is slaved to the key is none.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Part {
    /// A bit for each entry of the state that belongs to it.
    entries: u64,
    /// What its equations are like; the mode's own nature where that is not stated.
    nature: Option<Nature>,
}

impl Part {
    /// The whole state as one part.
    pub const WHOLE: Self = Self { entries: u64::MAX, nature: None };

    /// The part with the entries of the state at `indices`, each below 64.
    pub const fn of(indices: &[usize]) -> Self {
        let (mut entries, mut n) = (0, 0);
        while n < indices.len() {
            entries |= 1 << indices[n];
            n += 1;
        }
        Self { entries, nature: None }
    }

    /// The same with equations of another nature than the mode as a whole.
    #[must_use]
    pub const fn with_nature(self, nature: Nature) -> Self {
        Self { nature: Some(nature), ..self }
    }

    /// What its equations are like, in a mode of the nature `whole`.
    #[inline]
    pub(crate) const fn nature(&self, whole: Nature) -> Nature {
        match self.nature {
            Some(nature) => nature,
            None => whole,
        }
    }

    /// Whether the entry `index` belongs to the part.
    #[inline]
    pub const fn has(&self, index: usize) -> bool {
        // An entry beyond the bits belongs to the whole only.
        if index < 64 { self.entries >> index & 1 == 1 } else { self.entries == u64::MAX }
    }

    /// Whether the part is the whole state.
    #[inline]
    pub(crate) const fn is_whole(&self) -> bool {
        self.entries == u64::MAX
    }

    /// How many entries of a state with `length` entries belong to it.
    #[inline]
    pub(crate) fn count(&self, length: usize) -> u32 {
        let among = if length < 64 { (1_u64 << length) - 1 } else { u64::MAX };
        (self.entries & among).count_ones()
    }

    /// The entries of `x` that belong to the part; zero for the others.
    #[inline]
    pub(crate) fn only<S: State>(&self, x: &S) -> S {
        if self.is_whole() { *x } else { S::ZERO.with_entries(x, self) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_has_its_entries_and_no_others() {
        const KEY: Part = Part::of(&[1, 3]);
        assert_eq!([0, 1, 2, 3, 70].map(|index| KEY.has(index)), [false, true, false, true, false]);
        assert_eq!((KEY.count(4), KEY.count(2), Part::WHOLE.count(4)), (2, 1, 4));
        assert_eq!(
            KEY.only(&[1.0, 2.0, 3.0, 4.0]).map(f64::to_bits),
            [0.0, 2.0, 0.0, 4.0].map(f64::to_bits)
        );
        assert!(Part::WHOLE.has(70) && Part::WHOLE.is_whole());
    }
}
