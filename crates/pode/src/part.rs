//! Independent parts of a mode's state that move by equations of their own.

use crate::guard::Reads;
use crate::math;
use crate::nature::Nature;

pub const MAX_PARTS: usize = 4;

/// Entries of the state whose derivatives depend on one another and the input only, not on other
/// entries that move by equations: an independent system within the mode.
///
/// `[GC93]` table 1 counts the degrees of freedom of each mode: hammer and key apart are two
/// systems of one, and a hammer slaved to the key is none.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Part {
    /// A bit for each entry of the state that belongs to the part.
    entries: u64,
    /// Nature of its equations; `None` for the mode's own.
    nature: Option<Nature>,
    /// Longest step (s) that resolves its motion; the mode's if that is longer.
    longest_step: f64,
    reads: Reads,
}

/// Maximum of mode steps in one step of a part. The part's dense output is then used inside its
/// step, where a method is less exact than at the end: three steps of the paper's hammer in flight
/// add 1 % to the error of its events' times, four add 2 %.
const MOST_STEPS: f64 = 3.0;

impl Part {
    pub const WHOLE: Self =
        Self { entries: u64::MAX, nature: None, longest_step: 0.0, reads: Reads::StateAndInput };

    /// Builds the part with the entries of the state at `indices`, each below 64.
    pub const fn of(indices: &[usize]) -> Self {
        let (mut entries, mut n) = (0, 0);
        while n < indices.len() {
            entries |= 1 << indices[n];
            n += 1;
        }
        Self { entries, ..Self::WHOLE }
    }

    #[inline]
    pub(crate) fn union(parts: &[Self], length: usize) -> Self {
        let entries = parts.iter().fold(0, |sum, part| sum | part.entries);
        let union = Self { entries, ..Self::WHOLE };
        if union.count(length) as usize == length { Self::WHOLE } else { union }
    }

    /// Returns the part with equations of another nature than the mode as a whole.
    #[must_use]
    pub const fn with_nature(self, nature: Nature) -> Self {
        Self { nature: Some(nature), ..self }
    }

    /// Returns the part with its own longest step (s), possibly several of the mode's steps.
    #[must_use]
    pub const fn with_longest_step(self, longest_step: f64) -> Self {
        Self { longest_step, ..self }
    }

    pub const fn reads(&self) -> Reads {
        self.reads
    }

    /// Returns the part with equations independent of the input: its steps may go beyond the tick.
    #[must_use]
    pub const fn of_state(self) -> Self {
        Self { reads: Reads::State, ..self }
    }

    /// Returns the length (s) of the part's step, a multiple of `h` (s) up to `longest` (s), with
    /// `rest` (s) left.
    #[inline]
    pub(crate) fn own_step(&self, h: f64, rest: f64, longest: f64) -> f64 {
        let known = match self.reads {
            Reads::State => f64::INFINITY,
            // The input is known to the end of the tick, and rounding is no step.
            Reads::StateAndInput => rest * (1.0 + 1e-9),
        };
        let most = self.longest_step.min(known).min(longest) / h;
        h * math::floor(most.min(MOST_STEPS)).max(1.0)
    }

    /// Returns the nature of its equations in a mode of the nature `whole`.
    #[inline]
    pub(crate) const fn nature(&self, whole: Nature) -> Nature {
        match self.nature {
            Some(nature) => nature,
            None => whole,
        }
    }

    #[inline]
    pub const fn has(&self, index: usize) -> bool {
        // An entry beyond the bits belongs to the whole only.
        if index < 64 { self.entries >> index & 1 == 1 } else { self.entries == u64::MAX }
    }

    #[inline]
    pub(crate) const fn is_whole(&self) -> bool {
        self.entries == u64::MAX
    }

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
        close(part.of_state().own_step(1e-3, 1e-3, f64::INFINITY), 2e-3);
        close(part.own_step(1e-3, 1e-3, f64::INFINITY), 1e-3);
        close(part.own_step(1e-4, 1e-3, f64::INFINITY), 3e-4);
        close(part.own_step(1e-4, 2e-4, f64::INFINITY), 2e-4);
        close(part.own_step(1e-4, 1e-3, 2.5e-4), 2e-4);
        close(part.own_step(1e-4, 1e-3, 1e-4), 1e-4);
        close(part.own_step(4e-3, 1.0, f64::INFINITY), 4e-3);
        close(Part::WHOLE.own_step(1e-3, 1.0, f64::INFINITY), 1e-3);
    }
}
