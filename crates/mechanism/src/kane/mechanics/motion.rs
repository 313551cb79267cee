//! Equations of one mode: mass matrix of its independent speeds, accelerations, and reactions.

use std::collections::{BTreeMap, HashMap};

use super::coordinates::SolvedCoordinates;
use super::error::DerivationObstacle;
use super::generalised::{finishing, forces, inner, times};
use super::inertia::InertiaTerms;
use super::kinematics::number;
use super::linear;
use super::mass_factor::MassFactor;
use super::numeric::NumericPose;
use super::speeds::{SpeedMap, SpeedProblem, along_map};
use crate::kane::graph::{Graph, Node, Place, Substitution};
use crate::kane::mechanism::{Mechanism, Mode};

/// Motion of a mode, over all coordinates, speeds and input, dependent ones included.
#[derive(Debug)]
pub(super) struct ModeMotion {
    pub(super) pose: NumericPose,
    pub(super) solved: BTreeMap<usize, Node>,
    pub(super) speeds: SpeedMap,
    /// Indices of the independent speeds without a plain equation.
    pub(super) dynamic: Vec<usize>,
    pub(super) factor: MassFactor,
    pub(super) accelerations: Vec<Node>,
    /// Reactions of the constraints, by their numbers; `None` where they are undetermined.
    pub(super) reactions: BTreeMap<usize, Option<Node>>,
    pub(super) driving: Option<Node>,
    finish: HashMap<Place, Node>,
}

/// Effect on the motion of a generalised force on the speeds, without other forces.
pub(super) struct Response {
    pub(super) accelerations: Vec<Node>,
    pub(super) driving: Option<Node>,
    pub(super) reactions: BTreeMap<usize, Node>,
}

impl ModeMotion {
    pub(super) fn of(
        graph: &mut Graph,
        pose: &NumericPose,
        mechanism: &Mechanism,
        inertia: &InertiaTerms,
        mode: &Mode,
    ) -> Result<Self, Vec<DerivationObstacle>> {
        let name = |i: &usize| mechanism.coordinates[*i].name.clone();
        let circular = |all: Vec<usize>| {
            vec![DerivationObstacle::CircularSolution {
                coordinates: all.iter().map(name).collect(),
            }]
        };
        let solved = SolvedCoordinates::of(graph, pose, mechanism, mode).map_err(circular)?;
        let mut here = pose.clone();
        solved.place(graph, &mut here);
        super::closing::close(graph, &mut here, mechanism, mode, &solved);
        let mut nearby = here.nearby(mechanism);
        solved.place(graph, &mut nearby);
        super::closing::close(graph, &mut nearby, mechanism, mode, &solved);
        let problem = SpeedProblem {
            graph: &mut *graph,
            pose: &here,
            nearby: &nearby,
            mechanism,
            mode,
            solved: &solved,
        };
        let speeds = problem.solve()?;
        let solved = solved.resolved(graph);
        let finish = finishing(graph, &solved, &speeds);
        let dynamic = (0..speeds.independent.len())
            .filter(|k| !mode.equations.iter().any(|(j, _)| *j == speeds.independent[*k]))
            .collect();
        let mut motion = Self {
            pose: here,
            solved,
            speeds,
            dynamic,
            factor: MassFactor::default(),
            accelerations: Vec::new(),
            reactions: BTreeMap::new(),
            driving: None,
            finish,
        };
        motion.factor = motion.factored(graph, mechanism, inertia)?;
        motion.fill(graph, mechanism, inertia, mode);
        Ok(motion)
    }

    pub(super) fn finishing(&self) -> Substitution {
        Substitution::new(self.finish.iter().map(|(place, node)| (*place, *node)))
    }

    fn factored(
        &self,
        graph: &mut Graph,
        mechanism: &Mechanism,
        inertia: &InertiaTerms,
    ) -> Result<MassFactor, Vec<DerivationObstacle>> {
        let n = mechanism.speeds.len();
        let mut matrix = Vec::new();
        for k in &self.dynamic {
            let column = self.column(*k);
            let moved = times(graph, &inertia.mass, &column, n);
            matrix.push(self.reduced(graph, &moved));
        }
        // One expression for both halves, whatever their rounding.
        let lower = matrix.clone();
        for (i, row) in matrix.iter_mut().enumerate() {
            for (entry, other) in row.iter_mut().zip(&lower).skip(i + 1) {
                *entry = other[i];
            }
        }
        MassFactor::of(graph, &self.pose, matrix).map_err(|row| {
            let speed = self.speeds.independent[self.dynamic[row]];
            vec![DerivationObstacle::Massless { speed: mechanism.speeds[speed].name.clone() }]
        })
    }

    fn column(&self, k: usize) -> Vec<Node> {
        self.speeds.slopes.iter().map(|row| row[k]).collect()
    }

    fn reduced(&self, graph: &mut Graph, force: &[Node]) -> Vec<Node> {
        self.dynamic
            .iter()
            .map(|k| {
                let column = self.column(*k);
                inner(graph, &column, force)
            })
            .collect()
    }

