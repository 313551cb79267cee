//! Simplification by cos² + sin² = 1, where both are in one sum with one factor.

use std::collections::HashMap;

use super::{Graph, Node, NodeOperation, UnaryFunction, order};

/// Square in a sum: the other factors of its product, and the angle.
type SquaredFactor = (Box<[(Node, i32)]>, Node);

impl Graph {
    /// Returns the sum with each pair a cos²(x) p + a sin²(x) p replaced by a p.
    pub(super) fn collect_squares(&mut self, number: f64, terms: &mut Vec<(Node, f64)>) -> Node {
        let mut number = number;
        // Each round leaves fewer terms.
        while let Some((pairs, left)) = self.pairs(terms) {
            let mut collected = order::Sum::starting_with(number);
            for (node, factor) in left {
                collected.add(self, node, factor);
            }
            for (rest, factor) in pairs {
                let rest = self.product(&rest);
                collected.add(self, rest, factor);
            }
            (number, *terms) = collected.finish();
        }
        self.sum_in_order(number, terms)
    }

    /// Returns the pairs' common factors, and the terms that are left; `None` without a pair.
    #[expect(clippy::type_complexity, reason = "two lists of terms")]
    fn pairs(
        &self,
        terms: &[(Node, f64)],
    ) -> Option<(Vec<(Box<[(Node, i32)]>, f64)>, Vec<(Node, f64)>)> {
        self.spend(terms.len());
        let mut cosines: HashMap<SquaredFactor, usize> = HashMap::new();
        for (at, (node, _)) in terms.iter().enumerate() {
            cosines.extend(self.squares(*node, UnaryFunction::Cos).map(|square| (square, at)));
        }
        if cosines.is_empty() {
            return None;
        }
        let mut is_paired = vec![false; terms.len()];
        let mut pairs = Vec::new();
        for (at, (node, factor)) in terms.iter().enumerate() {
            let partners = self.squares(*node, UnaryFunction::Sin).filter_map(|square| {
                let partner = *cosines.get(&square)?;
                let is_same = terms[partner].1.to_bits() == factor.to_bits();
                (is_same && !is_paired[at] && !is_paired[partner]).then_some((square.0, partner))
            });
            let Some((rest, partner)) = { partners }.next() else { continue };
            (is_paired[at], is_paired[partner]) = (true, true);
            pairs.push((rest, *factor));
        }
        if pairs.is_empty() {
            return None;
        }
        let left = terms.iter().zip(is_paired).filter(|(_, is_paired)| !is_paired);
        Some((pairs, left.map(|(term, _)| *term).collect()))
    }

    fn squares(&self, node: Node, function: UnaryFunction) -> impl Iterator<Item = SquaredFactor> {
        let factors: &[(Node, i32)] =
            if let NodeOperation::Product(factors) = self.operation(node) { factors } else { &[] };
        factors.iter().enumerate().filter_map(move |(at, (factor, exponent))| {
            let NodeOperation::Unary(found, angle) = self.operation(*factor) else { return None };
            if *found != function || *exponent != 2 {
                return None;
            }
            let mut others = factors.to_vec();
            others.remove(at);
            Some((others.into_boxed_slice(), *angle))
        })
    }
}
