use super::rules::SeriesRule;
use super::writing::Writing;
use crate::expressions::tape::{Tape, TapeSlot};

/// Tape with a recursion rule for the coefficients of each of its values.
///
/// Where a function's slope is missing, the tape is extended: that of tanh is 1 − tanh².
#[derive(Clone, PartialEq, Debug)]
pub struct Recursion {
    /// Values at the start; the outputs are the derivative's entries, and the guards.
    pub tape: Tape,
    pub rules: Vec<SeriesRule>,
    /// Number of outputs that are entries of the derivative; the others are guards.
    pub entries: usize,
    /// Values with zeros at which the series ends: those that decide a choice or are near a corner.
    pub conditions: Vec<TapeSlot>,
}

impl Recursion {
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

    pub fn is_constant(&self, slot: TapeSlot) -> bool {
        self.rules[slot.index()] == SeriesRule::Constant
    }

    /// Returns a flag per slot: `true` if the coefficients of `outputs` depend on it.
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

    /// Returns the operand, or the slot of the row that replaces it where it is only a slope.
    fn slope_or(&self, of: TapeSlot, operand: TapeSlot) -> TapeSlot {
        let SeriesRule::Driven { slope, .. } = self.rules[of.index()] else { return operand };
        if slope == operand { self.slope(slope).0 } else { operand }
    }

    /// Returns the slots of the derivative's entries, and those of the guards.
    pub fn outputs(&self) -> (&[TapeSlot], &[TapeSlot]) {
        self.tape.outputs.split_at(self.entries)
    }

    /// Returns the row of a slope, and `true` if it counts with the opposite sign.
    pub(super) fn slope(&self, slope: TapeSlot) -> (TapeSlot, bool) {
        let SeriesRule::Negate(positive) = self.rules[slope.index()] else { return (slope, false) };
        (positive, true)
    }
}
