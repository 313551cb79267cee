//! Newton's step towards constraints from which no coordinate is solved.

use std::collections::BTreeMap;

use super::coordinates::plain_speed;
use super::kinematics::number;
use super::linear;
use super::motion::ModeMotion;
use super::numeric;
use crate::kane::graph::{Graph, Node, Place};
use crate::kane::mechanism::{ConstraintKind, Mechanism, Mode};

const ROUNDING: f64 = 1e-9;

/// Distances of constraints from zero, and coordinates after one step of Newton's method.
#[derive(Debug, Default)]
pub(super) struct Projection {
    pub(super) drift: Vec<Node>,
    pub(super) coordinates: BTreeMap<usize, Node>,
}

impl Projection {
    /// Returns the step of a mode; empty if the solved coordinates meet all constraints.
    pub(super) fn of(
        graph: &mut Graph,
        mechanism: &Mechanism,
        mode: &Mode,
        motion: &ModeMotion,
    ) -> Self {
        let free: Vec<usize> =
            (0..mechanism.coordinates.len()).filter(|i| !motion.solved.contains_key(i)).collect();
        let nearby = motion.pose.nearby(mechanism);
        let mut finish = motion.finishing();
        let (mut drift, mut slopes) = (Vec::new(), Vec::new());
        let active = mode.constraints.iter().map(|c| &mechanism.constraints[*c]);
        for constraint in active.filter(|it| it.kind == ConstraintKind::Holonomic) {
            let zero = finish.of(graph, constraint.zero);
            let row: Vec<Node> =
                free.iter().map(|i| graph.partial(zero, Place::Coordinate(number(*i)))).collect();
            let is_met = [&motion.pose, &nearby]
                .iter()
                .all(|pose| pose.all(graph, &row).iter().all(|it| it.abs() < ROUNDING));
            if !is_met {
                drift.push(zero);
                slopes.push(row);
            }
        }
        let coordinates = step(graph, mechanism, motion, &free, &drift, &slopes);
        Self { drift, coordinates }
    }
}

/// Moves as few coordinates as there are constraints: those with dependent speeds first.
fn step(
    graph: &mut Graph,
    mechanism: &Mechanism,
    motion: &ModeMotion,
    free: &[usize],
    drift: &[Node],
    slopes: &[Vec<Node>],
) -> BTreeMap<usize, Node> {
    let is_dependent = |column: &usize| {
        let speed = plain_speed(graph, mechanism, free[*column]);
        speed.is_some_and(|speed| motion.speeds.dependent.contains(&speed))
    };
    let (first, second): (Vec<usize>, Vec<usize>) = (0..free.len()).partition(is_dependent);
    let pivots = numeric::pivots(motion.pose.matrix(graph, slopes), &[first, second]);
    let a = pivots.iter().map(|(r, _)| pivots.iter().map(|(_, c)| slopes[*r][*c]).collect());
    let b = pivots.iter().map(|(r, _)| vec![drift[*r]]);
    let Some(changes) = linear::solve(graph, &motion.pose, a.collect(), b.collect()) else {
        return BTreeMap::new();
    };
    pivots
        .iter()
        .zip(changes)
        .map(|((_, column), change)| {
            let coordinate = free[*column];
            let symbol = graph.symbol(Place::Coordinate(number(coordinate)));
            (coordinate, graph.subtract(symbol, change[0]))
        })
        .collect()
}
