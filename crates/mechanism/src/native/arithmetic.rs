//! Operations without a call: comparisons, magnitudes, roots.

use crate::expressions::graph::{BinaryFunction, UnaryFunction};
use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::{InstBuilder as _, Value};
use cranelift_frontend::FunctionBuilder;

pub(crate) fn select(
    builder: &mut FunctionBuilder<'_>,
    condition: Value,
    positive: Value,
    other: Value,
) -> Value {
    let zero = builder.ins().f64const(0.0);
    let is_positive = builder.ins().fcmp(FloatCC::GreaterThan, condition, zero);
    builder.ins().select(is_positive, positive, other)
}

pub(crate) fn unary(builder: &mut FunctionBuilder<'_>, function: UnaryFunction, x: Value) -> Value {
    match function {
        UnaryFunction::Abs => builder.ins().fabs(x),
        UnaryFunction::Sqrt => builder.ins().sqrt(x),
        UnaryFunction::Sign => {
            let (zero, one) = (builder.ins().f64const(0.0), builder.ins().f64const(1.0));
            let minus_one = builder.ins().f64const(-1.0);
            let is_below = builder.ins().fcmp(FloatCC::LessThan, x, zero);
            let below = builder.ins().select(is_below, minus_one, x);
            let is_above = builder.ins().fcmp(FloatCC::GreaterThan, x, zero);
            builder.ins().select(is_above, one, below)
        }
        UnaryFunction::Sin
        | UnaryFunction::Cos
        | UnaryFunction::Tanh
        | UnaryFunction::Exp
        | UnaryFunction::Ln
        | UnaryFunction::Softplus
        | UnaryFunction::Logistic
        | UnaryFunction::SoftplusArea
        | UnaryFunction::SoftplusSquareArea
        | UnaryFunction::Asin
        | UnaryFunction::Acos => builder.ins().f64const(f64::NAN),
    }
}

/// Writes `smaller` or `larger` of `instruments::equations::functions` without a call.
pub(crate) fn binary(
    builder: &mut FunctionBuilder<'_>,
    function: BinaryFunction,
    x: Value,
    y: Value,
) -> Value {
    let is_y = match function {
        BinaryFunction::Min => builder.ins().fcmp(FloatCC::LessThan, y, x),
        BinaryFunction::Max => builder.ins().fcmp(FloatCC::GreaterThan, y, x),
        BinaryFunction::Atan2 | BinaryFunction::Hypot | BinaryFunction::Power => {
            return builder.ins().f64const(f64::NAN);
        }
    };
    builder.ins().select(is_y, y, x)
}
