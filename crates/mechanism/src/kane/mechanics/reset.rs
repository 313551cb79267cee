//! Reset maps: values set by the description, changes by rigid impacts, and coordinates of the next
//! mode.
//!
//! First the coordinates are set and projected onto those that the next mode solves; then the
//! speeds change by the impulses of new constraints and of a stated impact, along the mode before.

use std::collections::HashMap;

use super::explicit::ExplicitForms;
use super::generalised::inner;
use super::inertia::InertiaTerms;
use super::kinematics::number;
use super::linear;
use super::motion::ModeMotion;
use super::numeric;
use super::speeds::{VelocityRow, row};
use crate::kane::graph::{Graph, Node, Place, Substitution};
use crate::kane::mechanism::{GuardBranch, Mechanism, Target};
use crate::kane::system::Way;

pub(super) struct ResetScope<'a> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) inertia: &'a InertiaTerms,
    pub(super) motions: &'a [ModeMotion],
    pub(super) from: usize,
    pub(super) state: &'a [Place],
}

/// Condition on the speeds after an impact: rate⁺ = −restitution × rate⁻.
struct ImpactRow {
    row: VelocityRow,
    rate: Node,
    /// Factor 1 + e, with the restitution e.
    change: Node,
}

struct ImpactSolution {
    changes: Vec<Node>,
    impulse: Node,
}

impl ResetScope<'_> {
    pub(super) fn way(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        branch: &GuardBranch,
    ) -> Way {
        let next = &self.motions[branch.to];
        let before = self.before(graph, forms, branch);
        let mut coordinates = before.clone();
        put_in_place(graph, next, &mut coordinates);
        let mut here = Substitution::new(coordinates.iter().map(|(place, node)| (*place, *node)));
        let found = self.impact(graph, branch);
        let mut after = coordinates.clone();
        if let Some(found) = &found {
            for (j, change) in found.changes.iter().enumerate() {
                let place = Place::Speed(number(j));
                let change = here.of(graph, *change);
                let sum = graph.add(before[&place], change);
                after.insert(place, sum);
            }
        }
        let mut end = Substitution::new(after.iter().map(|(place, node)| (*place, *node)));
        let mut slaved = next.finishing();
        let state = self
            .state
            .iter()
            .map(|place| {
                let symbol = graph.symbol(*place);
                let placed = slaved.of(graph, symbol);
                end.of(graph, placed)
            })
            .collect();
        let zero = graph.constant(0.0);
        let impulse = found.map_or(zero, |found| here.of(graph, found.impulse));
        let mut branch = branch.clone();
        branch.when = branch.when.map(|when| forms.value(graph, when));
        Way { branch, state, impulse, releases: None }
    }

    /// Returns every coordinate and speed before the impact, current or set by the description.
    fn before(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        branch: &GuardBranch,
    ) -> HashMap<Place, Node> {
        let mut all = HashMap::new();
        for place in super::contact::places(self.mechanism, |_| true) {
            let symbol = graph.symbol(place);
            all.insert(place, forms.value(graph, symbol));
        }
        for (target, node) in &branch.set {
            let place = match target {
                Target::Coordinate(i) => Place::Coordinate(number(*i)),
                Target::Speed(j) => Place::Speed(number(*j)),
            };
            all.insert(place, forms.value(graph, *node));
        }
        all
    }

    /// Returns the impulses; `None` without new constraints, or if motion is by plain equations.
    fn impact(&self, graph: &mut Graph, branch: &GuardBranch) -> Option<ImpactSolution> {
        let modes = &self.mechanism.modes;
        if !modes[self.from].equations.is_empty() || !modes[branch.to].equations.is_empty() {
            return None;
        }
        let rows = self.rows(graph, branch);
        let motion = &self.motions[self.from];
        let reduced: Vec<Vec<Node>> =
            rows.iter().map(|it| motion.reduce(graph, &it.row.slopes)).collect();
        let (rows, reduced) = self.regular(graph, branch, rows, reduced);
        if rows.is_empty() {
            return None;
        }
        let responses: Vec<Vec<Node>> =
            reduced.iter().map(|row| motion.answer(graph, row)).collect();
        let a = reduced
            .iter()
            .map(|row| responses.iter().map(|response| inner(graph, row, response)).collect());
        let a = a.collect();
        let b = rows.iter().map(|it| {
            let wanted = graph.multiply(it.change, it.rate);
            vec![graph.negate(wanted)]
        });
        let b = b.collect();
        let impulses = linear::solve(graph, &self.motions[branch.to].pose, a, b)?;
        let mut force = vec![graph.constant(0.0); self.mechanism.speeds.len() + 1];
        for (row, impulse) in rows.iter().zip(impulses) {
            for (entry, slope) in force.iter_mut().zip(&row.row.slopes) {
                let more = graph.multiply(*slope, impulse[0]);
                *entry = graph.add(*entry, more);
            }
        }
        let response = motion.response(graph, self.inertia, &force);
        let impulse = response.driving.unwrap_or_else(|| graph.constant(0.0));
        Some(ImpactSolution { changes: response.accelerations, impulse })
    }

    /// Returns the new constraints, then the stated impact.
    fn rows(&self, graph: &mut Graph, branch: &GuardBranch) -> Vec<ImpactRow> {
        let modes = &self.mechanism.modes;
        let one = graph.constant(1.0);
        let entered = std::iter::once(branch.to).chain(branch.impact.and_then(|it| it.within));
        let mut new: Vec<usize> = Vec::new();
        for constraint in entered.flat_map(|mode| modes[mode].constraints.iter().copied()) {
            if !modes[self.from].constraints.contains(&constraint) && !new.contains(&constraint) {
                new.push(constraint);
            }
        }
        let mut rows = Vec::new();
        for constraint in new {
            let rate = self.mechanism.constraints[constraint].rate;
            let row = row(graph, self.mechanism, Some(constraint), rate);
            rows.push(ImpactRow { row, rate, change: one });
        }
        if let Some(impact) = branch.impact {
            let rate = impact.separation;
            let row = row(graph, self.mechanism, None, rate);
            rows.push(ImpactRow { row, rate, change: graph.add(one, impact.restitution) });
        }
        rows
    }

    /// Returns the rows that do not follow from earlier ones.
    fn regular(
        &self,
        graph: &Graph,
        branch: &GuardBranch,
        rows: Vec<ImpactRow>,
        reduced: Vec<Vec<Node>>,
    ) -> (Vec<ImpactRow>, Vec<Vec<Node>>) {
        let pose = &self.motions[branch.to].pose;
        let mut kept = (Vec::new(), Vec::new());
        let mut values = pose.matrix(graph, &self.motions[self.from].held.slopes);
        let rank = |values: &[Vec<f64>], columns: usize| {
            numeric::pivots(values.to_vec(), &[(0..columns).collect()]).len()
        };
        for (row, slopes) in rows.into_iter().zip(reduced) {
            let before = rank(&values, slopes.len());
            values.push(pose.all(graph, &slopes));
            if rank(&values, slopes.len()) > before {
                kept.0.push(row);
                kept.1.push(slopes);
            } else {
                values.pop();
            }
        }
        kept
    }
}

fn put_in_place(graph: &mut Graph, next: &ModeMotion, all: &mut HashMap<Place, Node>) {
    let mut before = Substitution::new(all.iter().map(|(place, node)| (*place, *node)));
    for (i, node) in &next.solved {
        let place = Place::Coordinate(number(*i));
        let value = before.of(graph, *node);
        all.insert(place, value);
    }
}
