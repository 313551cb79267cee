//! Independent and dependent speeds under constraints and solved coordinates.

use std::collections::BTreeMap;

use super::coordinates::{SlopeKind, SolvedCoordinates, plain_speed};
use super::error::DerivationObstacle;
use super::inertia::{gradient, rates};
use super::kinematics::{along_places, number};
use super::linear;
use super::numeric::{self, NumericPose};
use crate::kane::graph::{Graph, Node, Place, Substitution, Tangent};
use crate::kane::mechanism::{Mechanism, Mode};

const ROUNDING: f64 = 1e-9;

/// Condition that is linear in the speeds: slopes · speeds + rest = 0.
#[derive(Clone, Debug)]
pub(super) struct VelocityRow {
    /// Constraint of which this is the rate; `None` for the condition of a solved coordinate.
    pub(super) constraint: Option<usize>,
    /// Speed of the stated coordinate with this condition.
    pub(super) stated: Option<usize>,
    /// Slopes by all speeds, and by the input's rate.
    pub(super) slopes: Vec<Node>,
    /// Rate where all speeds are 0, with the input's part.
    pub(super) rest: Node,
}

/// All speeds of a mode in terms of the independent ones.
#[derive(Clone, Debug, Default)]
pub(super) struct SpeedMap {
    pub(super) independent: Vec<usize>,
    pub(super) dependent: Vec<usize>,
    /// Slopes of every speed by the independent ones.
    pub(super) slopes: Vec<Vec<Node>>,
    /// Every speed where the independent ones are 0.
    pub(super) offset: Vec<Node>,
    /// Rows of the constraints, and of solved coordinates that no constraint covers.
    pub(super) rows: Vec<VelocityRow>,
    /// Rows that stated coordinates do not meet, without the speeds of these.
    pub(super) open: Vec<VelocityRow>,
    /// Dependent speeds that follow from open rows.
    pub(super) chosen: Vec<usize>,
    /// Rows that no dependent speed meets: multipliers hold them.
    pub(super) held: Vec<VelocityRow>,
}

pub(super) struct SpeedProblem<'a> {
    pub(super) graph: &'a mut Graph,
    pub(super) pose: &'a NumericPose,
    pub(super) nearby: &'a NumericPose,
    pub(super) mechanism: &'a Mechanism,
    pub(super) mode: &'a Mode,
    pub(super) solved: &'a SolvedCoordinates,
    pub(super) most: SlopeKind,
}

pub(super) fn row(
    graph: &mut Graph,
    mechanism: &Mechanism,
    constraint: Option<usize>,
    rate: Node,
) -> VelocityRow {
    let zero = graph.constant(0.0);
    let speeds = rates(mechanism);
    let without = speeds[..mechanism.speeds.len()].iter().map(|place| (*place, zero));
    let rest = Substitution::new(without).of(graph, rate);
    VelocityRow { constraint, stated: None, slopes: gradient(graph, mechanism, rate), rest }
}

impl VelocityRow {
    /// Returns the rate of the row's constraint.
    pub(super) fn rate(&self, graph: &mut Graph, mechanism: &Mechanism) -> Node {
        let mut terms = vec![(self.rest, 1.0)];
        for (j, slope) in self.slopes[..mechanism.speeds.len()].iter().enumerate() {
            let symbol = graph.symbol(Place::Speed(number(j)));
            terms.push((graph.multiply(*slope, symbol), 1.0));
        }
        graph.sum(&terms)
    }
}

impl SpeedMap {
    pub(super) fn value(&self, graph: &mut Graph, speed: usize) -> Node {
        let mut terms = vec![(self.offset[speed], 1.0)];
        for (k, slope) in self.independent.iter().zip(&self.slopes[speed]) {
            let symbol = graph.symbol(Place::Speed(number(*k)));
            terms.push((graph.multiply(*slope, symbol), 1.0));
        }
        graph.sum(&terms)
    }
}

