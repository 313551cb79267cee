//! Random expressions, evaluated by recursion with a bound of their rounding errors.

pub mod lever;

use mechanism::expressions::graph::{BinaryFunction, Graph, Node, Place, UnaryFunction};
use mechanism::expressions::tape::{Argument, ArgumentLayout};
use proptest::prelude::*;

/// Symbols of random expressions, in the order of their values.
pub const SYMBOLS: [Place; 6] = [
    Place::Parameter(0),
    Place::Parameter(1),
    Place::Coordinate(0),
    Place::Coordinate(1),
    Place::Speed(0),
    Place::Input(1),
];

/// Arguments of the symbols: two constants, three of the state, the input's rate.
pub fn layout() -> ArgumentLayout {
    let mut layout = ArgumentLayout::default();
    let arguments = [
        Argument::Constant(0),
        Argument::Constant(1),
        Argument::State(0),
        Argument::State(1),
        Argument::State(2),
        Argument::Input(1),
    ];
    for (place, argument) in SYMBOLS.into_iter().zip(arguments) {
        layout.place(place, argument);
    }
    layout
}

#[derive(Clone, Debug)]
pub enum Tree {
    Number(f64),
    Symbol(usize),
    Sum(Vec<(Self, f64)>),
    Product(Vec<(Self, i32)>),
    Unary(UnaryFunction, Box<Self>),
    Binary(BinaryFunction, Box<Self>, Box<Self>),
    Select(Box<[Self; 3]>),
}

pub const UNARY: [UnaryFunction; 14] = [
    UnaryFunction::Sin,
    UnaryFunction::Cos,
    UnaryFunction::Tanh,
    UnaryFunction::Exp,
    UnaryFunction::Ln,
    UnaryFunction::Sqrt,
    UnaryFunction::Abs,
    UnaryFunction::Sign,
    UnaryFunction::Softplus,
    UnaryFunction::Logistic,
    UnaryFunction::SoftplusArea,
    UnaryFunction::SoftplusSquareArea,
    UnaryFunction::Asin,
    UnaryFunction::Acos,
];

pub const BINARY: [BinaryFunction; 5] = [
    BinaryFunction::Atan2,
    BinaryFunction::Hypot,
    BinaryFunction::Power,
    BinaryFunction::Min,
    BinaryFunction::Max,
];

pub fn trees() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        1 => prop::sample::select(vec![0.0, 1.0, -1.0, 0.5, 2.0, -3.0, 1.25, 0.1])
            .prop_map(Tree::Number),
        4 => (0..SYMBOLS.len()).prop_map(Tree::Symbol),
    ];
    leaf.prop_recursive(6, 48, 4, |inner| {
        let factor = prop::sample::select(vec![1.0, -1.0, 0.5, -2.0, 3.5]);
        let exponent = prop::sample::select(vec![1, 1, 1, 2, 3, -1, -2]);
        let boxed = inner.clone().prop_map(Box::new);
        prop_oneof![
            4 => prop::collection::vec((inner.clone(), factor), 1..5).prop_map(Tree::Sum),
            4 => prop::collection::vec((inner.clone(), exponent), 1..4).prop_map(Tree::Product),
            3 => (prop::sample::select(UNARY.to_vec()), boxed.clone())
                .prop_map(|(function, x)| Tree::Unary(function, x)),
            1 => (prop::sample::select(BINARY.to_vec()), boxed.clone(), boxed)
                .prop_map(|(function, x, y)| Tree::Binary(function, x, y)),
            1 => [inner.clone(), inner.clone(), inner]
                .prop_map(|all| Tree::Select(Box::new(all))),
        ]
    })
}

pub fn values() -> impl Strategy<Value = [f64; 6]> {
    prop::array::uniform6(prop_oneof![-2.0..2.0, prop::sample::select(vec![0.0, -0.0, 1.0, -1.0])])
}

