use super::{BinaryFunction, Graph, Node, NodeMap, NodeOperation, NodeTerms, Place, UnaryFunction};

/// Exact derivatives of nodes along one direction, each computed once.
#[derive(Debug)]
pub struct Tangent {
    /// Rates of symbols; a symbol that is not listed has the rate 0.
    seeds: NodeMap<Place, Node>,
    known: NodeMap<Node, Node>,
}

impl Tangent {
    /// Returns the direction in which each listed symbol changes at its rate.
    pub fn new(seeds: impl IntoIterator<Item = (Place, Node)>) -> Self {
        Self { seeds: seeds.into_iter().collect(), known: NodeMap::default() }
    }

    /// Returns the direction with `node` taken as a constant; a symbol keeps its rate.
    #[must_use]
    pub fn with_constant(mut self, graph: &mut Graph, node: Node) -> Self {
        if !matches!(graph.operation(node), NodeOperation::Symbol(_)) {
            self.known.insert(node, graph.constant(0.0));
        }
        self
    }

    pub fn of(&mut self, graph: &mut Graph, node: Node) -> Node {
        if let Some(known) = self.known.get(&node) {
            return *known;
        }
        // Operands first, so no recursion is needed.
        for reached in graph.reached(&[node]) {
            if !self.known.contains_key(&reached) {
                let derivative = self.one(graph, reached);
                self.known.insert(reached, derivative);
            }
        }
        self.known.get(&node).copied().unwrap_or(node)
    }

    fn one(&self, graph: &mut Graph, node: Node) -> Node {
        match graph.operation(node).clone() {
            NodeOperation::Number(_) => graph.constant(0.0),
            NodeOperation::Symbol(place) => {
                self.seeds.get(&place).copied().unwrap_or_else(|| graph.constant(0.0))
            }
            NodeOperation::Sum(_, terms) => self.of_sum(graph, &terms),
            NodeOperation::Product(factors) => self.of_product(graph, &factors),
            NodeOperation::Unary(function, x) => {
                let rate = self.known[&x];
                if graph.is_zero(rate) {
                    return rate;
                }
                let slope = slope(graph, function, x, node);
                graph.multiply(slope, rate)
            }
            NodeOperation::Binary(function, x, y) => self.of_binary(graph, function, [x, y], node),
            NodeOperation::Select([condition, positive, other]) => {
                let (positive, other) = (self.known[&positive], self.known[&other]);
                graph.select(condition, positive, other)
            }
        }
    }

    fn of_sum(&self, graph: &mut Graph, terms: &NodeTerms) -> Node {
        let terms: Vec<_> = terms
            .iter()
            .map(|(node, factor)| (self.known[node], f64::from_bits(*factor)))
            .collect();
        graph.sum(&terms)
    }

    fn of_product(&self, graph: &mut Graph, factors: &[(Node, i32)]) -> Node {
        let mut terms = Vec::new();
        for (at, (node, exponent)) in factors.iter().enumerate() {
            let rate = self.known[node];
            if graph.is_zero(rate) {
                continue;
            }
            let mut others = factors.to_vec();
            others[at].1 -= 1;
            others.push((rate, 1));
            terms.push((graph.product(&others), f64::from(*exponent)));
        }
        graph.sum(&terms)
    }

    fn of_binary(
        &self,
        graph: &mut Graph,
        function: BinaryFunction,
        [x, y]: [Node; 2],
        node: Node,
    ) -> Node {
        let (dx, dy) = (self.known[&x], self.known[&y]);
        if graph.is_zero(dx) && graph.is_zero(dy) {
            return dx;
        }
        match function {
            BinaryFunction::Min | BinaryFunction::Max => {
                let first_is_larger = graph.subtract(x, y);
                let (above, below) =
                    if function == BinaryFunction::Max { (dx, dy) } else { (dy, dx) };
                graph.select(first_is_larger, above, below)
            }
            BinaryFunction::Hypot => {
                let (a, b) = (graph.multiply(x, dx), graph.multiply(y, dy));
                let sum = graph.add(a, b);
                graph.divide(sum, node)
            }
            BinaryFunction::Atan2 => {
                // For atan2(x, y) in the names here: the derivative is (y dx − x dy)/(x² + y²).
                let (a, b) = (graph.multiply(y, dx), graph.multiply(x, dy));
                let turn = graph.subtract(a, b);
                let (xx, yy) = (graph.power(x, 2), graph.power(y, 2));
                let square = graph.add(xx, yy);
                graph.divide(turn, square)
            }
            BinaryFunction::Power => self.of_power(graph, [x, y], node),
        }
    }

    /// Returns the derivative of xʸ: y xʸ⁻¹ dx + xʸ ln x dy.
    fn of_power(&self, graph: &mut Graph, [x, y]: [Node; 2], node: Node) -> Node {
        let (dx, dy) = (self.known[&x], self.known[&y]);
        let minus_one = graph.constant(-1.0);
        let less = graph.add(y, minus_one);
        let lower = graph.binary(BinaryFunction::Power, x, less);
        let first = graph.product(&[(y, 1), (lower, 1), (dx, 1)]);
        if graph.is_zero(dy) {
            return first;
        }
        let log = graph.unary(UnaryFunction::Ln, x);
        let second = graph.product(&[(node, 1), (log, 1), (dy, 1)]);
        graph.add(first, second)
    }
}

fn slope(graph: &mut Graph, function: UnaryFunction, x: Node, value: Node) -> Node {
    match function {
        UnaryFunction::Sin => graph.unary(UnaryFunction::Cos, x),
        UnaryFunction::Cos => {
            let sine = graph.unary(UnaryFunction::Sin, x);
            graph.negate(sine)
        }
        UnaryFunction::Tanh => one_less_square(graph, value),
        UnaryFunction::Exp => value,
        UnaryFunction::Ln => graph.power(x, -1),
        UnaryFunction::Sqrt => {
            let inverse = graph.power(value, -1);
            graph.scale(inverse, 0.5)
        }
        UnaryFunction::Abs => graph.unary(UnaryFunction::Sign, x),
        UnaryFunction::Sign => graph.constant(0.0),
        UnaryFunction::Softplus => graph.unary(UnaryFunction::Logistic, x),
        UnaryFunction::Logistic => {
            let square = graph.power(value, 2);
            graph.subtract(value, square)
        }
        UnaryFunction::SoftplusArea => graph.unary(UnaryFunction::Softplus, x),
        UnaryFunction::SoftplusSquareArea => {
            let softplus = graph.unary(UnaryFunction::Softplus, x);
            graph.power(softplus, 2)
        }
        UnaryFunction::Asin | UnaryFunction::Acos => {
            let square = one_less_square(graph, x);
            let root = graph.sqrt(square);
            let inverse = graph.power(root, -1);
            if function == UnaryFunction::Asin { inverse } else { graph.negate(inverse) }
        }
    }
}

fn one_less_square(graph: &mut Graph, x: Node) -> Node {
    let (one, square) = (graph.constant(1.0), graph.power(x, 2));
    graph.subtract(one, square)
}

impl Graph {
    pub fn partial(&mut self, node: Node, place: Place) -> Node {
        let one = self.constant(1.0);
        Tangent::new([(place, one)]).of(self, node)
    }
}
