//! Bounds of a guard over one step, as expressions of the step's enclosure.
//!
//! A guard g of the entries and of the input moves by no more than the sum, over these, of how far
//! each moves times the largest slope |∂g/∂z| over the step; and its bend is no more than the sum
//! of slopes times bends, and of second derivatives times products of speeds. The derivatives are
//! exact, so that what cancels in them is seen: hammer and key that go together move the gap
//! between them by little.
//!
//! The largest magnitude of a derivative is its value at the centre, where each entry and the input
//! are at their start and the input's rates are 0, and how far it can be from there: by the chain and product rules,
//! with every slope replaced by the largest over the step ([`range`]).

mod corners;
mod functions;
mod interval;
mod range;

use crate::kane::graph::{BinaryFunction, Graph, Node, Place, UnaryFunction};
use instruments::equations::table::EnclosureLayout;
use range::Ranges;

/// What bounds are made of, for one state.
#[derive(Debug)]
pub(crate) struct Bounds<'a> {
    state: &'a [Place],
    ranges: Ranges,
}

/// How what a guard depends on goes over a step.
#[derive(Clone, Copy, Debug)]
struct Path {
    place: Place,
    /// Bound of the move, the speed and the bend, as the fraction of the step goes from 0 to 1.
    moves: Node,
    speed: Node,
    bend: Node,
}

impl<'a> Bounds<'a> {
    /// Returns what bounds are made of where these are the entries of the state.
    pub(crate) fn new(graph: &mut Graph, state: &'a [Place]) -> Self {
        Self { state, ranges: Ranges::new(graph, state) }
    }

    /// Returns bounds of how far `value` moves, and of its bend, over a step.
    pub(crate) fn of(&mut self, graph: &mut Graph, value: Node) -> [Node; 2] {
        let paths = self.paths(graph, value);
        let slopes: Vec<_> = paths.iter().map(|path| graph.partial(value, path.place)).collect();
        let [jump, corner] = self.ranges.corners(graph, value);
        let (mut moves, mut bend) = (vec![(jump, 1.0)], vec![(jump, 1.0), (corner, 1.0)]);
        for (index, (path, slope)) in paths.iter().zip(&slopes).enumerate() {
            let size = self.ranges.size(graph, *slope);
            moves.push((graph.multiply(size, path.moves), 1.0));
            bend.push((graph.multiply(size, path.bend), 1.0));
            for other in &paths[..index] {
                bend.push((self.second(graph, *slope, [path, other]), 2.0));
            }
            bend.push((self.second(graph, *slope, [path, path]), 1.0));
        }
        [graph.sum(&moves), graph.sum(&bend)]
    }

    /// A second derivative times the speeds of both that it is by.
    fn second(&mut self, graph: &mut Graph, slope: Node, [path, other]: [&Path; 2]) -> Node {
        let second = graph.partial(slope, other.place);
        let size = self.ranges.size(graph, second);
        graph.product(&[(size, 1), (path.speed, 1), (other.speed, 1)])
    }

    /// How all that `value` depends on goes.
    fn paths(&self, graph: &mut Graph, value: Node) -> Vec<Path> {
        let extra = |graph: &mut Graph, number: usize| extra(graph, number);
        let mut paths = Vec::new();
        for (entry, place) in self.state.iter().enumerate() {
            if graph.depends(value, |it| it == *place) {
                paths.push(Path {
                    place: *place,
                    moves: extra(graph, EnclosureLayout::moves(entry)),
                    speed: extra(graph, EnclosureLayout::speed(entry)),
                    bend: extra(graph, EnclosureLayout::bend(entry)),
                });
            }
        }
        for rate in 0..4 {
            if graph.depends(value, |it| it == Place::Input(rate)) {
                paths.push(input(graph, rate));
            }
        }
        paths
    }
}

/// The number of an enclosure at `number`.
fn extra(graph: &mut Graph, number: usize) -> Node {
    graph.symbol(Place::Extra(u16::try_from(number).unwrap_or(u16::MAX)))
}

/// How the input or a rate of it goes: by the largest of the next rates. Of the third nothing is
/// known but its size.
fn input(graph: &mut Graph, rate: u8) -> Path {
    let unknown = graph.constant(f64::INFINITY);
    let step = extra(graph, EnclosureLayout::step());
    let largest = |graph: &mut Graph, rate: u8, power: i32| {
        if rate > 3 {
            return unknown;
        }
        let largest = graph.symbol(Place::Input(rate));
        graph.product(&[(step, power), (largest, 1)])
    };
    let speed = largest(graph, rate + 1, 1);
    let bend = largest(graph, rate + 2, 2);
    let moves = if rate == 3 {
        let size = graph.symbol(Place::Input(3));
        graph.scale(size, 2.0)
    } else {
        speed
    };
    Path { place: Place::Input(rate), moves, speed, bend }
}

/// |x| of a node.
fn magnitude(graph: &mut Graph, x: Node) -> Node {
    graph.unary(UnaryFunction::Abs, x)
}

/// The smaller of two nodes.
fn least(graph: &mut Graph, x: Node, y: Node) -> Node {
    graph.binary(BinaryFunction::Min, x, y)
}

/// The larger of two nodes; the other one where one is no number.
fn most(graph: &mut Graph, x: Node, y: Node) -> Node {
    if x == y { x } else { graph.binary(BinaryFunction::Max, x, y) }
}

/// The larger of two nodes; no number where one is none, so that nothing unknown is lost.
fn larger(graph: &mut Graph, x: Node, y: Node) -> Node {
    if x == y {
        return x;
    }
    let apart = graph.subtract(x, y);
    let apart = magnitude(graph, apart);
    graph.sum(&[(x, 0.5), (y, 0.5), (apart, 0.5)])
}

/// What of a node is above 0; no number where it is none.
fn above_zero(graph: &mut Graph, x: Node) -> Node {
    let size = magnitude(graph, x);
    graph.sum(&[(x, 0.5), (size, 0.5)])
}
