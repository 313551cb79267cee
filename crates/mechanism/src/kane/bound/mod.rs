//! Bounds of a guard over one step, as expressions of the step's enclosure.
//!
//! A guard g of the entries and of the input moves by at most the sum, over these, of the move of
//! each times the largest slope |∂g/∂z| over the step. Its bend is at most the sum of slopes times
//! bends, and of second derivatives times products of speeds. The derivatives are exact, so that
//! cancelling terms cancel: hammer and key in common motion move the gap between them by little.
//!
//! The largest magnitude of a derivative is its value at the centre, where each entry and the input
//! are at their start and the input's rates are 0, plus its largest distance from there: by the
//! chain and product rules, with every slope replaced by the largest over the step ([`range`]).

mod corners;
mod functions;
mod interval;
mod range;

use crate::kane::graph::{BinaryFunction, Graph, Node, Place, UnaryFunction};
use instruments::equations::table::EnclosureLayout;
use range::Ranges;

#[derive(Debug)]
pub(crate) struct Bounds<'a> {
    state: &'a [Place],
    ranges: Ranges,
}

#[derive(Clone, Copy, Debug)]
struct Path {
    place: Place,
    /// Bound of the move, the speed and the bend, as the fraction of the step goes from 0 to 1.
    moves: Node,
    speed: Node,
    bend: Node,
}

impl<'a> Bounds<'a> {
    pub(crate) fn new(graph: &mut Graph, state: &'a [Place]) -> Self {
        Self { state, ranges: Ranges::new(graph, state) }
    }

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

    /// Multiplies a second derivative by the speeds of both its variables.
    fn second(&mut self, graph: &mut Graph, slope: Node, [path, other]: [&Path; 2]) -> Node {
        let second = graph.partial(slope, other.place);
        let size = self.ranges.size(graph, second);
        graph.product(&[(size, 1), (path.speed, 1), (other.speed, 1)])
    }

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

fn extra(graph: &mut Graph, number: usize) -> Node {
    graph.symbol(Place::Extra(u16::try_from(number).unwrap_or(u16::MAX)))
}

/// Returns the course of the input or a rate of it, by the largest next rate; the third has a size.
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

fn magnitude(graph: &mut Graph, x: Node) -> Node {
    graph.unary(UnaryFunction::Abs, x)
}

fn least(graph: &mut Graph, x: Node, y: Node) -> Node {
    graph.binary(BinaryFunction::Min, x, y)
}

/// Returns the larger of two nodes; the other one where one is NaN.
fn most(graph: &mut Graph, x: Node, y: Node) -> Node {
    if x == y { x } else { graph.binary(BinaryFunction::Max, x, y) }
}

/// Returns the larger of two nodes; NaN where one is, so that unknown values stay unknown.
fn larger(graph: &mut Graph, x: Node, y: Node) -> Node {
    if x == y {
        return x;
    }
    let apart = graph.subtract(x, y);
    let apart = magnitude(graph, apart);
    graph.sum(&[(x, 0.5), (y, 0.5), (apart, 0.5)])
}

/// Returns max(x, 0); NaN where x is NaN.
fn above_zero(graph: &mut Graph, x: Node) -> Node {
    let size = magnitude(graph, x);
    graph.sum(&[(x, 0.5), (size, 0.5)])
}
