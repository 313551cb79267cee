//! Coordinates that follow from others: as the description solves them, and where constraints are
//! linear in them.

use std::collections::BTreeMap;

use super::kinematics::number;
use super::linear;
use super::numeric::{self, NumericPose};
use crate::kane::graph::{Graph, Node, NodeOperation, Place, Substitution};
use crate::kane::mechanism::{ConstraintKind, Mechanism, Mode};

/// Fraction of the largest coefficient below which a coefficient cannot be a pivot.
const NEGLIGIBLE: f64 = 1e-3;

/// Slopes of constraints by the coordinates that are eliminated.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum SlopeKind {
    /// They never vanish; constraints with other slopes act by multipliers.
    Constant,
    /// They may depend on other coordinates: each constraint gives a dependent speed.
    Linear,
}

#[derive(Clone, Debug, Default)]
pub(super) struct SolvedCoordinates {
    /// Coordinates that the description states, over those that it does not.
    pub(super) stated: BTreeMap<usize, Node>,
    /// Coordinates that constraints give linearly, over the others.
    pub(super) linear: BTreeMap<usize, Node>,
}

/// Returns the number of the speed that equals the rate of a coordinate.
pub(super) fn plain_speed(
    graph: &Graph,
    mechanism: &Mechanism,
    coordinate: usize,
) -> Option<usize> {
    let rate = graph.operation(mechanism.coordinates[coordinate].rate);
    if let NodeOperation::Symbol(Place::Speed(j)) = rate { Some(usize::from(*j)) } else { None }
}

pub(super) fn replacement(solved: &BTreeMap<usize, Node>) -> Substitution {
    Substitution::new(solved.iter().map(|(i, node)| (Place::Coordinate(number(*i)), *node)))
}

impl SolvedCoordinates {
    /// Returns the solved coordinates of `mode`.
    ///
    /// # Errors
    /// The stated coordinates that depend on one another.
    pub(super) fn of(
        graph: &mut Graph,
        pose: &NumericPose,
        (mechanism, mode): (&Mechanism, &Mode),
        most: SlopeKind,
    ) -> Result<Self, Vec<usize>> {
        let mut solved = Self { stated: stated(graph, mode)?, linear: BTreeMap::new() };
        let mut pose = pose.clone();
        solved.place(graph, &mut pose);
        Search { graph, pose: &pose, mechanism, mode, most }.fill(&mut solved);
        Ok(solved)
    }

    pub(super) fn contains(&self, coordinate: usize) -> bool {
        self.stated.contains_key(&coordinate) || self.linear.contains_key(&coordinate)
    }

    /// Returns all of them over coordinates that are not solved.
    pub(super) fn resolved(&self, graph: &mut Graph) -> BTreeMap<usize, Node> {
        let mut all = self.linear.clone();
        let mut by_linear = replacement(&self.linear);
        for (i, node) in &self.stated {
            all.insert(*i, by_linear.of(graph, *node));
        }
        all
    }

    pub(super) fn place(&self, graph: &mut Graph, pose: &mut NumericPose) {
        for (i, node) in self.resolved(graph) {
            let value = pose.value(graph, node);
            pose.set(Place::Coordinate(number(i)), value);
        }
    }
}

fn stated(graph: &mut Graph, mode: &Mode) -> Result<BTreeMap<usize, Node>, Vec<usize>> {
    let mut all: BTreeMap<usize, Node> = mode.solved.iter().copied().collect();
    // A chain of n expressions is resolved after n rounds.
    for _ in 0..=all.len() {
        let mut by = replacement(&all);
        let next: BTreeMap<_, _> = all.iter().map(|(i, node)| (*i, by.of(graph, *node))).collect();
        if next == all {
            return Ok(all);
        }
        all = next;
    }
    Err(all.into_keys().collect())
}

struct Search<'a> {
    graph: &'a mut Graph,
    pose: &'a NumericPose,
    mechanism: &'a Mechanism,
    mode: &'a Mode,
    most: SlopeKind,
}

