//! What depends on the parameters alone is found once.

use crate::kane::graph::{Graph, Node, NodeMap, NodeOperation, Place};

/// Constants for the largest expressions of parameters alone, beyond a parameter or a number.
#[derive(Debug, Default)]
pub(super) struct Hoisting {
    /// Number of parameters; constants have the numbers behind them.
    parameters: usize,
    /// The expressions, in the order of their numbers.
    pub(super) constants: Vec<Node>,
    numbers: NodeMap<Node, Node>,
    rewritten: NodeMap<Node, Node>,
    is_fixed: NodeMap<Node, bool>,
}

impl Hoisting {
    pub(super) fn new(parameters: usize) -> Self {
        Self { parameters, ..Self::default() }
    }

    pub(super) fn of(&mut self, graph: &mut Graph, outputs: &[Node]) -> Vec<Node> {
        for node in graph.reached(outputs) {
            self.see(graph, node);
        }
        outputs.iter().map(|output| self.used(graph, *output)).collect()
    }

    fn see(&mut self, graph: &mut Graph, node: Node) {
        if self.is_fixed.contains_key(&node) {
            return;
        }
        let mut is_fixed = true;
        if let NodeOperation::Symbol(place) = graph.operation(node) {
            is_fixed = self.is_parameter(*place);
        }
        graph.operation(node).operands(|operand| is_fixed &= self.is_fixed[&operand]);
        self.is_fixed.insert(node, is_fixed);
        if !is_fixed {
            let new = self.one(graph, node);
            self.rewritten.insert(node, new);
        }
    }

    fn is_parameter(&self, place: Place) -> bool {
        matches!(place, Place::Parameter(number) if usize::from(number) < self.parameters)
    }

    fn used(&mut self, graph: &mut Graph, node: Node) -> Node {
        // A node that was not seen: work on the graph was given up.
        let Some(is_fixed) = self.is_fixed.get(&node) else { return node };
        if !is_fixed {
            return self.rewritten[&node];
        }
        if matches!(graph.operation(node), NodeOperation::Number(_) | NodeOperation::Symbol(_)) {
            node
        } else {
            self.constant(graph, node)
        }
    }

    fn constant(&mut self, graph: &mut Graph, node: Node) -> Node {
        if let Some(symbol) = self.numbers.get(&node) {
            return *symbol;
        }
        let number = self.parameters + self.constants.len();
        let symbol = graph.symbol(Place::Parameter(u16::try_from(number).unwrap_or(u16::MAX)));
        self.constants.push(node);
        self.numbers.insert(node, symbol);
        symbol
    }

    fn one(&mut self, graph: &mut Graph, node: Node) -> Node {
        match graph.operation(node).clone() {
            NodeOperation::Number(_) | NodeOperation::Symbol(_) => node,
            NodeOperation::Sum(number, terms) => {
                let terms: Vec<_> =
                    terms.iter().map(|(it, by)| (*it, f64::from_bits(*by))).collect();
                self.sum(graph, f64::from_bits(number), &terms)
            }
            NodeOperation::Product(factors) => self.product(graph, &factors),
            NodeOperation::Unary(function, x) => {
                let x = self.used(graph, x);
                graph.unary(function, x)
            }
            NodeOperation::Binary(function, x, y) => {
                let [x, y] = [x, y].map(|it| self.used(graph, it));
                graph.binary(function, x, y)
            }
            NodeOperation::Select(all) => {
                let [condition, positive, other] = all.map(|it| self.used(graph, it));
                graph.select(condition, positive, other)
            }
        }
    }

    /// The fixed terms of a sum are one constant together.
    fn sum(&mut self, graph: &mut Graph, number: f64, terms: &[(Node, f64)]) -> Node {
        let (fixed, moving): (Vec<_>, Vec<_>) =
            terms.iter().partition(|(node, _)| self.is_fixed[node]);
        let mut all = Vec::new();
        for (node, factor) in moving {
            all.push((self.used(graph, node), factor));
        }
        match fixed.as_slice() {
            [] => all.push((graph.constant(number), 1.0)),
            [(node, factor @ (1.0 | -1.0))] if number == 0.0 => {
                all.push((self.used(graph, *node), *factor));
            }
            _ => {
                let mut fixed = fixed;
                fixed.push((graph.constant(number), 1.0));
                let together = graph.sum(&fixed);
                all.push((self.fixed(graph, together), 1.0));
            }
        }
        graph.sum(&all)
    }

    /// The fixed factors of a product are one constant together.
    fn product(&mut self, graph: &mut Graph, factors: &[(Node, i32)]) -> Node {
        let (fixed, moving): (Vec<_>, Vec<_>) =
            factors.iter().partition(|(node, _)| self.is_fixed[node]);
        let mut all = Vec::new();
        for (node, exponent) in moving {
            all.push((self.used(graph, node), exponent));
        }
        match fixed.as_slice() {
            [] => {}
            [(node, 1)] => all.push((self.used(graph, *node), 1)),
            _ => {
                let together = graph.product(&fixed);
                all.push((self.fixed(graph, together), 1));
            }
        }
        graph.product(&all)
    }

    fn fixed(&mut self, graph: &mut Graph, node: Node) -> Node {
        for reached in graph.reached(&[node]) {
            self.see(graph, reached);
        }
        self.used(graph, node)
    }
}
