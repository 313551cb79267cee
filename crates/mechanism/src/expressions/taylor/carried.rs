use crate::expressions::graph::UnaryFunction;
use crate::expressions::tape::{Argument, Instruction, TapeSlot, TapeWriter};

/// Value that the start of a series passes to its steps.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum CarriedValue {
    Value(TapeSlot),
    Twice(TapeSlot),
    Sign(TapeSlot),
    Over(f64, TapeSlot),
}

impl CarriedValue {
    pub(super) const fn slot(self) -> TapeSlot {
        match self {
            Self::Value(slot) | Self::Twice(slot) | Self::Sign(slot) | Self::Over(_, slot) => slot,
        }
    }
}

pub(super) fn write(writer: &mut TapeWriter, carried: CarriedValue, x: TapeSlot) -> TapeSlot {
    match carried {
        CarriedValue::Value(_) => x,
        CarriedValue::Twice(_) => writer.push(Instruction::Add(x, x)),
        CarriedValue::Sign(_) => writer.push(Instruction::Unary(UnaryFunction::Sign, x)),
        CarriedValue::Over(number, _) => {
            let number = writer.number(number);
            writer.push(Instruction::Divide(number, x))
        }
    }
}

pub(super) fn extra(at: usize) -> Instruction {
    Instruction::Argument(Argument::Extra(u16::try_from(at).unwrap_or(u16::MAX)))
}