impl Search<'_> {
    fn fill(&mut self, solved: &mut SolvedCoordinates) {
        let zeros = self.zeros(solved);
        let mut chosen: Vec<usize> = Vec::new();
        let candidates: Vec<usize> = (0..self.mechanism.coordinates.len())
            .rev()
            .filter(|coordinate| self.is_free(solved, *coordinate))
            .collect();
        let constant = candidates.iter().map(|it| (*it, SlopeKind::Constant));
        let most = self.most;
        let linear = candidates.iter().map(|it| (*it, most));
        for (coordinate, kind) in constant.chain(linear) {
            if !chosen.contains(&coordinate) && self.fits(&zeros, &chosen, coordinate, kind) {
                chosen.push(coordinate);
            }
        }
        if let Some(values) = self.solve(&zeros, &chosen) {
            solved.linear = chosen.into_iter().zip(values).collect();
        }
    }

    fn zeros(&mut self, solved: &SolvedCoordinates) -> Vec<Node> {
        let mut by = replacement(&solved.stated);
        let active = self.mode.constraints.iter().map(|c| &self.mechanism.constraints[*c]);
        let holonomic = active.filter(|it| it.kind == ConstraintKind::Holonomic);
        holonomic.map(|it| by.of(self.graph, it.zero)).collect()
    }

    /// Returns `true` if the mode does not determine the coordinate otherwise.
    fn is_free(&self, solved: &SolvedCoordinates, coordinate: usize) -> bool {
        let Some(speed) = plain_speed(self.graph, self.mechanism, coordinate) else { return false };
        let is_stated = self.mode.independent.as_ref().is_some_and(|all| all.contains(&speed));
        let has_equation = self.mode.equations.iter().any(|(j, _)| *j == speed);
        !solved.contains(coordinate) && !is_stated && !has_equation
    }

    fn slopes(&mut self, zeros: &[Node], chosen: &[usize]) -> Vec<Vec<Node>> {
        let slope = |graph: &mut Graph, zero: Node, i: usize| {
            graph.partial(zero, Place::Coordinate(number(i)))
        };
        zeros
            .iter()
            .map(|zero| chosen.iter().map(|i| slope(self.graph, *zero, *i)).collect())
            .collect()
    }

    /// Returns the constraints linear in the chosen coordinates, with (constant, if asked) slopes.
    fn usable(
        &mut self,
        zeros: &[Node],
        chosen: &[usize],
        kind: SlopeKind,
    ) -> (Vec<Node>, Vec<Vec<Node>>) {
        let moves = |place: Place| match kind {
            SlopeKind::Constant => matches!(place, Place::Coordinate(_) | Place::Input(_)),
            SlopeKind::Linear => chosen.iter().any(|i| place == Place::Coordinate(number(*i))),
        };
        let slopes = self.slopes(zeros, chosen);
        let both = zeros.iter().copied().zip(slopes);
        both.filter(|(_, row)| !row.iter().any(|slope| self.graph.depends(*slope, moves))).unzip()
    }

    /// Returns `true` if constraints linear in these and the chosen coordinates give all of them.
    fn fits(
        &mut self,
        zeros: &[Node],
        chosen: &[usize],
        coordinate: usize,
        kind: SlopeKind,
    ) -> bool {
        let mut all = chosen.to_vec();
        all.push(coordinate);
        let slopes = self.usable(zeros, &all, kind).1;
        let values = self.pose.matrix(self.graph, &slopes);
        let last = all.len() - 1;
        let largest = values.iter().fold(0.0_f64, |most, row| most.max(row[last].abs()));
        let columns = vec![(0..all.len()).collect()];
        largest > NEGLIGIBLE && numeric::pivots(values, &columns).len() == all.len()
    }

    fn solve(&mut self, zeros: &[Node], chosen: &[usize]) -> Option<Vec<Node>> {
        let (zeros, slopes) = self.usable(zeros, chosen, self.most);
        let values = self.pose.matrix(self.graph, &slopes);
        let mut rows: Vec<usize> =
            numeric::pivots(values, &[(0..chosen.len()).collect()]).iter().map(|it| it.0).collect();
        rows.sort_unstable();
        let zero = self.graph.constant(0.0);
        let without = chosen.iter().map(|i| (Place::Coordinate(number(*i)), zero));
        let mut without = Substitution::new(without);
        let a = rows.iter().map(|r| slopes[*r].clone()).collect();
        let b = rows
            .iter()
            .map(|r| {
                let rest = without.of(self.graph, zeros[*r]);
                vec![self.graph.negate(rest)]
            })
            .collect();
        let solution = linear::solve(self.graph, self.pose, a, b)?;
        Some(solution.into_iter().map(|row| row[0]).collect())
    }
}
