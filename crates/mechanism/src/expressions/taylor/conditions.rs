//! Ends of a series that its coefficients do not show.

use super::writing::Writing;
use crate::expressions::graph::{BinaryFunction, UnaryFunction};
use crate::expressions::tape::{Instruction, TapeSlot};

/// Levels of the argument of functions of eˣ at which a series restarts.
///
/// Far from zero a softplus is a straight line to the last bit, and coefficients of any order do
/// not show the approaching corner. A step no longer than from one level to the next detects it, whatever its tolerance.
const LEVELS: [f64; 3] = [10.0, 20.0, 40.0];

impl Writing {
    /// Writes the values with zeros where `outputs` change their form.
    pub(super) fn conditions(&mut self, outputs: &[TapeSlot]) -> Vec<TapeSlot> {
        let (mut signs, mut corners) = (Vec::new(), Vec::new());
        let mut is_seen = vec![false; self.rules.len()];
        let mut waiting = outputs.to_vec();
        while let Some(slot) = waiting.pop() {
            if std::mem::replace(&mut is_seen[slot.index()], true) {
                continue;
            }
            let instruction = self.instructions[slot.index()];
            signs.extend(sign(&instruction).filter(|it| !self.is_constant(*it)));
            corners.extend(corner(&instruction).filter(|it| !self.is_constant(it.1)));
            instruction.operands(|it| waiting.push(it));
            self.rules[slot.index()].operands(|it| waiting.push(it));
        }
        corners.sort_unstable();
        for (times, x) in corners {
            signs.push(self.beyond(times, x));
        }
        signs.sort_unstable();
        signs.dedup();
        signs
    }

    /// Returns the excess of |x|, `times` times, over the next level below; 0 below all levels.
    fn beyond(&mut self, times: u8, x: TapeSlot) -> TapeSlot {
        let once = self.unary(UnaryFunction::Abs, x);
        let size = (1..times).fold(once, |size, _| self.add(size, once));
        let [mut level, higher @ ..] = LEVELS.map(|level| self.number(level));
        for next in higher {
            let above = self.subtract(size, next);
            level = self.choice([above, next, level]);
        }
        let (above, zero) = (self.subtract(size, level), self.number(0.0));
        self.binary(BinaryFunction::Max, above, zero)
    }
}

/// Returns the value with the zero at which an instruction changes its form.
fn sign(instruction: &Instruction) -> Option<TapeSlot> {
    if let Instruction::Select(condition, _, _) = *instruction {
        Some(condition)
    } else if let Instruction::Unary(UnaryFunction::Abs | UnaryFunction::Sign, x) = *instruction {
        Some(x)
    } else {
        None
    }
}

/// Returns the argument of a function that has a corner from afar, and its count in the exponent.
fn corner(instruction: &Instruction) -> Option<(u8, TapeSlot)> {
    use UnaryFunction as F;
    let Instruction::Unary(function, x) = *instruction else { return None };
    match function {
        F::Exp | F::Logistic | F::Softplus | F::SoftplusArea | F::SoftplusSquareArea => {
            Some((1, x))
        }
        F::Tanh => Some((2, x)),
        F::Sin | F::Cos | F::Asin | F::Acos | F::Ln | F::Sqrt | F::Abs | F::Sign => None,
    }
}
