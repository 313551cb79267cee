//! Poses within the ranges at which constraints lose their rank.

use super::closing::close;
use super::coordinates::SolvedCoordinates;
use super::error::DerivationObstacle;
use super::inertia::gradient;
use super::kinematics::number;
use super::numeric::{self, NumericPose};
use crate::kane::graph::{Graph, Place};
use crate::kane::mechanism::{ConstraintKind, Mechanism, Mode};

/// Poses that are tried in each mode.
const SAMPLES: usize = 8;
/// Relative size of a row, or of what is left of a zero, that counts as none.
const NOTHING: f64 = 1e-6;

/// Returns an obstacle if the constraints' own Jacobian loses rank at a pose that meets them, found
/// from samples of the ranges. Poses that are singular only for a choice of speeds are no obstacle.
pub(super) fn check(
    graph: &mut Graph,
    pose: &NumericPose,
    mechanism: &Mechanism,
    mode: &Mode,
    solved: &SolvedCoordinates,
) -> Result<(), Vec<DerivationObstacle>> {
    let n = mechanism.speeds.len();
    let constraints = mode.constraints.iter().map(|c| &mechanism.constraints[*c]);
    let holonomic = constraints.filter(|it| it.kind == ConstraintKind::Holonomic);
    let (mut zeros, mut rows, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for constraint in holonomic {
        zeros.push(constraint.zero);
        rows.push(gradient(graph, mechanism, constraint.rate)[..n].to_vec());
        names.push(constraint.name.clone());
    }
    if rows.is_empty() {
        return Ok(());
    }
    let mut sizes = vec![0.0_f64; rows.len()];
    for sample in 0..SAMPLES {
        let mut here = sampled(pose, mechanism, sample);
        solved.place(graph, &mut here);
        let before = largest(&here.all(graph, &zeros));
        for (size, row) in sizes.iter_mut().zip(here.matrix(graph, &rows)) {
            *size = size.max(largest(&row));
        }
        close(graph, &mut here, mechanism, mode, solved);
        let matrix = here.matrix(graph, &rows);
        let is_met = largest(&here.all(graph, &zeros)) <= NOTHING * before;
        if is_met && is_inside(&here, mechanism) && has_lost(&matrix, &sizes) {
            let at = |i: usize| here.get(Place::Coordinate(number(i)));
            let places = mechanism.coordinates.iter().enumerate();
            let pose: Vec<_> =
                places.map(|(i, it)| format!("{} = {:.3}", it.name, at(i))).collect();
            let pose = pose.join(", ");
            return Err(vec![DerivationObstacle::SingularConstraints { constraints: names, pose }]);
        }
    }
    Ok(())
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, it| most.max(it.abs()))
}

fn has_lost(matrix: &[Vec<f64>], sizes: &[f64]) -> bool {
    if !matrix.iter().flatten().all(|it| it.is_finite()) {
        return false;
    }
    let is_gone = matrix.iter().zip(sizes).any(|(row, size)| largest(row) <= NOTHING * size);
    let columns = matrix.first().map_or(0, Vec::len);
    is_gone || numeric::pivots(matrix.to_vec(), &[(0..columns).collect()]).len() < matrix.len()
}

fn sampled(pose: &NumericPose, mechanism: &Mechanism, sample: usize) -> NumericPose {
    let mut here = pose.clone();
    for (i, coordinate) in mechanism.coordinates.iter().enumerate() {
        let (low, high) = coordinate.range;
        // Fractional parts of multiples of square roots of integers fill the ranges evenly.
        let part = ((sample + 1) as f64 * ((i * i + i + 2) as f64).sqrt()).fract();
        here.set(Place::Coordinate(number(i)), low + part * (high - low));
    }
    here
}

fn is_inside(pose: &NumericPose, mechanism: &Mechanism) -> bool {
    let mut coordinates = mechanism.coordinates.iter().enumerate();
    coordinates.all(|(i, it)| {
        let value = pose.get(Place::Coordinate(number(i)));
        it.range.0 <= value && value <= it.range.1
    })
}
