use super::magnitude;
use crate::kane::graph::{Graph, Node};

/// Range of an expression over one step: within `spread` of `centre`, and of magnitude ≤ `size`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub(super) centre: Node,
    pub(super) spread: Node,
    pub(super) size: Node,
}

/// Returns a range around `centre`; without a spread it is a point.
pub(super) fn around(graph: &mut Graph, centre: Node, spread: Option<Node>) -> Range {
    let spread = spread.unwrap_or_else(|| graph.constant(0.0));
    let size = magnitude(graph, centre);
    Range { centre, spread, size: graph.add(size, spread) }
}

/// Returns the distance of the range from 0; negative where the range may include it.
pub(super) fn room(graph: &mut Graph, range: Range) -> Node {
    let size = magnitude(graph, range.centre);
    graph.subtract(size, range.spread)
}
