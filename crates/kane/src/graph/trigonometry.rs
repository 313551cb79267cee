//! cos² + sin² = 1, where both stand in one sum with one factor.

use super::{Graph, Node, Operation, UnaryFunction};

impl Graph {
    /// Returns the sum with each pair a cos²(x) p + a sin²(x) p put together to a p.
    pub(super) fn without_squares(&mut self, terms: &mut Vec<(Node, f64)>, number: f64) -> Node {
        for at in 0..terms.len() {
            let (node, factor) = terms[at];
            let Some((rest, partner)) = self.partner(node) else { continue };
            let found = terms.iter().position(|it| *it == (partner, factor));
            if let Some(other) = found {
                let mut left: Vec<_> = terms.clone();
                left.retain(|(it, _)| *it != node && *it != partner);
                left.push((rest, factor));
                if number != 0.0 {
                    let number = self.constant(number);
                    left.push((number, 1.0));
                }
                debug_assert_ne!(at, other, "a sine is no cosine");
                return self.sum(&left);
            }
        }
        self.sum_in_order(number, terms)
    }

    /// Of p cos²(x), p and p sin²(x).
    fn partner(&mut self, node: Node) -> Option<(Node, Node)> {
        let Operation::Product(factors) = self.operation(node).clone() else { return None };
        let (at, angle) = factors.iter().enumerate().find_map(|(at, (factor, exponent))| {
            let Operation::Unary(UnaryFunction::Cos, x) = self.operation(*factor) else {
                return None;
            };
            (*exponent == 2).then_some((at, *x))
        })?;
        let mut others = factors.to_vec();
        others.remove(at);
        let rest = self.product(&others);
        let sine = self.unary(UnaryFunction::Sin, angle);
        others.push((sine, 2));
        // A search, not a new node: what nobody has built cannot be in the sum.
        let partner = self.product(&others);
        Some((rest, partner))
    }
}
