use std::ops::Range;

use documents::quoted;

use super::expression::{ExpressionPart, ParsedExpression, PartShape};
use super::functions::{Function, UnitRule, function};
use super::{Dependence, Dimension, Measured, NameError, NameScope, TextError};
use crate::expressions::graph::{BinaryFunction, Graph, UnaryFunction};

/// Returns the value of `expression` in `scope`, with its unit.
///
/// # Errors
/// Every unknown name and every mismatch of units; empty if they were reported before.
pub fn build(
    expression: &ParsedExpression,
    graph: &mut Graph,
    scope: &mut dyn NameScope,
) -> Result<Measured, Vec<TextError>> {
    let mut builder =
        ValueBuilder { expression, graph, scope, found: Vec::new(), values: Vec::new() };
    for part in &expression.parts {
        let value = builder.part(part);
        builder.values.push(value);
    }
    match builder.values.last().copied().flatten() {
        Some(value) if builder.found.is_empty() => Ok(value),
        _ => Err(builder.found),
    }
}

struct ValueBuilder<'a> {
    expression: &'a ParsedExpression,
    graph: &'a mut Graph,
    scope: &'a mut dyn NameScope,
    found: Vec<TextError>,
    values: Vec<Option<Measured>>,
}

impl ValueBuilder<'_> {
    fn part(&mut self, part: &ExpressionPart) -> Option<Measured> {
        match &part.shape {
            PartShape::Number { value, dimension, .. } => {
                let node = self.graph.constant(*value);
                Some(Measured { node, dimension: *dimension, reach: Dependence::NOTHING })
            }
            PartShape::Name { name, primes } => {
                let value = self.scope.value(self.graph, name, *primes);
                let value = value.map_err(|it| self.refuse(&part.span, it)).ok()?;
                self.within_reach(value, &part.span)
            }
            PartShape::Named { function, names } => self.of_names(function, names, part),
            PartShape::Sum(terms) => self.sum(terms),
            PartShape::Product(factors) => self.product(factors),
            PartShape::Power(base, exponent) => self.power(*base, *exponent),
            PartShape::Negative(inner) => {
                let value = self.value(*inner)?;
                Some(Measured { node: self.graph.negate(value.node), ..value })
            }
            PartShape::Call { function, arguments } => self.call(function, arguments, part),
            PartShape::Greater(large, small) => self.greater(*large, *small),
        }
    }

    fn value(&self, part: usize) -> Option<Measured> {
        self.values.get(part).copied().flatten()
    }

    fn span(&self, part: usize) -> Range<usize> {
        self.expression.parts.get(part).map_or(0..0, |it| it.span.clone())
    }

    fn refuse(&mut self, span: &Range<usize>, error: Option<NameError>) {
        if let Some(NameError { message, help }) = error {
            self.found.push(TextError::new(span.clone(), message, help));
        }
    }

    fn within_reach(&mut self, value: Measured, span: &Range<usize>) -> Option<Measured> {
        let allowed = self.scope.allowed();
        if allowed.covers(value.reach) {
            return Some(value);
        }
        let written = quoted(self.expression.slice(span));
        let beyond = value.reach.without(allowed).words();
        let message = format!("{written} depends on {beyond}, which cannot stand here");
        self.found.push(TextError::new(
            span.clone(),
            message,
            format!("use only {} here", allowed.words()),
        ));
        None
    }

    fn of_names(
        &mut self,
        function: &str,
        names: &[(String, Range<usize>)],
        part: &ExpressionPart,
    ) -> Option<Measured> {
        let written: Vec<_> = names.iter().map(|(name, _)| name.as_str()).collect();
        match self.scope.named(self.graph, function, &written) {
            Ok(value) => self.within_reach(value, &part.span),
            Err((index, error)) => {
                let span = names.get(index).map_or(part.span.clone(), |(_, span)| span.clone());
                self.refuse(&span, error);
                None
            }
        }
    }

    /// Returns the common unit of the two; a plain 0 has every unit.
    fn agree(&mut self, first: usize, second: usize, what: &str) -> Option<Dimension> {
        let (a, b) = (self.value(first)?, self.value(second)?);
        if a.dimension.fits(b.dimension) || self.is_plain_zero(b) {
            return Some(a.dimension);
        }
        if self.is_plain_zero(a) {
            return Some(b.dimension);
        }
        let (left, right) = (self.span(first), self.span(second));
        let message = format!(
            "{} is in {}, but {} is in {}",
            quoted(self.expression.slice(&right)),
            b.dimension,
            quoted(self.expression.slice(&left)),
            a.dimension
        );
        self.found.push(TextError {
            span: right,
            other: Some(left),
            message,
            help: format!("{what} takes one unit"),
        });
        None
    }

    fn is_plain_zero(&self, value: Measured) -> bool {
        value.dimension.is_none() && self.graph.is_zero(value.node)
    }

    fn sum(&mut self, terms: &[(usize, bool)]) -> Option<Measured> {
        let values: Option<Vec<_>> = terms.iter().map(|(part, _)| self.value(*part)).collect();
        let values = values?;
        let lead = values.iter().position(|it| !self.is_plain_zero(*it)).unwrap_or(0);
        let (first, _) = *terms.get(lead)?;
        let mut dimension = self.value(first).map(|it| it.dimension);
        for (part, _) in terms {
            if self.agree(first, *part, "a sum").is_none() {
                dimension = None;
            }
        }
        let signed: Vec<_> = values
            .iter()
            .zip(terms)
            .map(|(value, (_, is_negative))| (value.node, if *is_negative { -1.0 } else { 1.0 }))
            .collect();
        let reach = values.iter().fold(Dependence::NOTHING, |all, it| all.and(it.reach));
        Some(Measured { node: self.graph.sum(&signed), dimension: dimension?, reach })
    }

    fn product(&mut self, factors: &[(usize, bool)]) -> Option<Measured> {
        let mut dimension = Dimension::NONE;
        let mut reach = Dependence::NOTHING;
        let mut nodes = Vec::with_capacity(factors.len());
        for (part, divides) in factors {
            let value = self.value(*part)?;
            reach = reach.and(value.reach);
            if *divides && self.graph.is_zero(value.node) {
                let span = self.span(*part);
                self.found.push(TextError::new(
                    span,
                    "division by zero",
                    "divide by something else",
                ));
                return None;
            }
            dimension = if *divides {
                dimension.over(value.dimension)
            } else {
                dimension.times(value.dimension)
            };
            nodes.push((value.node, if *divides { -1 } else { 1 }));
        }
        // Two numbers are divided, not multiplied by a reciprocal: one rounding, not two.
        let node = match nodes.as_slice() {
            [(above, 1), (below, -1)] => self.quotient(*above, *below),
            _ => self.graph.product(&nodes),
        };
        Some(Measured { node, dimension, reach })
    }

    fn quotient(
        &mut self,
        above: crate::expressions::graph::Node,
        below: crate::expressions::graph::Node,
    ) -> crate::expressions::graph::Node {
        match (self.graph.number(above), self.graph.number(below)) {
            (Some(above), Some(below)) => self.graph.constant(above / below),
            _ => self.graph.divide(above, below),
        }
    }

    fn power(&mut self, base: usize, exponent: usize) -> Option<Measured> {
        let (x, y) = (self.value(base)?, self.value(exponent)?);
        let reach = x.reach.and(y.reach);
        if !y.dimension.is_none() {
            let span = self.span(exponent);
            let message = format!("the exponent is in {}", y.dimension);
            self.found.push(TextError::new(span, message, "make it a ratio"));
            return None;
        }
        let number = self.graph.number(y.node);
        if number.is_none() && !x.dimension.is_none() {
            let span = self.span(base);
            let written = quoted(self.expression.slice(&span));
            let message = format!("{written} is in {}, and its exponent is no number", x.dimension);
            let help = "divide by a reference, as (d/(1 m))^p";
            self.found.push(TextError {
                other: Some(self.span(exponent)),
                ..TextError::new(span, message, help)
            });
            return None;
        }
        let node = self.graph.binary(BinaryFunction::Power, x.node, y.node);
        Some(Measured { node, dimension: x.dimension.to(number.unwrap_or(1.0)), reach })
    }

    fn greater(&mut self, large: usize, small: usize) -> Option<Measured> {
        let (a, b) = (self.value(large)?, self.value(small)?);
        let dimension = self.agree(large, small, "a comparison")?;
        let node = self.graph.subtract(a.node, b.node);
        Some(Measured { node, dimension, reach: a.reach.and(b.reach) })
    }

    fn call(&mut self, name: &str, arguments: &[usize], part: &ExpressionPart) -> Option<Measured> {
        let values: Option<Vec<_>> = arguments.iter().map(|it| self.value(*it)).collect();
        let values = values?;
        let reach = values.iter().fold(Dependence::NOTHING, |all, it| all.and(it.reach));
        match (function(name)?, values.as_slice(), arguments) {
            (Function::Unary(function, rule), [x], [at]) => self.unary((function, rule), *x, *at),
            (Function::Composed(compose), [x], [at]) => {
                self.ratio(*x, *at)?;
                Some(Measured { node: compose(self.graph, x.node), ..*x })
            }
            (Function::OfNumber(function), [x], [at]) => {
                self.ratio(*x, *at)?;
                let Some(number) = self.graph.number(x.node) else {
                    let message = format!("{name} is of numbers only");
                    self.found.push(TextError::new(self.span(*at), message, "write a number"));
                    return None;
                };
                Some(Measured { node: self.graph.constant(function(number)), ..*x })
            }
            (Function::Binary(function, rule), [x, y], [first, second]) => {
                let same = self.agree(*first, *second, name)?;
                let dimension = if rule == UnitRule::Same { same } else { Dimension::NONE };
                Some(Measured {
                    node: self.graph.binary(function, x.node, y.node),
                    dimension,
                    reach,
                })
            }
            (Function::If, [condition, x, y], [_, first, second]) => {
                let dimension = self.agree(*first, *second, name)?;
                let node = self.graph.select(condition.node, x.node, y.node);
                Some(Measured { node, dimension, reach })
            }
            (Function::Rate, [x], _) => {
                let rate = self.scope.rate(self.graph, *x);
                let rate = rate.map_err(|it| self.refuse(&part.span, Some(it))).ok()?;
                self.within_reach(rate, &part.span)
            }
            _ => None,
        }
    }

    fn ratio(&mut self, x: Measured, at: usize) -> Option<()> {
        if x.dimension.is_none() {
            return Some(());
        }
        let span = self.span(at);
        let written = quoted(self.expression.slice(&span));
        let message = format!("{written} is in {}, not a ratio or an angle", x.dimension);
        self.found.push(TextError::new(span, message, "divide it by something of its unit"));
        None
    }

    fn unary(
        &mut self,
        (function, rule): (UnaryFunction, UnitRule),
        x: Measured,
        at: usize,
    ) -> Option<Measured> {
        if rule == UnitRule::Ratio {
            self.ratio(x, at)?;
        }
        let dimension = match rule {
            UnitRule::Ratio | UnitRule::ToRatio => Dimension::NONE,
            UnitRule::Same => x.dimension,
            UnitRule::Root => x.dimension.to(0.5),
        };
        Some(Measured { node: self.graph.unary(function, x.node), dimension, reach: x.reach })
    }
}
