//! Values at one pose, for the choice of pivots and the detection of dependences.

use std::collections::HashMap;

use super::kinematics::number;
use crate::kane::graph::{Graph, Node, NodeOperation, Place};
use crate::kane::mechanism::Mechanism;

/// Fraction of a matrix's largest entry below which an entry counts as 0.
const NEGLIGIBLE: f64 = 1e-9;

#[derive(Clone, Debug, Default)]
pub(in crate::kane) struct NumericPose {
    values: HashMap<Place, f64>,
}

impl NumericPose {
    /// Returns the rest pose with the default values of the parameters, for a key in the middle.
    pub(in crate::kane) fn at_rest(graph: &Graph, mechanism: &Mechanism) -> Self {
        /// Number of the key C4.
        const MIDDLE: f64 = 39.0;
        let mut pose = Self { values: HashMap::from([(Place::Key, MIDDLE)]) };
        for k in 0..4 {
            pose.set(Place::Input(k), 0.0);
        }
        for j in 0..mechanism.speeds.len() {
            pose.set(Place::Speed(number(j)), 0.0);
        }
        let defaults =
            mechanism.instrument.presets.first().map(|preset| pose.all(graph, &preset.values));
        for i in 0..mechanism.parameters.len() {
            let value = defaults.as_ref().and_then(|all| all.get(i).copied()).unwrap_or(1.0);
            pose.set(Place::Parameter(number(i)), value);
        }
        for i in 0..mechanism.coordinates.len() {
            let guess = mechanism.rest.coordinates.get(i).copied().flatten();
            let value = guess.map_or(0.0, |guess| pose.value(graph, guess));
            pose.set(Place::Coordinate(number(i)), if value.is_finite() { value } else { 0.0 });
        }
        pose
    }

    pub(super) fn nearby(&self, mechanism: &Mechanism) -> Self {
        let mut pose = self.clone();
        for i in 0..mechanism.coordinates.len() {
            let place = Place::Coordinate(number(i));
            let value = self.values.get(&place).copied().unwrap_or(0.0);
            // Fractional parts of multiples of the golden ratio never coincide.
            let offset = (0.5 + 0.618_033_988_75 * (i as f64 + 1.0)).fract() - 0.5;
            pose.set(place, value + 0.02 * offset * value.abs().max(1.0));
        }
        pose.set(Place::Input(0), 0.003);
        pose
    }

    pub(in crate::kane) fn set(&mut self, place: Place, value: f64) {
        self.values.insert(place, value);
    }

    pub(in crate::kane) fn get(&self, place: Place) -> f64 {
        self.values.get(&place).copied().unwrap_or(0.0)
    }

    pub(in crate::kane) fn value(&self, graph: &Graph, node: Node) -> f64 {
        self.all(graph, &[node])[0]
    }

    /// Returns the values of `nodes`; a symbol without a value is 0.
    pub(in crate::kane) fn all(&self, graph: &Graph, nodes: &[Node]) -> Vec<f64> {
        let last = nodes.iter().max().map_or(0, |last| last.index());
        let mut values = vec![0.0; last + 1];
        for node in graph.reached(nodes) {
            values[node.index()] = self.one(graph, &values, node);
        }
        nodes.iter().map(|node| values[node.index()]).collect()
    }

    fn one(&self, graph: &Graph, values: &[f64], node: Node) -> f64 {
        let of = |it: &Node| values[it.index()];
        match graph.operation(node) {
            NodeOperation::Number(bits) => f64::from_bits(*bits),
            NodeOperation::Symbol(place) => self.get(*place),
            NodeOperation::Sum(number, terms) => {
                let terms = terms.iter().map(|(it, by)| of(it) * f64::from_bits(*by));
                f64::from_bits(*number) + terms.sum::<f64>()
            }
            NodeOperation::Product(factors) => {
                factors.iter().map(|(it, by)| of(it).powi(*by)).product()
            }
            NodeOperation::Unary(function, x) => function.of(of(x)),
            NodeOperation::Binary(function, x, y) => function.of(of(x), of(y)),
            NodeOperation::Select([condition, positive, _]) if of(condition) > 0.0 => of(positive),
            NodeOperation::Select([_, _, other]) => of(other),
        }
    }

    pub(super) fn matrix(&self, graph: &Graph, rows: &[Vec<Node>]) -> Vec<Vec<f64>> {
        rows.iter().map(|row| self.all(graph, row)).collect()
    }
}

/// Returns rows and columns of pivots, as many as the rank, the largest first; columns of an
/// earlier group of `groups` precede those of a later one.
pub(super) fn pivots(mut matrix: Vec<Vec<f64>>, groups: &[Vec<usize>]) -> Vec<(usize, usize)> {
    for row in &mut matrix {
        let size = row.iter().fold(0.0_f64, |size, entry| size.max(entry.abs()));
        if size > 0.0 && size.is_finite() {
            for entry in row {
                *entry /= size;
            }
        }
    }
    let mut found: Vec<(usize, usize)> = Vec::new();
    for group in groups {
        while let Some((row, column)) = largest(&matrix, group, &found) {
            found.push((row, column));
            eliminate(&mut matrix, row, column, &found);
        }
    }
    found
}

fn largest(
    matrix: &[Vec<f64>],
    group: &[usize],
    taken: &[(usize, usize)],
) -> Option<(usize, usize)> {
    let mut best = (NEGLIGIBLE, None);
    for (r, row) in matrix.iter().enumerate() {
        if taken.iter().any(|(row, _)| *row == r) {
            continue;
        }
        for c in group.iter().filter(|c| !taken.iter().any(|(_, column)| column == *c)) {
            // By more than rounding, so that equal entries keep their order.
            if row[*c].abs() > best.0 * (1.0 + NEGLIGIBLE) {
                best = (row[*c].abs(), Some((r, *c)));
            }
        }
    }
    best.1
}

fn eliminate(matrix: &mut [Vec<f64>], row: usize, column: usize, taken: &[(usize, usize)]) {
    let pivot = matrix[row].clone();
    for (r, other) in matrix.iter_mut().enumerate() {
        if taken.iter().any(|(row, _)| *row == r) {
            continue;
        }
        let factor = other[column] / pivot[column];
        for (entry, by) in other.iter_mut().zip(&pivot) {
            *entry -= factor * by;
        }
    }
}
