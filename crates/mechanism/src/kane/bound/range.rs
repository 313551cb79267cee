use std::collections::HashMap;

use super::functions::is_never_negative;
use super::interval::{Range, around, room};
use super::{extra, larger, magnitude};
use crate::kane::graph::{
    BinaryFunction, Graph, Node, NodeOperation, Place, Substitution, UnaryFunction,
};
use instruments::equations::table::EnclosureLayout;

/// Ranges of expressions over one step, each computed once.
#[derive(Debug)]
pub(super) struct Ranges {
    /// Largest distance of each place from its centre.
    spreads: HashMap<Place, Node>,
    /// Expressions at the centre: with the input at its start, and its rates at 0.
    at_centre: Substitution,
    known: HashMap<Node, Range>,
}

impl Ranges {
    pub(super) fn new(graph: &mut Graph, state: &[Place]) -> Self {
        let mut spreads = HashMap::new();
        for (entry, place) in state.iter().enumerate() {
            spreads.insert(*place, extra(graph, EnclosureLayout::moves(entry)));
        }
        let zero = graph.constant(0.0);
        let inputs = [0, 1, 2, 3].map(Place::Input);
        for place in inputs {
            spreads.insert(place, graph.symbol(place));
        }
        let mut centres = inputs.map(|place| (place, zero));
        if state.len() > 1 {
            centres[0].1 = extra(graph, EnclosureLayout::input_start());
            let step = extra(graph, EnclosureLayout::step());
            let rate = graph.symbol(Place::Input(1));
            spreads.insert(Place::Input(0), graph.multiply(step, rate));
        }
        Self { spreads, at_centre: Substitution::new(centres), known: HashMap::new() }
    }

    pub(super) fn size(&mut self, graph: &mut Graph, node: Node) -> Node {
        self.of(graph, node).size
    }

    pub(super) fn of(&mut self, graph: &mut Graph, node: Node) -> Range {
        for reached in graph.reached(&[node]) {
            if !self.known.contains_key(&reached) {
                let range = self.one(graph, reached);
                let range = known_or_nothing(graph, range);
                self.known.insert(reached, range);
            }
        }
        let unknown = Range { centre: node, spread: node, size: node };
        self.known.get(&node).copied().unwrap_or(unknown)
    }

    fn one(&mut self, graph: &mut Graph, node: Node) -> Range {
        let centre = self.at_centre.of(graph, node);
        match graph.operation(node).clone() {
            NodeOperation::Number(_) => around(graph, centre, None),
            NodeOperation::Symbol(place) => {
                let spread = self.spreads.get(&place).copied();
                let range = around(graph, centre, spread);
                // The largest magnitude of the input is known.
                let size = if place == Place::Input(0) { node } else { range.size };
                Range { size, ..range }
            }
            NodeOperation::Sum(_, terms) => {
                let spreads: Vec<_> = terms
                    .iter()
                    .map(|(it, by)| (self.known[it].spread, f64::from_bits(*by).abs()))
                    .collect();
                let spread = graph.sum(&spreads);
                around(graph, centre, Some(spread))
            }
            NodeOperation::Product(factors) => self.product(graph, &factors, centre),
            NodeOperation::Unary(function, x) => {
                let range = super::functions::unary(graph, function, self.known[&x], centre);
                if function == UnaryFunction::Sqrt { self.rooted(graph, x, range) } else { range }
            }
            NodeOperation::Binary(function, x, y) => {
                let ranges = [x, y].map(|it| self.known[&it]);
                let range = super::functions::binary(graph, function, ranges, centre);
                if function == BinaryFunction::Power { self.rooted(graph, x, range) } else { range }
            }
            NodeOperation::Select(all) => self.select(graph, all, centre),
        }
    }

    /// Returns the range of a root or a power of `x`, which is NaN where `x` may be negative.
    fn rooted(&self, graph: &mut Graph, x: Node, range: Range) -> Range {
        let own = self.known[&x];
        if graph.is_zero(own.spread) || is_never_negative(graph, x) {
            return range;
        }
        let low = graph.subtract(own.centre, own.spread);
        let unknown = graph.constant(f64::INFINITY);
        let [spread, size] = [range.spread, range.size].map(|it| graph.select(low, it, unknown));
        Range { spread, size, ..range }
    }

    /// Multiplies factor by factor: |a b − a₀ b₀| ≤ |a − a₀| |b| + |a₀| |b − b₀|.
    fn product(&self, graph: &mut Graph, factors: &[(Node, i32)], centre: Node) -> Range {
        let one = graph.constant(1.0);
        let mut all = around(graph, one, None);
        for (factor, exponent) in factors {
            let power = super::functions::power(graph, self.known[factor], *exponent);
            let own = magnitude(graph, all.centre);
            let [before, after] =
                [graph.multiply(all.spread, power.size), graph.multiply(own, power.spread)];
            all = Range {
                centre: graph.multiply(all.centre, power.centre),
                spread: graph.add(before, after),
                size: graph.multiply(all.size, power.size),
            };
        }
        Range { centre, ..all }
    }

    /// Returns the range of one branch where the condition keeps its sign, otherwise of both.
    fn select(&self, graph: &mut Graph, all: [Node; 3], centre: Node) -> Range {
        let [condition, positive, other] = all.map(|it| self.known[&it]);
        let room = room(graph, condition);
        let one = |graph: &mut Graph, of: fn(&Range) -> Node| {
            graph.select(condition.centre, of(&positive), of(&other))
        };
        let either = larger(graph, positive.size, other.size);
        let (size, spread) = (one(graph, |it| it.size), one(graph, |it| it.spread));
        let from_centre = magnitude(graph, centre);
        let far = graph.add(from_centre, either);
        Range {
            centre,
            spread: graph.select(room, spread, far),
            size: graph.select(room, size, either),
        }
    }
}

/// Returns the range, unbounded if the centre is not finite: infinity vanishes in a quotient.
fn known_or_nothing(graph: &mut Graph, range: Range) -> Range {
    if graph.number(range.centre).is_none_or(f64::is_finite) {
        return range;
    }
    let unknown = graph.constant(f64::INFINITY);
    Range { centre: graph.constant(0.0), spread: unknown, size: unknown }
}
