use std::collections::{BTreeMap, HashMap};

use super::inertia::{InertiaTerms, drift, gradient};
use super::kinematics::number;
use super::speeds::SpeedMap;
use crate::kane::graph::{Graph, Node, Place, Substitution};
use crate::kane::mechanism::{Mechanism, Mode};

/// Returns the generalised forces less the inertia forces at constant speeds.
pub(super) fn forces(
    graph: &mut Graph,
    mechanism: &Mechanism,
    inertia: &InertiaTerms,
    mode: &Mode,
) -> Vec<Node> {
    let mut terms: Vec<Vec<(Node, f64)>> = (inertia.weight.iter().zip(&inertia.bias))
        .map(|(weight, bias)| vec![(*weight, 1.0), (*bias, -1.0)])
        .collect();
    for force in mode.forces.iter().map(|f| &mechanism.forces[*f]) {
        let slopes = gradient(graph, mechanism, force.stretch_rate);
        for (terms, slope) in terms.iter_mut().zip(slopes) {
            terms.push((graph.multiply(force.tension, slope), -1.0));
        }
        if let Some(clocks) = terms.get_mut(mechanism.speeds.len() + 1) {
            let drift = drift(graph, mechanism, force.stretch_rate);
            clocks.push((graph.multiply(force.tension, drift), -1.0));
        }
    }
    terms.iter().map(|terms| graph.sum(terms)).collect()
}

pub(super) fn times(
    graph: &mut Graph,
    matrix: &[Vec<Node>],
    vector: &[Node],
    count: usize,
) -> Vec<Node> {
    matrix[..count].iter().map(|row| inner(graph, row, vector)).collect()
}

/// Returns the scalar product over the entries that both have.
pub(super) fn inner(graph: &mut Graph, x: &[Node], y: &[Node]) -> Node {
    let terms: Vec<_> = x.iter().zip(y).map(|(x, y)| (graph.multiply(*x, *y), 1.0)).collect();
    graph.sum(&terms)
}

pub(super) fn finishing(
    graph: &mut Graph,
    solved: &BTreeMap<usize, Node>,
    speeds: &SpeedMap,
) -> HashMap<Place, Node> {
    let mut all: HashMap<Place, Node> =
        solved.iter().map(|(i, node)| (Place::Coordinate(number(*i)), *node)).collect();
    let mut places = Substitution::new(all.iter().map(|(place, node)| (*place, *node)));
    for j in &speeds.dependent {
        let value = speeds.value(graph, *j);
        all.insert(Place::Speed(number(*j)), places.of(graph, value));
    }
    all
}
