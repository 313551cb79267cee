//! The functions that an expression can name.

use crate::expressions::graph::{BinaryFunction, Graph, Node, UnaryFunction};

use super::composed;

/// What a function asks of its arguments' units, and what comes out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum UnitRule {
    /// A ratio or an angle in, a ratio out.
    Ratio,
    /// What goes in comes out.
    Same,
    /// Anything in, a ratio out.
    ToRatio,
    /// The root of what goes in.
    Root,
}

/// A function of an expression.
#[derive(Clone, Copy, Debug)]
pub(super) enum Function {
    Unary(UnaryFunction, UnitRule),
    Binary(BinaryFunction, UnitRule),
    /// Built from other functions; a ratio or an angle in, a ratio out.
    Composed(fn(&mut Graph, Node) -> Node),
    /// Of ratios that are numbers, and depend on nothing.
    OfNumber(fn(f64) -> f64),
    /// A choice between two values.
    If,
    /// The total rate along the motion.
    Rate,
    /// Of things that have names: how many.
    Named(usize),
}

/// Every function with its name.
const ALL: [(&str, Function); 43] = [
    ("sin", Function::Unary(UnaryFunction::Sin, UnitRule::Ratio)),
    ("cos", Function::Unary(UnaryFunction::Cos, UnitRule::Ratio)),
    ("tan", Function::Composed(composed::tan)),
    ("asin", Function::Unary(UnaryFunction::Asin, UnitRule::Ratio)),
    ("acos", Function::Unary(UnaryFunction::Acos, UnitRule::Ratio)),
    ("atan", Function::Composed(composed::atan)),
    ("atan2", Function::Binary(BinaryFunction::Atan2, UnitRule::ToRatio)),
    ("hypot", Function::Binary(BinaryFunction::Hypot, UnitRule::Same)),
    ("sqrt", Function::Unary(UnaryFunction::Sqrt, UnitRule::Root)),
    ("exp", Function::Unary(UnaryFunction::Exp, UnitRule::Ratio)),
    ("ln", Function::Unary(UnaryFunction::Ln, UnitRule::Ratio)),
    ("log", Function::Unary(UnaryFunction::Ln, UnitRule::Ratio)),
    ("log2", Function::Composed(composed::log2)),
    ("log10", Function::Composed(composed::log10)),
    ("sinh", Function::Composed(composed::sinh)),
    ("cosh", Function::Composed(composed::cosh)),
    ("tanh", Function::Unary(UnaryFunction::Tanh, UnitRule::Ratio)),
    ("asinh", Function::Composed(composed::asinh)),
    ("acosh", Function::Composed(composed::acosh)),
    ("atanh", Function::Composed(composed::atanh)),
    ("abs", Function::Unary(UnaryFunction::Abs, UnitRule::Same)),
    ("sign", Function::Unary(UnaryFunction::Sign, UnitRule::ToRatio)),
    ("min", Function::Binary(BinaryFunction::Min, UnitRule::Same)),
    ("max", Function::Binary(BinaryFunction::Max, UnitRule::Same)),
    ("softplus", Function::Unary(UnaryFunction::Softplus, UnitRule::Ratio)),
    ("logistic", Function::Unary(UnaryFunction::Logistic, UnitRule::Ratio)),
    ("softplus_area", Function::Unary(UnaryFunction::SoftplusArea, UnitRule::Ratio)),
    ("softplus_square_area", Function::Unary(UnaryFunction::SoftplusSquareArea, UnitRule::Ratio)),
    ("cbrt", Function::OfNumber(f64::cbrt)),
    ("signum", Function::OfNumber(f64::signum)),
    ("floor", Function::OfNumber(f64::floor)),
    ("ceil", Function::OfNumber(f64::ceil)),
    ("round", Function::OfNumber(f64::round)),
    ("trunc", Function::OfNumber(f64::trunc)),
    ("fract", Function::OfNumber(f64::fract)),
    ("if", Function::If),
    ("rate", Function::Rate),
    ("x", Function::Named(1)),
    ("y", Function::Named(1)),
    ("z", Function::Named(1)),
    ("distance", Function::Named(2)),
    ("force", Function::Named(1)),
    ("reaction", Function::Named(1)),
];

/// The names of all functions.
pub const FUNCTIONS: [&str; ALL.len()] = {
    let mut names = [""; ALL.len()];
    let mut index = 0;
    while index < ALL.len() {
        names[index] = ALL[index].0;
        index += 1;
    }
    names
};

/// Returns the function called `name`.
pub(super) fn function(name: &str) -> Option<Function> {
    ALL.iter().find(|(known, _)| *known == name).map(|(_, function)| *function)
}

impl Function {
    /// Returns how many arguments it takes.
    pub(super) const fn arguments(self) -> usize {
        match self {
            Self::Unary(..) | Self::Composed(_) | Self::OfNumber(_) | Self::Rate => 1,
            Self::Binary(..) => 2,
            Self::If => 3,
            Self::Named(count) => count,
        }
    }
}