impl SpeedProblem<'_> {
    pub(super) fn solve(mut self) -> Result<SpeedMap, Vec<DerivationObstacle>> {
        let stated = self.stated();
        let mut rows: Vec<VelocityRow> = Vec::new();
        for c in &self.mode.constraints {
            let rate = self.mechanism.constraints[*c].rate;
            rows.push(row(self.graph, self.mechanism, Some(*c), rate));
        }
        let own = self.own_rows();
        self.check_rank(&rows)?;
        let open: Vec<VelocityRow> =
            rows.iter().chain(&own).map(|it| self.without_stated(it, &stated)).collect();
        let open = self.without_met(&rows, open);
        let chosen = self.choose(&open, &stated)?;
        let count = rows.len();
        let all_rows = self.reaction_rows(rows, own, &stated);
        self.check_stated(&all_rows, count)?;
        let map = self.assemble(&open, &chosen, &stated, all_rows)?;
        self.check_met(&map)?;
        Ok(map)
    }

    /// Returns the speeds of stated coordinates, by differentiation.
    fn stated(&mut self) -> BTreeMap<usize, VelocityRow> {
        let mut tangent = along_places(self.graph, self.mechanism);
        let mut all = BTreeMap::new();
        for (i, node) in &self.solved.stated {
            let Some(speed) = plain_speed(self.graph, self.mechanism, *i) else { continue };
            let rate = tangent.of(self.graph, *node);
            all.insert(speed, row(self.graph, self.mechanism, None, rate));
        }
        all
    }

    /// Returns rows of stated coordinates with a rate that is no speed of their own.
    fn own_rows(&mut self) -> Vec<VelocityRow> {
        let mut tangent = along_places(self.graph, self.mechanism);
        let mut rows = Vec::new();
        for (i, node) in &self.solved.stated {
            if plain_speed(self.graph, self.mechanism, *i).is_none() {
                let rate = tangent.of(self.graph, *node);
                let left = self.graph.subtract(self.mechanism.coordinates[*i].rate, rate);
                rows.push(row(self.graph, self.mechanism, None, left));
            }
        }
        rows
    }

    fn without_stated(
        &mut self,
        row: &VelocityRow,
        stated: &BTreeMap<usize, VelocityRow>,
    ) -> VelocityRow {
        let zero = self.graph.constant(0.0);
        let mut new = row.clone();
        for (speed, expression) in stated {
            let by = new.slopes[*speed];
            new.slopes[*speed] = zero;
            if self.graph.is_zero(by) {
                continue;
            }
            for (slope, other) in new.slopes.iter_mut().zip(&expression.slopes) {
                let more = self.graph.multiply(by, *other);
                *slope = self.graph.add(*slope, more);
            }
            let more = self.graph.multiply(by, expression.rest);
            new.rest = self.graph.add(new.rest, more);
        }
        new
    }

    /// Removes rows that stated coordinates meet: the rest of their slopes is rounding.
    fn without_met(&self, rows: &[VelocityRow], mut open: Vec<VelocityRow>) -> Vec<VelocityRow> {
        let n = self.mechanism.speeds.len();
        let size = |pose: &NumericPose, row: &VelocityRow| {
            let values = pose.all(self.graph, &row.slopes[..n]);
            values.iter().fold(0.0, |most, it| f64::max(most, it.abs()))
        };
        let mut at = 0;
        open.retain(|row| {
            let before = rows.get(at).unwrap_or(row);
            at += 1;
            let is_small = |pose| size(pose, row) <= ROUNDING * size(pose, before);
            !(is_small(self.pose) && is_small(self.nearby))
        });
        open
    }

    fn choose(
        &self,
        open: &[VelocityRow],
        stated: &BTreeMap<usize, VelocityRow>,
    ) -> Result<Vec<(usize, usize)>, Vec<DerivationObstacle>> {
        let linear: Vec<usize> = (self.solved.linear.keys())
            .filter_map(|i| plain_speed(self.graph, self.mechanism, *i))
            .collect();
        let is_kept = |j: &usize| {
            let is_independent = self.mode.independent.as_ref().is_some_and(|all| all.contains(j));
            let has_equation = self.mode.equations.iter().any(|(speed, _)| speed == j);
            is_independent || has_equation
        };
        let others = (0..self.mechanism.speeds.len())
            .rev()
            .filter(|j| !stated.contains_key(j) && !linear.contains(j) && !is_kept(j));
        let others: Vec<usize> = others.collect();
        let slopes: Vec<Vec<Node>> = open.iter().map(|row| row.slopes.clone()).collect();
        let mut values = self.pose.matrix(self.graph, &slopes);
        if self.most == SlopeKind::Constant {
            let is_moving = |row: &Vec<Node>| linear.iter().any(|j| is_moving(self.graph, row[*j]));
            for (_, values) in slopes.iter().zip(&mut values).filter(|(row, _)| is_moving(row)) {
                values.fill(0.0);
            }
            return Ok(numeric::pivots(values, &[linear]));
        }
        let chosen = numeric::pivots(values.clone(), &[linear, others]);
        let unstated = (0..self.mechanism.speeds.len()).filter(|j| !stated.contains_key(j));
        let rank = numeric::pivots(values, &[unstated.collect()]).len();
        match &self.mode.independent {
            Some(independent) if chosen.len() < rank => {
                let name = |j: &usize| self.mechanism.speeds[*j].name.clone();
                Err(vec![DerivationObstacle::ImpossibleSpeeds {
                    speeds: independent.iter().map(name).collect(),
                    constraints: self.names(open),
                }])
            }
            _ => Ok(chosen),
        }
    }

    /// Returns the constraints' rows, and as many of solved coordinates as reactions need besides.
    fn reaction_rows(
        &mut self,
        mut rows: Vec<VelocityRow>,
        own: Vec<VelocityRow>,
        stated: &BTreeMap<usize, VelocityRow>,
    ) -> Vec<VelocityRow> {
        let mut more = own;
        for (speed, expression) in stated {
            let one = self.graph.constant(1.0);
            let mut row = expression.clone();
            row.stated = Some(*speed);
            let flip = |graph: &mut Graph, node: Node| graph.negate(node);
            row.slopes = row.slopes.iter().map(|it| flip(self.graph, *it)).collect();
            row.slopes[*speed] = self.graph.add(row.slopes[*speed], one);
            row.rest = flip(self.graph, row.rest);
            more.push(row);
        }
        let n = self.mechanism.speeds.len();
        for row in more {
            let mut all: Vec<Vec<Node>> = rows.iter().map(|it| it.slopes[..n].to_vec()).collect();
            all.push(row.slopes[..n].to_vec());
            let values = self.pose.matrix(self.graph, &all);
            if numeric::pivots(values, &[(0..n).collect()]).len() == all.len() {
                rows.push(row);
            }
        }
        rows
    }

    fn assemble(
        &mut self,
        open: &[VelocityRow],
        chosen: &[(usize, usize)],
        stated: &BTreeMap<usize, VelocityRow>,
        rows: Vec<VelocityRow>,
    ) -> Result<SpeedMap, Vec<DerivationObstacle>> {
        let n = self.mechanism.speeds.len();
        let is_dependent =
            |j: &usize| stated.contains_key(j) || chosen.iter().any(|(_, column)| column == j);
        let (dependent, independent): (Vec<usize>, Vec<usize>) = (0..n).partition(is_dependent);
        let a =
            chosen.iter().map(|(r, _)| chosen.iter().map(|(_, c)| open[*r].slopes[*c]).collect());
        let mut right = Vec::new();
        for (r, _) in chosen {
            let columns = independent.iter().map(|k| open[*r].slopes[*k]).chain([open[*r].rest]);
            right.push(columns.map(|it| self.graph.negate(it)).collect());
        }
        let Some(found) = linear::solve(self.graph, self.pose, a.collect(), right) else {
            return Err(self.dependent(open));
        };
        let is_held =
            |r: &usize| self.most == SlopeKind::Constant && chosen.iter().all(|(row, _)| row != r);
        let held = (0..open.len()).filter(is_held).map(|r| open[r].clone()).collect();
        let mut map = SpeedMap {
            independent,
            dependent,
            slopes: Vec::new(),
            offset: Vec::new(),
            rows,
            open: open.to_vec(),
            chosen: chosen.iter().map(|it| it.1).collect(),
            held,
        };
        let (zero, one) = (self.graph.constant(0.0), self.graph.constant(1.0));
        for j in 0..n {
            let of = |k: &usize| if *k == j { one } else { zero };
            map.slopes.push(map.independent.iter().map(of).collect());
            map.offset.push(zero);
        }
        for ((_, speed), mut values) in chosen.iter().zip(found) {
            map.offset[*speed] = values.pop().unwrap_or(zero);
            map.slopes[*speed] = values;
        }
        self.put_stated(&mut map, stated);
        Ok(map)
    }

    fn put_stated(&mut self, map: &mut SpeedMap, stated: &BTreeMap<usize, VelocityRow>) {
        let others: Vec<usize> =
            map.dependent.iter().copied().filter(|j| !stated.contains_key(j)).collect();
        for (speed, row) in stated {
            let mut offset = vec![(row.rest, 1.0)];
            for d in &others {
                offset.push((self.graph.multiply(row.slopes[*d], map.offset[*d]), 1.0));
            }
            map.offset[*speed] = self.graph.sum(&offset);
            for k in 0..map.independent.len() {
                let own = (row.slopes[map.independent[k]], 1.0);
                let others = others.iter().map(|d| (row.slopes[*d], map.slopes[*d][k]));
                let terms: Vec<_> =
                    others.map(|(x, y)| (self.graph.multiply(x, y), 1.0)).chain([own]).collect();
                map.slopes[*speed][k] = self.graph.sum(&terms);
            }
        }
    }
}

pub(super) fn is_moving(graph: &Graph, node: Node) -> bool {
    graph.depends(node, |place| matches!(place, Place::Coordinate(_) | Place::Input(_)))
}

/// Returns the direction of the speeds' expressions at constant independent speeds.
pub(super) fn along_map(graph: &mut Graph, mechanism: &Mechanism) -> Tangent {
    let coordinates = mechanism.coordinates.iter().enumerate();
    let mut seeds: Vec<_> =
        coordinates.map(|(i, it)| (Place::Coordinate(number(i)), it.rate)).collect();
    for k in 0..2 {
        seeds.push((Place::Input(k), graph.symbol(Place::Input(k + 1))));
    }
    Tangent::new(seeds)
}
