use super::{Graph, Node, NodeMap, NodeOperation, Place};

/// Replacement of symbols by expressions; each node is rebuilt once.
#[derive(Debug)]
pub struct Substitution {
    by: NodeMap<Place, Node>,
    known: NodeMap<Node, Node>,
}

impl Substitution {
    pub fn new(by: impl IntoIterator<Item = (Place, Node)>) -> Self {
        Self { by: by.into_iter().collect(), known: NodeMap::default() }
    }

    /// Replaces also `node`, which is not a symbol, by `by`.
    pub fn set(&mut self, node: Node, by: Node) {
        self.known.insert(node, by);
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
        let mut is_changed = matches!(graph.operation(node), NodeOperation::Symbol(_));
        graph.operation(node).operands(|old| is_changed |= new(&old) != old);
        if !is_changed {
            return node;
        }
        match graph.operation(node).clone() {
            NodeOperation::Number(_) => node,
            NodeOperation::Symbol(place) => self.by.get(&place).copied().unwrap_or(node),
            NodeOperation::Sum(number, terms) => {
                let number = graph.constant(f64::from_bits(number));
                let mut terms: Vec<_> =
                    terms.iter().map(|(it, by)| (new(it), f64::from_bits(*by))).collect();
                terms.push((number, 1.0));
                graph.sum(&terms)
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
