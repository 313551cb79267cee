//! From a tape to the recursion of its coefficients.

use super::rules::SeriesRule;
use super::writing::Writing;
use crate::expressions::tape::{Tape, TapeSlot};

/// A tape with a rule for each of its values.
///
/// Where a function's slope is not there yet, the tape is made longer: that of tanh is 1 − tanh².
#[derive(Clone, PartialEq, Debug)]
pub struct Recursion {
    /// Values at the start; the outputs are the derivative's entries, and the guards.
    pub tape: Tape,
    /// How each value goes on.
    pub rules: Vec<SeriesRule>,
    /// How many outputs are entries of the derivative; those after them are guards.
    pub entries: usize,
    /// The values at whose zeros the series ends: what decides a choice, or is near a corner.
    pub conditions: Vec<TapeSlot>,
}

impl Recursion {
    /// Returns the recursion of a `tape` whose first `entries` outputs are the derivative.
    pub fn new(tape: &Tape, entries: usize) -> Self {
        let mut writing = Writing::default();
        for instruction in &tape.instructions {
            let slot = writing.instruction(*instruction);
            writing.places.push(slot);
        }
        let outputs: Vec<_> = tape.outputs.iter().map(|it| writing.places[it.index()]).collect();
        let entries = entries.min(outputs.len());
        let conditions = writing.conditions(&outputs);
        let tape = Tape { instructions: writing.instructions, outputs };
        Self { tape, rules: writing.rules, entries, conditions }
    }

    /// Returns whether the value at `slot` stays as it is.
    pub fn is_constant(&self, slot: TapeSlot) -> bool {
        self.rules[slot.index()] == SeriesRule::Constant
    }

    /// The slots whose coefficients `outputs` depend on, in order.
    pub(super) fn live(&self, outputs: &[TapeSlot]) -> Vec<bool> {
        let mut is_live = vec![false; self.rules.len()];
        let mut waiting = outputs.to_vec();
        while let Some(slot) = waiting.pop() {
            if self.is_constant(slot) || std::mem::replace(&mut is_live[slot.index()], true) {
                continue;
            }
            self.rules[slot.index()].operands(|operand| waiting.push(self.slope_or(slot, operand)));
        }
        is_live
    }

    /// The operand itself, or the slot whose row stands for it where it is only a slope.
    fn slope_or(&self, of: TapeSlot, operand: TapeSlot) -> TapeSlot {
        let SeriesRule::Driven { slope, .. } = self.rules[of.index()] else { return operand };
        if slope == operand { self.slope(slope).0 } else { operand }
    }

    /// Returns the slots of the derivative's entries, and those of the guards.
    pub fn outputs(&self) -> (&[TapeSlot], &[TapeSlot]) {
        self.tape.outputs.split_at(self.entries)
    }

    /// The row of a slope, and whether it counts with the opposite sign.
    pub(super) fn slope(&self, slope: TapeSlot) -> (TapeSlot, bool) {
        let SeriesRule::Negate(positive) = self.rules[slope.index()] else { return (slope, false) };
        (positive, true)
    }
}
