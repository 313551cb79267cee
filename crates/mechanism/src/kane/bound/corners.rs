//! Jumps and corners of an expression, which its derivatives do not show.

use super::functions::cut_room;
use super::interval::room;
use super::magnitude;
use super::range::Ranges;
use crate::kane::graph::{BinaryFunction, Graph, Node, NodeOperation, UnaryFunction};

impl Ranges {
    /// Returns 0 where `node` cannot jump, and 0 where it cannot have a corner; otherwise infinity.
    pub(super) fn corners(&mut self, graph: &mut Graph, node: Node) -> [Node; 2] {
        let (mut jumps, mut corners) = (Vec::new(), Vec::new());
        for reached in graph.reached(&[node]) {
            match graph.operation(reached).clone() {
                NodeOperation::Unary(UnaryFunction::Abs, x) => {
                    corners.push(self.at_zero(graph, x));
                }
                NodeOperation::Unary(UnaryFunction::Sign, x) | NodeOperation::Select([x, ..]) => {
                    jumps.push(self.at_zero(graph, x));
                }
                NodeOperation::Binary(BinaryFunction::Min | BinaryFunction::Max, x, y) => {
                    let apart = graph.subtract(x, y);
                    corners.push(self.at_zero(graph, apart));
                    jumps.extend([x, y].map(|it| self.without_number(graph, it)));
                }
                NodeOperation::Binary(BinaryFunction::Atan2, x, y) => {
                    let ranges = [x, y].map(|it| self.of(graph, it));
                    let room = cut_room(graph, ranges);
                    jumps.push(infinite_without(graph, room));
                }
                NodeOperation::Number(_)
                | NodeOperation::Symbol(_)
                | NodeOperation::Sum(..)
                | NodeOperation::Product(_)
                | NodeOperation::Unary(..)
                | NodeOperation::Binary(BinaryFunction::Hypot | BinaryFunction::Power, ..) => {}
            }
        }
        [jumps, corners].map(|all| {
            let all: Vec<_> = all.into_iter().map(|it| (it, 1.0)).collect();
            graph.sum(&all)
        })
    }

    /// Returns infinity where `node` may be NaN, which the smaller and larger of two ignore.
    fn without_number(&mut self, graph: &mut Graph, node: Node) -> Node {
        if !is_partial(graph, node) {
            return graph.constant(0.0);
        }
        let range = self.of(graph, node);
        let far = magnitude(graph, range.centre);
        let unknown = graph.constant(f64::INFINITY);
        let room = graph.sum(&[(unknown, 1.0), (far, -1.0), (range.spread, -1.0)]);
        infinite_without(graph, room)
    }

    fn at_zero(&mut self, graph: &mut Graph, node: Node) -> Node {
        let range = self.of(graph, node);
        if graph.is_zero(range.spread) {
            return graph.constant(0.0);
        }
        let room = room(graph, range);
        infinite_without(graph, room)
    }
}

/// Returns `true` if some operands of `node` make it NaN.
fn is_partial(graph: &Graph, node: Node) -> bool {
    graph.reached(&[node]).into_iter().any(|it| match graph.operation(it) {
        NodeOperation::Unary(function, _) => matches!(
            function,
            UnaryFunction::Ln | UnaryFunction::Sqrt | UnaryFunction::Asin | UnaryFunction::Acos
        ),
        NodeOperation::Binary(function, _, _) => *function == BinaryFunction::Power,
        NodeOperation::Product(factors) => factors.iter().any(|(_, exponent)| *exponent < 0),
        NodeOperation::Number(_)
        | NodeOperation::Symbol(_)
        | NodeOperation::Sum(..)
        | NodeOperation::Select(_) => false,
    })
}

fn infinite_without(graph: &mut Graph, room: Node) -> Node {
    let (zero, unknown) = (graph.constant(0.0), graph.constant(f64::INFINITY));
    graph.select(room, zero, unknown)
}