impl Tree {
    pub fn build(&self, graph: &mut Graph) -> Node {
        match self {
            Self::Number(value) => graph.constant(*value),
            Self::Symbol(at) => graph.symbol(SYMBOLS[*at]),
            Self::Sum(terms) => {
                let terms: Vec<_> = terms.iter().map(|(it, by)| (it.build(graph), *by)).collect();
                graph.sum(&terms)
            }
            Self::Product(factors) => {
                let factors: Vec<_> =
                    factors.iter().map(|(it, by)| (it.build(graph), *by)).collect();
                graph.product(&factors)
            }
            Self::Unary(function, x) => {
                let x = x.build(graph);
                graph.unary(*function, x)
            }
            Self::Binary(function, x, y) => {
                let (x, y) = (x.build(graph), y.build(graph));
                graph.binary(*function, x, y)
            }
            Self::Select(all) => {
                let [condition, positive, other] = [0, 1, 2].map(|at| all[at].build(graph));
                graph.select(condition, positive, other)
            }
        }
    }

    /// Evaluates by recursion; `None` where the value is extreme, or decided by rounding.
    pub fn evaluate(&self, symbols: &[f64; 6]) -> Option<Bounded> {
        match self {
            Self::Number(value) => Some(Bounded { value: *value, error: 0.0 }),
            Self::Symbol(at) => Some(Bounded { value: symbols[*at], error: 0.0 }),
            Self::Sum(terms) => {
                let (mut value, mut error, mut size) = (0.0, 0.0, 0.0);
                for (term, factor) in terms {
                    let term = term.evaluate(symbols)?;
                    value += factor * term.value;
                    error += (factor * term.error).abs();
                    size += (factor * term.value).abs();
                }
                Bounded { value, error: error + 8.0 * f64::EPSILON * size }.tame()
            }
            Self::Product(factors) => {
                let (mut value, mut relative) = (1.0, 8.0 * f64::EPSILON);
                for (factor, exponent) in factors {
                    // Near zero neither a division nor a relative error is meaningful.
                    let factor = factor.evaluate(symbols).filter(|it| it.value.abs() >= 1e-6)?;
                    value *= factor.value.powi(*exponent);
                    let each = factor.error / factor.value.abs() + 4.0 * f64::EPSILON;
                    relative += f64::from(exponent.abs()) * each;
                }
                Bounded { value, error: value.abs() * relative }.tame()
            }
            Self::Unary(function, x) => {
                let x = x.evaluate(symbols)?;
                if *function == UnaryFunction::Sign && !x.is_certain() {
                    return None;
                }
                x.through(|x| function.of(x))
            }
            Self::Binary(function, x, y) => {
                let (x, y) = (x.evaluate(symbols)?, y.evaluate(symbols)?);
                // On the negative axis the angle has the sign of a zero, which sums do not keep.
                if *function == BinaryFunction::Atan2 && x.value == 0.0 && y.value <= 0.0 {
                    return None;
                }
                let by_x = x.through(|x| function.of(x, y.value))?;
                let by_y = y.through(|y| function.of(x.value, y))?;
                Bounded { value: by_x.value, error: by_x.error + by_y.error }.tame()
            }
            Self::Select(all) => {
                let condition = all[0].evaluate(symbols)?;
                // Evaluation without branches computes both, so both must be tame.
                let (positive, other) = (all[1].evaluate(symbols)?, all[2].evaluate(symbols)?);
                condition.is_certain().then_some(if condition.value > 0.0 {
                    positive
                } else {
                    other
                })
            }
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    pub value: f64,
    pub error: f64,
}

impl Bounded {
    fn tame(self) -> Option<Self> {
        (self.value.abs() < 1e9 && self.error < 1e-6).then_some(self)
    }

    /// Returns `true` if the error cannot change the sign; an exact zero has one.
    fn is_certain(self) -> bool {
        self.error == 0.0 || self.value.abs() > 2.0 * self.error
    }

    /// Returns the value of a function; its slope is estimated at both ends of the error.
    fn through(self, function: impl Fn(f64) -> f64) -> Option<Self> {
        let value = function(self.value);
        // The error is widened, so that its ends show a slope and not only rounding.
        let wide = 1e3 * self.error.max(f64::EPSILON * self.value.abs());
        let ends = [self.value - wide, self.value + wide].map(function);
        let spread = ends.iter().map(|end| (end - value).abs()).fold(0.0, nan_or_larger);
        Self { value, error: spread + 8.0 * f64::EPSILON * value.abs() }.tame()
    }
}

/// Returns the larger value; `f64::max` would hide NaN.
fn nan_or_larger(x: f64, y: f64) -> f64 {
    if x.is_nan() || y.is_nan() { f64::NAN } else { x.max(y) }
}
