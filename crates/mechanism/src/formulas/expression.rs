use std::ops::Range;

use super::Dimension;

/// Parsed text as a list of parts.
#[derive(Clone, PartialEq, Debug)]
pub struct ParsedExpression {
    pub text: String,
    /// Parts, operands first; the last is the whole.
    pub parts: Vec<ExpressionPart>,
}

/// Part of an expression.
#[derive(Clone, PartialEq, Debug)]
pub struct ExpressionPart {
    pub shape: PartShape,
    pub span: Range<usize>,
}

/// Operation of a part; numbers are indices of other parts.
#[derive(Clone, PartialEq, Debug)]
pub enum PartShape {
    /// Number in SI, with its SI unit if it was written with one.
    Number {
        value: f64,
        dimension: Dimension,
        unit: Option<String>,
    },
    Name {
        name: String,
        primes: u8,
    },
    /// Terms, each with `true` if it is subtracted.
    Sum(Vec<(usize, bool)>),
    /// Factors, each with `true` if it divides.
    Product(Vec<(usize, bool)>),
    Power(usize, usize),
    Negative(usize),
    Call {
        function: String,
        arguments: Vec<usize>,
    },
    /// Function of names, as `x(P)`.
    Named {
        function: String,
        names: Vec<(String, Range<usize>)>,
    },
    /// Comparison: the first is larger than the second.
    Greater(usize, usize),
}

/// Expected form of an expression.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    Value,
    Condition,
}

impl ParsedExpression {
    /// Returns the unit in SI of an expression that is a single number.
    pub fn literal_unit(&self) -> Option<&str> {
        self.parts.iter().find_map(|part| match &part.shape {
            PartShape::Number { unit, .. } => unit.as_deref(),
            PartShape::Name { .. }
            | PartShape::Sum(_)
            | PartShape::Product(_)
            | PartShape::Power(..)
            | PartShape::Negative(_)
            | PartShape::Call { .. }
            | PartShape::Named { .. }
            | PartShape::Greater(..) => None,
        })
    }

    pub fn is_literal(&self) -> bool {
        self.parts
            .iter()
            .all(|part| matches!(part.shape, PartShape::Number { .. } | PartShape::Negative(_)))
    }

    pub fn slice(&self, span: &Range<usize>) -> &str {
        self.text.get(span.clone()).unwrap_or("")
    }
}
