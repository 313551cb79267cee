//! Writes a tape again, each value with its rule.

use super::rules::SeriesRule;
use crate::expressions::graph::UnaryFunction;
use crate::expressions::tape::{Argument, Instruction, TapeSlot};

#[derive(Default)]
pub(super) struct Writing {
    pub(super) instructions: Vec<Instruction>,
    pub(super) rules: Vec<SeriesRule>,
    /// Slots of the values of the given tape.
    pub(super) places: Vec<TapeSlot>,
}

impl Writing {
    pub(super) fn push(&mut self, instruction: Instruction, rule: SeriesRule) -> TapeSlot {
        let known = self.instructions.iter().zip(&self.rules);
        if let Some(at) = known.into_iter().position(|it| it == (&instruction, &rule)) {
            return slot_of(at);
        }
        self.instructions.push(instruction);
        self.rules.push(rule);
        slot_of(self.rules.len() - 1)
    }

    pub(super) fn is_constant(&self, slot: TapeSlot) -> bool {
        self.rules[slot.index()] == SeriesRule::Constant
    }

    pub(super) fn number(&mut self, value: f64) -> TapeSlot {
        self.push(Instruction::Number(value), SeriesRule::Constant)
    }

    pub(super) fn instruction(&mut self, given: Instruction) -> TapeSlot {
        let at = |slot: TapeSlot| self.places[slot.index()];
        match given {
            Instruction::Number(_) => self.push(given, SeriesRule::Constant),
            Instruction::Argument(argument) => self.push(given, of_argument(argument)),
            Instruction::Add(x, y) => self.add(at(x), at(y)),
            Instruction::Subtract(x, y) => self.subtract(at(x), at(y)),
            Instruction::Negate(x) => {
                let x = at(x);
                self.unless_constant(&[x], Instruction::Negate(x), SeriesRule::Negate(x))
            }
            Instruction::Multiply(x, y) => self.multiply(at(x), at(y)),
            Instruction::Divide(x, y) => self.divide(at(x), at(y)),
            Instruction::Unary(function, x) => self.unary(function, at(x)),
            Instruction::Binary(function, x, y) => self.binary(function, at(x), at(y)),
            Instruction::Select(condition, x, y) => self.choice([condition, x, y].map(at)),
        }
    }

    pub(super) fn unless_constant(
        &mut self,
        operands: &[TapeSlot],
        value: Instruction,
        rule: SeriesRule,
    ) -> TapeSlot {
        let is_constant = operands.iter().all(|slot| self.is_constant(*slot));
        self.push(value, if is_constant { SeriesRule::Constant } else { rule })
    }

    pub(super) fn add(&mut self, x: TapeSlot, y: TapeSlot) -> TapeSlot {
        self.unless_constant(&[x, y], Instruction::Add(x, y), SeriesRule::Add(x, y))
    }

    pub(super) fn subtract(&mut self, x: TapeSlot, y: TapeSlot) -> TapeSlot {
        self.unless_constant(&[x, y], Instruction::Subtract(x, y), SeriesRule::Subtract(x, y))
    }

    pub(super) fn multiply(&mut self, x: TapeSlot, y: TapeSlot) -> TapeSlot {
        let rule = match (self.is_constant(x), self.is_constant(y)) {
            (true, true) => SeriesRule::Constant,
            (true, false) => SeriesRule::Scale(x, y),
            (false, true) => SeriesRule::Scale(y, x),
            (false, false) if x == y => SeriesRule::Square(x),
            (false, false) => SeriesRule::Product(x, y),
        };
        self.push(Instruction::Multiply(x, y), rule)
    }

    pub(super) fn divide(&mut self, x: TapeSlot, y: TapeSlot) -> TapeSlot {
        let rule =
            if self.is_constant(y) { SeriesRule::Over(x, y) } else { SeriesRule::Quotient(x, y) };
        self.unless_constant(&[x, y], Instruction::Divide(x, y), rule)
    }

    pub(super) fn one_less_square(&mut self, x: TapeSlot) -> TapeSlot {
        let (one, square) = (self.number(1.0), self.multiply(x, x));
        self.subtract(one, square)
    }

    pub(super) fn root(&mut self, x: TapeSlot) -> TapeSlot {
        let value = Instruction::Unary(UnaryFunction::Sqrt, x);
        self.unless_constant(&[x], value, SeriesRule::Root(x))
    }

    /// Returns the slot `ahead` of the next, for a slope that is written after its function.
    pub(super) fn next(&self, ahead: usize) -> TapeSlot {
        slot_of(self.rules.len() + ahead)
    }

    pub(super) fn driven(
        &mut self,
        function: UnaryFunction,
        x: TapeSlot,
        slope: TapeSlot,
    ) -> TapeSlot {
        self.push(Instruction::Unary(function, x), SeriesRule::Driven { slope, of: x })
    }
}

const fn of_argument(argument: Argument) -> SeriesRule {
    match argument {
        Argument::State(index) => SeriesRule::State(index),
        Argument::Input(index) => SeriesRule::Input(index),
        Argument::Constant(_) | Argument::Extra(_) => SeriesRule::Constant,
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a tape is shorter than 2³² instructions")]
pub(super) const fn slot_of(index: usize) -> TapeSlot {
    TapeSlot(index as u32)
}
