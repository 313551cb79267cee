//! An expression as it was written, in a list: operands stand before what is made of them.

use std::ops::Range;

use super::Dimension;

/// A text that was read, as a list of parts.
#[derive(Clone, PartialEq, Debug)]
pub struct ParsedExpression {
    /// The text itself, for messages.
    pub text: String,
    /// Its parts, operands first; the last is the whole.
    pub parts: Vec<ExpressionPart>,
}

/// A part of an expression.
#[derive(Clone, PartialEq, Debug)]
pub struct ExpressionPart {
    pub shape: PartShape,
    pub span: Range<usize>,
}

/// What a part is made of; numbers are those of other parts.
#[derive(Clone, PartialEq, Debug)]
pub enum PartShape {
    /// A number in SI; its unit in SI, if it was written with one.
    Number {
        value: f64,
        dimension: Dimension,
        unit: Option<String>,
    },
    Name {
        name: String,
        primes: u8,
    },
    /// Terms; the second says whether it is subtracted.
    Sum(Vec<(usize, bool)>),
    /// Factors; the second says whether it divides.
    Product(Vec<(usize, bool)>),
    Power(usize, usize),
    Negative(usize),
    /// A function of numbers.
    Call {
        function: String,
        arguments: Vec<usize>,
    },
    /// A function of what has a name, as `x(P)`.
    Named {
        function: String,
        names: Vec<(String, Range<usize>)>,
    },
    /// The first is larger than the second.
    Greater(usize, usize),
}

/// What an expression should be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    Value,
    /// A comparison of two values.
    Condition,
}

impl ParsedExpression {
    /// Returns the unit in SI of an expression that is one number.
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

    /// Whether it is a number, with or without a sign.
    pub fn is_literal(&self) -> bool {
        self.parts
            .iter()
            .all(|part| matches!(part.shape, PartShape::Number { .. } | PartShape::Negative(_)))
    }

    /// Returns the text of a part.
    pub fn slice(&self, span: &Range<usize>) -> &str {
        self.text.get(span.clone()).unwrap_or("")
    }
}
