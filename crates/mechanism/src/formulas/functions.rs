use crate::expressions::graph::{BinaryFunction, Graph, Node, UnaryFunction};

use super::composed;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum UnitRule {
    /// Ratio or angle in, ratio out.
    Ratio,
    Same,
    ToRatio,
    Root,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Function {
    Unary(UnaryFunction, UnitRule),
    Binary(BinaryFunction, UnitRule),
    /// Composed of other functions; a ratio or an angle in, a ratio out.
    Composed(fn(&mut Graph, Node) -> Node),
    /// Function of ratios that are constant numbers.
    OfNumber(fn(f64) -> f64),
    If,
    Rate,
    Named(usize),
}

const ALL: [(&str, Function); 44] = [
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
    ("friction", Function::Named(1)),
    ("reaction", Function::Named(1)),
];

pub const FUNCTIONS: [&str; ALL.len()] = {
    let mut names = [""; ALL.len()];
    let mut index = 0;
    while index < ALL.len() {
        names[index] = ALL[index].0;
        index += 1;
    }
    names
};

pub(super) fn function(name: &str) -> Option<Function> {
    ALL.iter().find(|(known, _)| *known == name).map(|(_, function)| *function)
}

impl Function {
    pub(super) const fn arguments(self) -> usize {
        match self {
            Self::Unary(..) | Self::Composed(_) | Self::OfNumber(_) | Self::Rate => 1,
            Self::Binary(..) => 2,
            Self::If => 3,
            Self::Named(count) => count,
        }
    }
}
