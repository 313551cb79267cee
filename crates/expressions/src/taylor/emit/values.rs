//! Values as Rust: those at the start of a step, and the input.

use crate::graph::{BinaryFunction, UnaryFunction};
use crate::tape::{Argument, Instruction, TapeSlot};

/// The coefficient k of the input or a rate of it.
pub(super) fn input_of(rate: u8) -> String {
    let factors: Vec<_> = (1..=rate).map(|n| format!(" * (k + {n}) as f64 * per_scale")).collect();
    let factors = factors.concat();
    format!("s[k + {rate}].position{factors}").replace(" + 0", "")
}

/// A value at the start of a step.
pub(super) fn start_of(instruction: &Instruction) -> String {
    match *instruction {
        Instruction::Number(number) => format!("{number:?}_f64"),
        Instruction::Argument(Argument::Constant(index)) => format!("c[{index}]"),
        Instruction::Argument(Argument::State(index)) => format!("x[{index}]"),
        Instruction::Argument(Argument::Input(0)) => "s[0].position".into(),
        Instruction::Argument(Argument::Input(rate)) => {
            let factors: Vec<_> = (1..=rate).map(|n| format!(" * {n}.0 * per_scale")).collect();
            format!("s[{rate}].position{}", factors.concat())
        }
        // No derivative has any.
        Instruction::Argument(Argument::Extra(_)) => "f64::NAN".into(),
        Instruction::Add(x, y) => format!("v{} + v{}", x.0, y.0),
        Instruction::Subtract(x, y) => format!("v{} - v{}", x.0, y.0),
        Instruction::Multiply(x, y) => format!("v{} * v{}", x.0, y.0),
        Instruction::Divide(x, y) => format!("v{} / v{}", x.0, y.0),
        Instruction::Negate(x) => format!("-v{}", x.0),
        Instruction::Unary(function, x) => of_one(function, x),
        Instruction::Binary(function, x, y) => of_two(function, x, y),
        Instruction::Select(condition, x, y) => {
            format!("if v{} > 0.0 {{ v{} }} else {{ v{} }}", condition.0, x.0, y.0)
        }
    }
}

fn of_one(function: UnaryFunction, x: TapeSlot) -> String {
    let x = format!("v{}", x.0);
    match function {
        UnaryFunction::Sin => format!("math::sin({x})"),
        UnaryFunction::Cos => format!("math::cos({x})"),
        UnaryFunction::Tanh => format!("math::tanh({x})"),
        UnaryFunction::Exp => format!("math::exp({x})"),
        UnaryFunction::Ln => format!("math::ln({x})"),
        UnaryFunction::Sqrt => format!("math::sqrt({x})"),
        UnaryFunction::Abs => format!("{x}.abs()"),
        UnaryFunction::Sign => format!("functions::sign({x})"),
        UnaryFunction::Softplus => format!("functions::softplus({x})"),
        UnaryFunction::Logistic => format!("functions::logistic({x})"),
        UnaryFunction::SoftplusArea => format!("functions::softplus_area({x})"),
        UnaryFunction::SoftplusSquareArea => format!("functions::softplus_square_area({x})"),
        UnaryFunction::Asin => format!("{x}.asin()"),
        UnaryFunction::Acos => format!("{x}.acos()"),
    }
}

fn of_two(function: BinaryFunction, x: TapeSlot, y: TapeSlot) -> String {
    let (x, y) = (format!("v{}", x.0), format!("v{}", y.0));
    match function {
        BinaryFunction::Atan2 => format!("math::atan2({x}, {y})"),
        BinaryFunction::Hypot => format!("math::hypot({x}, {y})"),
        BinaryFunction::Power => format!("math::powf({x}, {y})"),
        BinaryFunction::Min => format!("{x}.min({y})"),
        BinaryFunction::Max => format!("{x}.max({y})"),
    }
}

/// Shows each operand of an instruction.
pub(super) fn operands(instruction: &Instruction, mut see: impl FnMut(TapeSlot)) {
    match *instruction {
        Instruction::Number(_) | Instruction::Argument(_) => {}
        Instruction::Negate(x) | Instruction::Unary(_, x) => see(x),
        Instruction::Add(x, y)
        | Instruction::Subtract(x, y)
        | Instruction::Multiply(x, y)
        | Instruction::Divide(x, y)
        | Instruction::Binary(_, x, y) => [x, y].into_iter().for_each(see),
        Instruction::Select(x, y, z) => [x, y, z].into_iter().for_each(see),
    }
}
