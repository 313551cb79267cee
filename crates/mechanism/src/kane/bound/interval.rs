//! Where an expression is over one step.

use super::magnitude;
use crate::kane::graph::{Graph, Node};

/// Where an expression is over a step: within `spread` of `centre`, and nowhere beyond ±`size`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub(super) centre: Node,
    pub(super) spread: Node,
    pub(super) size: Node,
}

/// A range around `centre`; without a spread it is a point.
pub(super) fn around(graph: &mut Graph, centre: Node, spread: Option<Node>) -> Range {
    let spread = spread.unwrap_or_else(|| graph.constant(0.0));
    let size = magnitude(graph, centre);
    Range { centre, spread, size: graph.add(size, spread) }
}

/// How far the range stays from 0; negative where it may come there.
pub(super) fn room(graph: &mut Graph, range: Range) -> Node {
    let size = magnitude(graph, range.centre);
    graph.subtract(size, range.spread)
}
