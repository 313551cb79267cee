//! Search for a pose near the guess that meets the constraints.

use super::coordinates::SolvedCoordinates;
use super::kinematics::number;
use super::numeric::NumericPose;
use crate::kane::graph::{Graph, Node, Place};
use crate::kane::mechanism::{ConstraintKind, Mechanism, Mode};

/// Newton's steps from a rough guess; a pose that needs more is left as it is.
const ROUNDS: usize = 30;

/// Moves the unsolved coordinates until the holonomic constraints are met.
pub(super) fn close(
    graph: &mut Graph,
    pose: &mut NumericPose,
    mechanism: &Mechanism,
    mode: &Mode,
    solved: &SolvedCoordinates,
) {
    let free: Vec<usize> =
        (0..mechanism.coordinates.len()).filter(|i| !solved.contains(*i)).collect();
    let mut rest = super::coordinates::replacement(&solved.resolved(graph));
    let zeros: Vec<Node> = (mode.constraints.iter().map(|c| &mechanism.constraints[*c]))
        .filter(|it| it.kind == ConstraintKind::Holonomic)
        .map(|it| rest.of(graph, it.zero))
        .collect();
    let slopes: Vec<Vec<Node>> = zeros
        .iter()
        .map(|zero| {
            free.iter().map(|i| graph.partial(*zero, Place::Coordinate(number(*i)))).collect()
        })
        .collect();
    let start = pose.clone();
    let error = |pose: &NumericPose| -> f64 {
        pose.all(graph, &zeros).into_iter().fold(0.0, |most, it| f64::max(most, it.abs()))
    };
    for _ in 0..ROUNDS {
        let Some(step) = least_step(&pose.matrix(graph, &slopes), &pose.all(graph, &zeros)) else {
            break;
        };
        for (i, change) in free.iter().zip(step) {
            let place = Place::Coordinate(number(*i));
            pose.set(place, pose.get(place) - change);
        }
    }
    let is_better = error(pose).is_finite() && error(pose) <= error(&start);
    if !is_better {
        *pose = start;
    }
    solved.place(graph, pose);
}

/// Returns the shortest x of J x = r, by Jᵀ (J Jᵀ + small)⁻¹ r.
pub(super) fn least_step(jacobian: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    const SMALL: f64 = 1e-14;
    let n = right.len();
    if n == 0 {
        return None;
    }
    let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    let mut a: Vec<Vec<f64>> = jacobian
        .iter()
        .enumerate()
        .map(|(i, row)| {
            let mut line: Vec<f64> = jacobian.iter().map(|other| dot(row, other)).collect();
            line[i] += SMALL * (1.0 + line[i]);
            line.push(right[i]);
            line
        })
        .collect();
    for k in 0..n {
        let pivot = a[k].clone();
        for (_, row) in a.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot[k];
            row.iter_mut().zip(&pivot).for_each(|(entry, by)| *entry -= factor * by);
        }
    }
    let multipliers: Vec<f64> = (0..n).map(|k| a[k][n] / a[k][k]).collect();
    let columns = jacobian.first()?.len();
    let step: Vec<f64> = (0..columns)
        .map(|c| jacobian.iter().zip(&multipliers).map(|(row, by)| row[c] * by).sum())
        .collect();
    step.iter().all(|it| it.is_finite()).then_some(step)
}
