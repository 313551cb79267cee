//! The operators of an expression, for ranges.

use exmex::{BinOp, MakeOperators, Operator};

use super::Interval;

/// All operators that exmex can derive, and those that a constant may be made with.
#[derive(Clone, Debug)]
pub(in super::super) struct IntervalOperators;

type Unary = (&'static str, fn(Interval) -> Interval);

/// Functions whose derivatives exmex knows.
const SMOOTH: [Unary; 18] = [
    ("sqrt", Interval::sqrt),
    ("exp", Interval::exp),
    ("ln", |x| x.log(f64::ln)),
    ("log", |x| x.log(f64::ln)),
    ("log2", |x| x.log(f64::log2)),
    ("log10", |x| x.log(f64::log10)),
    ("sin", Interval::sin),
    ("cos", Interval::cos),
    ("tan", Interval::tan),
    ("asin", Interval::asin),
    ("acos", Interval::acos),
    ("atan", |x| x.rising(f64::atan)),
    ("sinh", |x| x.rising(f64::sinh)),
    ("cosh", Interval::cosh),
    ("tanh", Interval::tanh),
    ("asinh", |x| x.rising(f64::asinh)),
    ("acosh", Interval::acosh),
    ("atanh", Interval::atanh),
];

/// Functions that have kinks or jumps: of constants only.
const OF_CONSTANTS: [Unary; 8] = [
    ("abs", |x| x.at_point(f64::abs)),
    ("cbrt", |x| x.at_point(f64::cbrt)),
    ("signum", |x| x.at_point(f64::signum)),
    ("floor", |x| x.at_point(f64::floor)),
    ("ceil", |x| x.at_point(f64::ceil)),
    ("round", |x| x.at_point(f64::round)),
    ("trunc", |x| x.at_point(f64::trunc)),
    ("fract", |x| x.at_point(f64::fract)),
];

const CONSTANTS: [(&str, f64); 3] =
    [("PI", std::f64::consts::PI), ("TAU", std::f64::consts::TAU), ("E", std::f64::consts::E)];

impl MakeOperators<Interval> for IntervalOperators {
    /// With the ranks that exmex gives them for numbers.
    fn make<'a>() -> Vec<Operator<'a, Interval>> {
        let binary = |apply, prio, is_commutative| BinOp { apply, prio, is_commutative };
        let mut operators = vec![
            Operator::make_bin("^", binary(Interval::power, 4, false)),
            Operator::make_bin("*", binary(|a, b| a * b, 2, true)),
            Operator::make_bin("/", binary(|a, b| a / b, 3, false)),
            Operator::make_bin_unary("+", binary(|a, b| a + b, 0, true), |a| a),
            Operator::make_bin_unary("-", binary(|a, b| a - b, 1, false), |a| -a),
        ];
        let functions = SMOOTH.into_iter().chain(OF_CONSTANTS);
        operators.extend(functions.map(|(name, apply)| Operator::make_unary(name, apply)));
        let constants = CONSTANTS.into_iter();
        operators.extend(
            constants.map(|(name, value)| Operator::make_constant(name, Interval::point(value))),
        );
        operators
    }
}
