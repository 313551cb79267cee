//! Newton's step towards constraints from which no coordinate is solved.

use std::collections::BTreeMap;

use super::coordinates::plain_speed;
use super::kinematics::number;
use super::linear;
use super::motion::ModeMotion;
use super::numeric;
use crate::kane::graph::{Graph, Node, Place, Tangent};
use crate::kane::mechanism::{ConstraintKind, Mechanism, Mode};

const ROUNDING: f64 = 1e-9;

/// Distances of constraints from zero, and the state after one step of Newton's method.
#[derive(Debug, Default)]
pub(super) struct Projection {
    /// Distances, and the rates of constraints that multipliers hold.
    pub(super) drift: Vec<Node>,
    pub(super) moved: BTreeMap<Place, Node>,
}

impl Projection {
    /// Returns the step of a mode; empty if the solved coordinates meet all constraints.
    pub(super) fn of(
        graph: &mut Graph,
        mechanism: &Mechanism,
        mode: &Mode,
        motion: &ModeMotion,
    ) -> Self {
        if !motion.speeds.held.is_empty() {
            return Self::of_held(graph, mechanism, motion);
        }
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
        let moved = step(graph, mechanism, motion, &free, &drift, &slopes);
        Self { drift, moved }
    }

    /// Returns the smallest step, by mass, of coordinates and speeds towards the held rows.
    fn of_held(graph: &mut Graph, mechanism: &Mechanism, motion: &ModeMotion) -> Self {
        let mut finish = motion.finishing();
        let zero = graph.constant(0.0);
        let (mut distances, mut rates) = (Vec::new(), Vec::new());
        for row in &motion.speeds.held {
            let constraint = row.constraint.map(|c| &mechanism.constraints[c]);
            let places = constraint.filter(|it| it.kind == ConstraintKind::Holonomic);
            distances.push(places.map_or(zero, |it| it.zero));
            rates.push(row.rate(graph, mechanism));
        }
        let turned = motion.correction(graph, &distances);
        let speeds = turned.iter().enumerate().map(|(j, by)| (Place::Speed(number(j)), *by));
        let mut along = Tangent::new(speeds.collect::<Vec<_>>());
        let mut changes = Vec::new();
        for (i, coordinate) in mechanism.coordinates.iter().enumerate() {
            let change = along.of(graph, coordinate.rate);
            changes.push((Place::Coordinate(number(i)), change));
        }
        let turned = motion.correction(graph, &rates);
        changes.extend(turned.iter().enumerate().map(|(j, by)| (Place::Speed(number(j)), *by)));
        let is_moved = |place: &Place| !motion.is_solved(*place);
        let mut moved = BTreeMap::new();
        for (place, change) in changes.into_iter().filter(|it| is_moved(&it.0)) {
            let symbol = graph.symbol(place);
            let sum = graph.add(symbol, change);
            moved.insert(place, finish.of(graph, sum));
        }
        distances.retain(|it| !graph.is_zero(*it));
        let drift = distances.into_iter().chain(rates).map(|it| finish.of(graph, it)).collect();
        Self { drift, moved }
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
) -> BTreeMap<Place, Node> {
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
            let place = Place::Coordinate(number(free[*column]));
            let symbol = graph.symbol(place);
            (place, graph.subtract(symbol, change[0]))
        })
        .collect()
}
