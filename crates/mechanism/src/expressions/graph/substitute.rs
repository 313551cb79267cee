use super::{Graph, Node, NodeMap, NodeOperation, Place};

/// Replacement of symbols by expressions; each node is rebuilt once.
#[derive(Debug)]
pub struct Substitution {
    by: NodeMap<Place, Node>,
    known: NodeMap<Node, Node>,
    /// Sums, which are also replaced within longer ones.
    sums: Vec<(SumTerms, Node)>,
}

/// Number and terms of a sum.
type SumTerms = (f64, Vec<(Node, f64)>);

impl Substitution {
    pub fn new(by: impl IntoIterator<Item = (Place, Node)>) -> Self {
        Self { by: by.into_iter().collect(), known: NodeMap::default(), sums: Vec::new() }
    }

    /// Replaces also `node`, which is not a symbol, by `by`.
    pub fn set(&mut self, node: Node, by: Node) {
        self.known.insert(node, by);
    }

    /// Replaces also `node` by `by`, and multiples of it within sums.
    pub fn set_within_sums(&mut self, graph: &mut Graph, node: Node, by: Node) {
        self.set(node, by);
        let opposite = graph.negate(node);
        let negative = graph.negate(by);
        self.set(opposite, negative);
        if let NodeOperation::Sum(number, terms) = graph.operation(node) {
            self.sums.push((sum_terms(*number, terms), by));
        }
    }

    /// Returns `node` with the symbols replaced; their replacements are not searched again.
    pub fn of(&mut self, graph: &mut Graph, node: Node) -> Node {
        if let Some(known) = self.known.get(&node) {
            return *known;
        }
        for reached in graph.reached(&[node]) {
            if !self.known.contains_key(&reached) {
                let replaced = self.one(graph, reached);
                self.known.insert(reached, replaced);
            }
        }
        self.known.get(&node).copied().unwrap_or(node)
    }

    fn one(&self, graph: &mut Graph, node: Node) -> Node {
        let new = |old: &Node| self.known[old];
        let mut is_changed = match graph.operation(node) {
            NodeOperation::Symbol(_) => true,
            NodeOperation::Sum(..) => !self.sums.is_empty(),
            NodeOperation::Number(_)
            | NodeOperation::Product(_)
            | NodeOperation::Unary(..)
            | NodeOperation::Binary(..)
            | NodeOperation::Select(_) => false,
        };
        graph.operation(node).operands(|old| is_changed |= new(&old) != old);
        if !is_changed {
            return node;
        }
        match graph.operation(node).clone() {
            NodeOperation::Number(_) => node,
            NodeOperation::Symbol(place) => self.by.get(&place).copied().unwrap_or(node),
            NodeOperation::Sum(number, terms) => {
                let (mut sum, mut all) = (sum_terms(number, &terms), Vec::new());
                for (part, by) in &self.sums {
                    all.extend(take_multiple(&mut sum, part).map(|factor| (*by, factor)));
                }
                let (number, terms) = sum;
                all.extend(terms.iter().map(|(it, by)| (new(it), *by)));
                all.push((graph.constant(number), 1.0));
                graph.sum(&all)
            }
            NodeOperation::Product(factors) => {
                let factors: Vec<_> = factors.iter().map(|(it, by)| (new(it), *by)).collect();
                graph.product(&factors)
            }
            NodeOperation::Unary(function, x) => graph.unary(function, new(&x)),
            NodeOperation::Binary(function, x, y) => graph.binary(function, new(&x), new(&y)),
            NodeOperation::Select([condition, positive, other]) => {
                graph.select(new(&condition), new(&positive), new(&other))
            }
        }
    }
}

fn sum_terms(number: u64, terms: &[(Node, u64)]) -> SumTerms {
    let terms = terms.iter().map(|(node, factor)| (*node, f64::from_bits(*factor)));
    (f64::from_bits(number), terms.collect())
}

/// Takes a multiple of `part` out of a sum that has all its terms in one proportion; returns the
/// factor.
fn take_multiple((number, terms): &mut SumTerms, part: &SumTerms) -> Option<f64> {
    const ROUNDING: f64 = 1e-12;
    let found = |(node, _): &(Node, f64)| terms.iter().find(|it| it.0 == *node).map(|it| it.1);
    let first = part.1.first()?;
    let factor = found(first)? / first.1;
    let is_multiple = part
        .1
        .iter()
        .all(|it| found(it).is_some_and(|own| (own - factor * it.1).abs() <= ROUNDING * own.abs()));
    if !is_multiple {
        return None;
    }
    *number -= factor * part.0;
    terms.retain(|(node, _)| part.1.iter().all(|it| it.0 != *node));
    Some(factor)
}
