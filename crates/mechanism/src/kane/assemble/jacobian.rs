//! Derivatives by the state and by the input, along what a mode slaves.

use crate::kane::graph::{Graph, Node, Place, Substitution, Tangent};
use crate::kane::system::ModeEquations;

#[derive(Debug)]
pub(super) struct StateOfMode<'a> {
    pub(super) state: &'a [Place],
    pub(super) is_free: &'a [bool],
    /// What slaved entries are in terms of free ones and the input; free ones themselves.
    pub(super) slaved: Vec<Node>,
}

impl<'a> StateOfMode<'a> {
    pub(super) fn new(graph: &mut Graph, state: &'a [Place], mode: &'a ModeEquations) -> Self {
        let mut slaved = mode.slaved.clone();
        // One entry may follow from another one that follows, as many times as there are entries.
        for _ in 0..state.len() {
            let by: Vec<_> = slaved_places(state, &mode.is_free, &slaved);
            let mut substitution = Substitution::new(by.iter().copied());
            let next: Vec<_> = slaved.iter().map(|it| substitution.of(graph, *it)).collect();
            if next == slaved {
                break;
            }
            slaved = next;
        }
        Self { state, is_free: &mode.is_free, slaved }
    }

    pub(super) fn is_free(&self, index: usize) -> bool {
        self.is_free.get(index).copied().unwrap_or(true)
    }

    pub(super) fn free(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.state.len()).filter(|index| self.is_free(*index))
    }

    pub(super) fn replaced(&self, graph: &mut Graph, nodes: &[Node]) -> Vec<Node> {
        let by = slaved_places(self.state, self.is_free, &self.slaved);
        let mut substitution = Substitution::new(by);
        nodes.iter().map(|node| substitution.of(graph, *node)).collect()
    }

    /// The direction in which `place` moves by one, and all that is slaved to it along.
    pub(super) fn direction(&self, graph: &mut Graph, place: Place) -> Tangent {
        let one = graph.constant(1.0);
        let mut seeds = vec![(place, one)];
        for (slaved, by) in slaved_places(self.state, self.is_free, &self.slaved) {
            seeds.push((slaved, graph.partial(by, place)));
        }
        Tangent::new(seeds)
    }

    /// The derivative of `rates` by the state: rows and columns of what is slaved are 0.
    pub(super) fn jacobian(&self, graph: &mut Graph, rates: &[Node]) -> Vec<Vec<Node>> {
        let zero = graph.constant(0.0);
        let mut rows = vec![vec![zero; self.state.len()]; self.state.len()];
        for column in self.free() {
            let mut direction = self.direction(graph, self.state[column]);
            for row in self.free() {
                rows[row][column] = direction.of(graph, rates[row]);
            }
        }
        rows
    }

    /// Returns the Jacobian and `true`; `false` if its expressions would be too many, with the rate
    /// that depends on an entry's place as the entry.
    pub(super) fn rows(&self, graph: &mut Graph, rates: &[Node]) -> (Vec<Vec<Node>>, bool) {
        /// Most operands of the rates times entries that move; no shipped model has as many.
        const MOST: usize = 20_000;
        let free: Vec<Node> = self.free().map(|index| rates[index]).collect();
        let mut operands = 0;
        for node in graph.reached(&free) {
            graph.operation(node).operands(|_| operands += 1);
        }
        if operands * free.len() <= MOST {
            return (self.jacobian(graph, rates), true);
        }
        let zero = graph.constant(0.0);
        let mut rows = vec![vec![zero; self.state.len()]; self.state.len()];
        let rates = self.replaced(graph, rates);
        for row in self.free() {
            let reached = graph.reached(&[rates[row]]);
            let symbols = self.state.iter().map(|place| graph.symbol(*place));
            let is_used = symbols.map(|it| reached.binary_search(&it).is_ok());
            let uses: Vec<bool> = is_used.collect();
            for column in self.free().filter(|column| uses[*column]) {
                rows[row][column] = rates[row];
            }
        }
        (rows, false)
    }
}

fn slaved_places(state: &[Place], is_free: &[bool], slaved: &[Node]) -> Vec<(Place, Node)> {
    let all = state.iter().zip(slaved).zip(is_free);
    all.filter(|(_, is_free)| !**is_free).map(|((place, by), _)| (*place, *by)).collect()
}
