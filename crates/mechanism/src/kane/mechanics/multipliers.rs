//! Constraints that act by multipliers: a solution without pivots wherever they are independent.
//!
//! With the mass matrix M and the rows G, the multipliers of M a = f + Gᵀ λ, G a + d = 0 follow from
//! G M⁻¹ Gᵀ, which is symmetric and positive definite.

use super::generalised::inner;
use super::mass_factor::MassFactor;
use super::numeric::NumericPose;
use crate::kane::graph::{Graph, Node};

/// Rows of a mode that multipliers hold.
#[derive(Clone, Debug, Default)]
pub(super) struct MultiplierRows {
    /// Slopes by the dynamic speeds.
    pub(super) slopes: Vec<Vec<Node>>,
    /// Accelerations by one unit of each multiplier.
    responses: Vec<Vec<Node>>,
    factor: MassFactor,
}

impl MultiplierRows {
    /// Returns the rows with `slopes`; the number of a row that depends on others at `pose` fails.
    pub(super) fn of(
        graph: &mut Graph,
        pose: &NumericPose,
        mass: &MassFactor,
        slopes: Vec<Vec<Node>>,
    ) -> Result<Self, usize> {
        let responses: Vec<Vec<Node>> = slopes.iter().map(|row| mass.solve(graph, row)).collect();
        let matrix = symmetric(graph, &slopes, &responses);
        let factor = MassFactor::of(graph, pose, matrix)?;
        Ok(Self { slopes, responses, factor })
    }

    /// Returns the accelerations that are nearest to `free` by mass and meet G a + `drift` = 0.
    pub(super) fn meet(&self, graph: &mut Graph, free: Vec<Node>, drift: &[Node]) -> Vec<Node> {
        let mut excess = Vec::new();
        for (row, drift) in self.slopes.iter().zip(drift) {
            let own = inner(graph, row, &free);
            excess.push(graph.add(own, *drift));
        }
        let multipliers = self.factor.solve(graph, &excess);
        let mut met = Vec::new();
        for (k, free) in free.into_iter().enumerate() {
            let mut terms = vec![(free, 1.0)];
            for (response, multiplier) in self.responses.iter().zip(&multipliers) {
                terms.push((graph.multiply(response[k], *multiplier), -1.0));
            }
            met.push(graph.sum(&terms));
        }
        met
    }
}

/// Returns the products of `rows` with `columns`, with one expression for both halves.
pub(super) fn symmetric(
    graph: &mut Graph,
    rows: &[Vec<Node>],
    columns: &[Vec<Node>],
) -> Vec<Vec<Node>> {
    let n = rows.len();
    let mut matrix = vec![vec![graph.constant(0.0); n]; n];
    for (i, row) in rows.iter().enumerate() {
        for (j, column) in columns.iter().enumerate().take(i + 1) {
            let entry = inner(graph, row, column);
            (matrix[i][j], matrix[j][i]) = (entry, entry);
        }
    }
    matrix
}