    fn fill(
        &mut self,
        graph: &mut Graph,
        mechanism: &Mechanism,
        inertia: &InertiaTerms,
        mode: &Mode,
    ) {
        let n = mechanism.speeds.len();
        let force = forces(graph, mechanism, inertia, mode);
        let base = self.base(graph, mechanism, mode);
        let mut fixed = base.clone();
        fixed.push(graph.symbol(Place::Input(2)));
        let moved = times(graph, &inertia.mass, &fixed, n);
        let left: Vec<Node> = (0..n).map(|i| graph.subtract(force[i], moved[i])).collect();
        let right = self.reduced(graph, &left);
        let free = self.factor.solve(graph, &right);
        self.accelerations = self.expand(graph, &base, &free);
        let mut all = self.accelerations.clone();
        all.push(graph.symbol(Place::Input(2)));
        let moved = times(graph, &inertia.mass, &all, n + 1);
        let residual: Vec<Node> = (0..=n).map(|i| graph.subtract(moved[i], force[i])).collect();
        let (driving, reactions) = self.reactions_of(graph, &residual);
        self.driving = driving;
        for constraint in &mode.constraints {
            self.reactions
                .insert(*constraint, reactions.as_ref().and_then(|it| it.get(constraint).copied()));
        }
    }

    /// Returns the accelerations where the dynamic ones are 0.
    fn base(&self, graph: &mut Graph, mechanism: &Mechanism, mode: &Mode) -> Vec<Node> {
        let mut tangent = along_map(graph, mechanism);
        let mut all = Vec::new();
        for (j, offset) in self.speeds.offset.iter().enumerate() {
            let mut terms = vec![(tangent.of(graph, *offset), 1.0)];
            for (k, slope) in self.speeds.independent.iter().zip(&self.speeds.slopes[j]) {
                let symbol = graph.symbol(Place::Speed(number(*k)));
                let rate = tangent.of(graph, *slope);
                terms.push((graph.multiply(rate, symbol), 1.0));
                let equation = mode.equations.iter().find(|(speed, _)| speed == k);
                let prescribed = equation.map(|(_, it)| (graph.multiply(*slope, *it), 1.0));
                terms.extend(prescribed);
            }
            all.push(graph.sum(&terms));
        }
        all
    }

    fn expand(&self, graph: &mut Graph, base: &[Node], free: &[Node]) -> Vec<Node> {
        base.iter()
            .zip(&self.speeds.slopes)
            .map(|(base, slopes)| {
                let mut terms = vec![(*base, 1.0)];
                for (k, acceleration) in self.dynamic.iter().zip(free) {
                    terms.push((graph.multiply(slopes[*k], *acceleration), 1.0));
                }
                graph.sum(&terms)
            })
            .collect()
    }

    /// Returns the force that drives the input, and the reactions that balance `residual`, which is
    /// over all speeds and the input's rate.
    fn reactions_of(
        &self,
        graph: &mut Graph,
        residual: &[Node],
    ) -> (Option<Node>, Option<BTreeMap<usize, Node>>) {
        let last = residual.len() - 1;
        let rows = &self.speeds.rows;
        let dependent = &self.speeds.dependent;
        let found = (rows.len() == dependent.len()).then(|| {
            let a = dependent.iter().map(|j| rows.iter().map(|row| row.slopes[*j]).collect());
            let b = dependent.iter().map(|j| vec![residual[*j]]);
            linear::solve(graph, &self.pose, a.collect(), b.collect())
        });
        let Some(values) = found.flatten() else {
            let is_touched = rows.iter().any(|row| !graph.is_zero(row.slopes[last]));
            return ((!is_touched).then_some(residual[last]), None);
        };
        let mut terms = vec![(residual[last], 1.0)];
        let mut reactions = BTreeMap::new();
        for (row, value) in rows.iter().zip(values) {
            terms.push((graph.multiply(row.slopes[last], value[0]), -1.0));
            if let Some(constraint) = row.constraint {
                reactions.insert(constraint, value[0]);
            }
        }
        (Some(graph.sum(&terms)), Some(reactions))
    }

    /// Returns the effect of a generalised force over all speeds and the input's rate.
    pub(super) fn response(
        &self,
        graph: &mut Graph,
        inertia: &InertiaTerms,
        force: &[Node],
    ) -> Response {
        let n = self.speeds.slopes.len();
        let zero = graph.constant(0.0);
        let right = self.reduced(graph, &force[..n]);
        let free = self.factor.solve(graph, &right);
        let accelerations = self.expand(graph, &vec![zero; n], &free);
        let mut all = accelerations.clone();
        all.push(zero);
        let moved = times(graph, &inertia.mass, &all, n + 1);
        let residual: Vec<Node> =
            moved.iter().zip(force).map(|(moved, force)| graph.subtract(*moved, *force)).collect();
        let (driving, reactions) = self.reactions_of(graph, &residual);
        Response { accelerations, driving, reactions: reactions.unwrap_or_default() }
    }

    pub(super) fn reduce(&self, graph: &mut Graph, slopes: &[Node]) -> Vec<Node> {
        self.reduced(graph, &slopes[..self.speeds.slopes.len()])
    }
}
