//! What of a mode's state moves by equations of its own, and in which independent parts.

use crate::guard::Reads;
use crate::math;
use crate::nature::Nature;

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
    /// The longest step that resolves its motion (s); that of the mode where it is not longer.
    longest_step: f64,
    /// What its equations depend on beside its own entries.
    reads: Reads,
}

/// Most steps of the mode that one step of a part spans.
///
/// The dense output of that step is then looked at inside, where a method is less exact than at its
/// end: three steps of the paper's hammer in flight add 1 % to the error of its events' times, four
/// add 2 %.
const MOST_STEPS: f64 = 3.0;

impl Part {
    /// The whole state as one part.
    pub const WHOLE: Self =
        Self { entries: u64::MAX, nature: None, longest_step: 0.0, reads: Reads::StateAndInput };

    /// The part with the entries of the state at `indices`, each below 64.
    pub const fn of(indices: &[usize]) -> Self {
        let (mut entries, mut n) = (0, 0);
        while n < indices.len() {
            entries |= 1 << indices[n];
            n += 1;
        }
        Self { entries, ..Self::WHOLE }
    }

    /// The entries of all `parts` of a state with `length` entries as one.
    #[inline]
    pub(crate) fn union(parts: &[Self], length: usize) -> Self {
        let entries = parts.iter().fold(0, |sum, part| sum | part.entries);
        let union = Self { entries, ..Self::WHOLE };
        if union.count(length) as usize == length { Self::WHOLE } else { union }
    }

    /// The same with equations of another nature than the mode as a whole.
    #[must_use]
    pub const fn with_nature(self, nature: Nature) -> Self {
        Self { nature: Some(nature), ..self }
    }

    /// The same with a longest step (s) of its own: where it is longer than the mode's steps, the
    /// part takes one step for several of them.
    #[must_use]
    pub const fn with_longest_step(self, longest_step: f64) -> Self {
        Self { longest_step, ..self }
    }

    /// Returns what its equations depend on beside its own entries.
    pub const fn reads(&self) -> Reads {
        self.reads
    }

    /// The same with equations that do not depend on the input: its steps may go beyond the tick.
    #[must_use]
    pub const fn of_state(self) -> Self {
        Self { reads: Reads::State, ..self }
    }

    /// Length (s) of the part's own step where the mode steps by `h` (s), and `rest` (s) of the
    /// tick is left: a multiple of `h`.
    #[inline]
    pub(crate) fn own_step(&self, h: f64, rest: f64) -> f64 {
        let known = match self.reads {
            Reads::State => f64::INFINITY,
            // The input is known to the end of the tick, and rounding is no step.
            Reads::StateAndInput => rest * (1.0 + 1e-9),
        };
        let most = self.longest_step.min(known) / h;
        h * math::floor(most.min(MOST_STEPS)).max(1.0)
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
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slow_part_steps_by_a_multiple_of_the_modes_step() {
        let part = Part::of(&[0]).with_longest_step(2.5e-3);
        let close =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-15, "{found}");
        close(part.of_state().own_step(1e-3, 1e-3), 2e-3);
        close(part.own_step(1e-3, 1e-3), 1e-3);
        close(part.own_step(1e-4, 1e-3), 3e-4);
        close(part.own_step(1e-4, 2e-4), 2e-4);
        close(part.own_step(4e-3, 1.0), 4e-3);
        close(Part::WHOLE.own_step(1e-3, 1.0), 1e-3);
    }
}
