//! The language of expressions: text with units, read into the graph.
//!
//! [`parse`] turns a text into a [`ParsedExpression`], [`build`] turns that into a node: names are
//! resolved in a [`NameScope`], and units are checked. Every mistake has its place in the text.

mod build;
mod composed;
mod dimension;
mod expression;
mod functions;
mod lexer;
mod parser;
mod scope;
mod units;

pub use build::build;
pub use dimension::Dimension;
pub use expression::{ExpressionPart, Form, ParsedExpression, PartShape};
pub use functions::FUNCTIONS;
pub use parser::{DEEPEST, MOST_PARTS, parse};
pub use scope::{Dependence, Measured, NameError, NameScope};
pub use units::{PhysicalUnit, converted, number_and_unit, unit};

use std::ops::Range;

/// Mistake in a text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TextError {
    pub span: Range<usize>,
    pub other: Option<Range<usize>>,
    pub message: String,
    pub help: String,
}

impl TextError {
    pub fn new(span: Range<usize>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { span, other: None, message: message.into(), help: help.into() }
    }
}
