use std::collections::BTreeMap;

use super::{Graph, Node, NodeOperation};

/// Most merged parts of a sum or product: one built term by term would hold all its beginnings.
const MOST_FLATTENED: usize = 48;

#[derive(Default)]
pub(super) struct Sum {
    number: f64,
    terms: BTreeMap<Node, f64>,
}

impl Sum {
    pub(super) fn starting_with(number: f64) -> Self {
        Self { number, terms: BTreeMap::new() }
    }

    /// Adds `node` times `factor`; the terms of a sum one by one.
    pub(super) fn add(&mut self, graph: &Graph, node: Node, factor: f64) {
        graph.spend(1);
        match graph.operation(node) {
            NodeOperation::Number(bits) => self.number += factor * f64::from_bits(*bits),
            NodeOperation::Sum(number, terms) if terms.len() <= MOST_FLATTENED => {
                graph.spend(terms.len());
                self.number += factor * f64::from_bits(*number);
                for (term, inner) in terms {
                    self.enter(*term, factor * f64::from_bits(*inner));
                }
            }
            NodeOperation::Symbol(_)
            | NodeOperation::Sum(..)
            | NodeOperation::Product(_)
            | NodeOperation::Unary(..)
            | NodeOperation::Binary(..)
            | NodeOperation::Select(_) => self.enter(node, factor),
        }
    }

    fn enter(&mut self, node: Node, factor: f64) {
        *self.terms.entry(node).or_insert(0.0) += factor;
    }

    pub(super) fn finish(self) -> (f64, Vec<(Node, f64)>) {
        let terms = self.terms.into_iter().filter(|(_, factor)| *factor != 0.0).collect();
        (self.number, terms)
    }
}

pub(super) struct Product {
    number: f64,
    factors: BTreeMap<Node, i32>,
}

impl Product {
    pub(super) const fn new() -> Self {
        Self { number: 1.0, factors: BTreeMap::new() }
    }

    /// Multiplies by `node` to `exponent`, factor by factor, the number of a multiple separately.
    pub(super) fn multiply(&mut self, graph: &Graph, node: Node, exponent: i32) {
        graph.spend(1);
        match graph.operation(node) {
            NodeOperation::Number(bits) => self.number *= f64::from_bits(*bits).powi(exponent),
            NodeOperation::Product(factors) if factors.len() <= MOST_FLATTENED => {
                graph.spend(factors.len());
                for (factor, inner) in factors {
                    self.enter(*factor, exponent.saturating_mul(*inner));
                }
            }
            NodeOperation::Sum(0, terms) if terms.len() == 1 => {
                let (term, factor) = terms[0];
                self.number *= f64::from_bits(factor).powi(exponent);
                self.multiply(graph, term, exponent);
            }
            NodeOperation::Symbol(_)
            | NodeOperation::Sum(..)
            | NodeOperation::Product(_)
            | NodeOperation::Unary(..)
            | NodeOperation::Binary(..)
            | NodeOperation::Select(_) => self.enter(node, exponent),
        }
    }

    fn enter(&mut self, node: Node, exponent: i32) {
        let entry = self.factors.entry(node).or_insert(0);
        *entry = entry.saturating_add(exponent);
    }

    pub(super) fn finish(self) -> (f64, Vec<(Node, i32)>) {
        let factors = self.factors.into_iter().filter(|(_, exponent)| *exponent != 0).collect();
        (self.number, factors)
    }
}
