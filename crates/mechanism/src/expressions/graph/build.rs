//! Builds nodes, simplified at once where possible.

use super::{BinaryFunction, Graph, Node, NodeOperation, Place, UnaryFunction, order};

impl Graph {
    pub fn constant(&mut self, value: f64) -> Node {
        // A single zero: −0 would be another node.
        self.intern(NodeOperation::Number((value + 0.0).to_bits()))
    }

    pub fn symbol(&mut self, place: Place) -> Node {
        self.intern(NodeOperation::Symbol(place))
    }

    pub fn add(&mut self, x: Node, y: Node) -> Node {
        self.sum(&[(x, 1.0), (y, 1.0)])
    }

    pub fn subtract(&mut self, x: Node, y: Node) -> Node {
        self.sum(&[(x, 1.0), (y, -1.0)])
    }

    pub fn negate(&mut self, x: Node) -> Node {
        self.sum(&[(x, -1.0)])
    }

    pub fn scale(&mut self, x: Node, factor: f64) -> Node {
        self.sum(&[(x, factor)])
    }

    pub fn sum(&mut self, terms: &[(Node, f64)]) -> Node {
        if self.given_up().is_some() {
            return self.constant(0.0);
        }
        let mut collected = order::Sum::default();
        for (node, factor) in terms {
            collected.add(self, *node, *factor);
        }
        let (number, mut terms) = collected.finish();
        self.collect_squares(number, &mut terms)
    }

    pub(super) fn sum_in_order(&mut self, number: f64, terms: &[(Node, f64)]) -> Node {
        match terms {
            [] => self.constant(number),
            [(only, 1.0)] if number == 0.0 => *only,
            _ => {
                let terms = terms.iter().map(|(node, factor)| (*node, factor.to_bits())).collect();
                self.intern(NodeOperation::Sum((number + 0.0).to_bits(), terms))
            }
        }
    }

    pub fn multiply(&mut self, x: Node, y: Node) -> Node {
        self.product(&[(x, 1), (y, 1)])
    }

    pub fn divide(&mut self, x: Node, y: Node) -> Node {
        self.product(&[(x, 1), (y, -1)])
    }

    pub fn power(&mut self, x: Node, exponent: i32) -> Node {
        self.product(&[(x, exponent)])
    }

    pub fn product(&mut self, factors: &[(Node, i32)]) -> Node {
        if self.given_up().is_some() {
            return self.constant(0.0);
        }
        let mut collected = order::Product::new();
        for (node, exponent) in factors {
            collected.multiply(self, *node, *exponent);
        }
        let (number, factors) = collected.finish();
        if number == 0.0 {
            return self.constant(0.0);
        }
        let product = match factors.as_slice() {
            [] => return self.constant(number),
            [(only, 1)] => *only,
            _ => self.intern(NodeOperation::Product(factors.into_boxed_slice())),
        };
        if number.to_bits() == 1.0_f64.to_bits() { product } else { self.sum(&[(product, number)]) }
    }

    pub fn unary(&mut self, function: UnaryFunction, x: Node) -> Node {
        if let Some(number) = self.number(x) {
            return self.constant(function.of(number));
        }
        if let Some(node) = self.without_sign(function, x) {
            return node;
        }
        if let (UnaryFunction::Abs, NodeOperation::Unary(inner, _)) = (function, self.operation(x))
            && matches!(inner, UnaryFunction::Abs | UnaryFunction::Sqrt | UnaryFunction::Exp)
        {
            return x;
        }
        self.intern(NodeOperation::Unary(function, x))
    }

    /// Expresses an odd or even function of −x by that of x, so that both are one node.
    fn without_sign(&mut self, function: UnaryFunction, x: Node) -> Option<Node> {
        let is_odd = match function {
            UnaryFunction::Cos | UnaryFunction::Abs => false,
            UnaryFunction::Sin
            | UnaryFunction::Tanh
            | UnaryFunction::Sign
            | UnaryFunction::Asin => true,
            UnaryFunction::Exp
            | UnaryFunction::Ln
            | UnaryFunction::Sqrt
            | UnaryFunction::Softplus
            | UnaryFunction::Logistic
            | UnaryFunction::SoftplusArea
            | UnaryFunction::SoftplusSquareArea
            | UnaryFunction::Acos => return None,
        };
        let NodeOperation::Sum(number, terms) = self.operation(x) else { return None };
        let is_negative = terms.first().is_some_and(|(_, factor)| f64::from_bits(*factor) < 0.0);
        if !is_negative {
            return None;
        }
        // Term by term: a long sum would otherwise become one negative term of another.
        let opposite = terms.iter().map(|(node, factor)| (*node, -f64::from_bits(*factor)));
        let (number, opposite) = (-f64::from_bits(*number), opposite.collect::<Vec<_>>());
        let positive = self.sum_in_order(number, &opposite);
        let value = self.unary(function, positive);
        Some(if is_odd { self.negate(value) } else { value })
    }

    pub fn sqrt(&mut self, x: Node) -> Node {
        self.unary(UnaryFunction::Sqrt, x)
    }

    pub fn binary(&mut self, function: BinaryFunction, x: Node, y: Node) -> Node {
        match (self.number(x), self.number(y)) {
            (Some(x), Some(y)) => self.constant(function.of(x, y)),
            (None, Some(exponent)) if function == BinaryFunction::Power => {
                self.constant_power(x, exponent)
            }
            _ => self.intern(NodeOperation::Binary(function, x, y)),
        }
    }

    /// Returns `x` to a power that is a number; whole powers are products.
    fn constant_power(&mut self, x: Node, exponent: f64) -> Node {
        /// Beyond it a product of that many factors is no better than the function.
        const MOST: f64 = 64.0;
        if exponent.fract() == 0.0 && exponent.abs() <= MOST {
            #[expect(clippy::cast_possible_truncation, reason = "a small whole number")]
            return self.power(x, exponent as i32);
        }
        if exponent.to_bits() == 0.5_f64.to_bits() {
            return self.sqrt(x);
        }
        let y = self.constant(exponent);
        self.intern(NodeOperation::Binary(BinaryFunction::Power, x, y))
    }

    /// Returns `positive` where `condition` is positive, else `other`.
    pub fn select(&mut self, condition: Node, positive: Node, other: Node) -> Node {
        if positive == other {
            return positive;
        }
        match self.number(condition) {
            Some(number) if number > 0.0 => positive,
            Some(_) => other,
            None => self.intern(NodeOperation::Select([condition, positive, other])),
        }
    }
}
