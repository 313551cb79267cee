//! Equations of one mode: mass matrix of its independent speeds, accelerations, and reactions.

use std::collections::{BTreeMap, HashMap};

use super::coordinates::{SlopeKind, SolvedCoordinates};
use super::error::DerivationObstacle;
use super::generalised::{finishing, forces, inner, times};
use super::inertia::InertiaTerms;
use super::kinematics::number;
use super::linear;
use super::mass_factor::MassFactor;
use super::multipliers::{MultiplierRows, symmetric};
use super::numeric::NumericPose;
use super::sinking;
use super::speeds::{SpeedMap, SpeedProblem, along_map};
use crate::kane::graph::{Graph, Node, Place, Substitution};
use crate::kane::mechanism::{Mechanism, Mode};

/// Motion of a mode, over all coordinates, speeds and input, dependent ones included.
#[derive(Debug)]
pub(super) struct ModeMotion {
    pub(super) pose: NumericPose,
    pub(super) solved: BTreeMap<usize, Node>,
    /// Coordinates that the description states, over those that it does not.
    pub(super) stated: BTreeMap<usize, Node>,
    pub(super) speeds: SpeedMap,
    /// Indices of the independent speeds without a plain equation.
    pub(super) dynamic: Vec<usize>,
    factor: MassFactor,
    /// Mass matrix of the dynamic speeds, and the forces on them without their accelerations.
    pub(super) mass: Vec<Vec<Node>>,
    pub(super) right: Vec<Node>,
    pub(super) held: MultiplierRows,
    pub(super) accelerations: Vec<Node>,
    /// Reactions of the constraints, by their numbers; `None` where they are undetermined.
    pub(super) reactions: BTreeMap<usize, Option<Node>>,
    pub(super) driving: Option<Node>,
    /// Power of what moves by itself: clocks, and surfaces at a stated speed.
    pub(super) motor: Option<Node>,
    finish: HashMap<Place, Node>,
}

/// Effect on the motion of a generalised force on the speeds, without other forces.
pub(super) struct Response {
    pub(super) accelerations: Vec<Node>,
    pub(super) driving: Option<Node>,
    pub(super) motor: Option<Node>,
    pub(super) reactions: BTreeMap<usize, Node>,
}

/// Forces and powers that hold a mode's constraints and prescribed motions.
#[derive(Default)]
struct HoldingForces {
    driving: Option<Node>,
    motor: Option<Node>,
    reactions: Option<BTreeMap<usize, Node>>,
}

impl ModeMotion {
    pub(super) fn of(
        graph: &mut Graph,
        pose: &NumericPose,
        mechanism: &Mechanism,
        inertia: &InertiaTerms,
        mode: &Mode,
    ) -> Result<Self, Vec<DerivationObstacle>> {
        let mut motion = Self::with(graph, pose, (mechanism, mode), SlopeKind::Linear)?;
        if sinking::sinks(graph, (mechanism, mode), &motion.pose, &motion.stated, &motion.speeds) {
            motion = Self::with(graph, pose, (mechanism, mode), SlopeKind::Constant)?;
        }
        motion.factor(graph, mechanism, inertia)?;
        motion.fill(graph, mechanism, inertia, mode);
        Ok(motion)
    }

    /// Returns the motion without accelerations and reactions.
    fn with(
        graph: &mut Graph,
        pose: &NumericPose,
        (mechanism, mode): (&Mechanism, &Mode),
        most: SlopeKind,
    ) -> Result<Self, Vec<DerivationObstacle>> {
        let name = |i: &usize| mechanism.coordinates[*i].name.clone();
        let circular = |all: Vec<usize>| {
            vec![DerivationObstacle::CircularSolution {
                coordinates: all.iter().map(name).collect(),
            }]
        };
        let solved = SolvedCoordinates::of(graph, pose, (mechanism, mode), most);
        let solved = solved.map_err(circular)?;
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
            most,
        };
        let speeds = problem.solve()?;
        super::singular::check(graph, &here, mechanism, mode, &solved)?;
        let SolvedCoordinates { stated, .. } = solved.clone();
        let solved = solved.resolved(graph);
        let finish = finishing(graph, &solved, &speeds);
        let dynamic = (0..speeds.independent.len())
            .filter(|k| !mode.equations.iter().any(|(j, _)| *j == speeds.independent[*k]))
            .collect();
        Ok(Self {
            pose: here,
            solved,
            stated,
            speeds,
            dynamic,
            factor: MassFactor::default(),
            mass: Vec::new(),
            right: Vec::new(),
            held: MultiplierRows::default(),
            accelerations: Vec::new(),
            reactions: BTreeMap::new(),
            driving: None,
            motor: None,
            finish,
        })
    }

    /// Returns `true` for a coordinate or speed that follows from others.
    pub(super) fn is_solved(&self, place: Place) -> bool {
        self.finish.contains_key(&place)
    }

    pub(super) fn finishing(&self) -> Substitution {
        Substitution::new(self.finish.iter().map(|(place, node)| (*place, *node)))
    }

    fn factor(
        &mut self,
        graph: &mut Graph,
        mechanism: &Mechanism,
        inertia: &InertiaTerms,
    ) -> Result<(), Vec<DerivationObstacle>> {
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
        self.mass.clone_from(&matrix);
        let rows: Vec<_> =
            self.speeds.held.iter().map(|row| self.reduce(graph, &row.slopes)).collect();
        let massless = |row: usize| {
            let speed = self.speeds.independent[self.dynamic[row]];
            vec![DerivationObstacle::Massless { speed: mechanism.speeds[speed].name.clone() }]
        };
        self.factor = MassFactor::of(graph, &self.pose, matrix.clone())
            .or_else(
                |row| if rows.is_empty() { Err(row) } else { self.stiffened(graph, matrix, &rows) },
            )
            .map_err(massless)?;
        let constraints = || {
            let names = self.speeds.held.iter().filter_map(|row| row.constraint);
            names.map(|c| mechanism.constraints[c].name.clone()).collect()
        };
        self.held = MultiplierRows::of(graph, &self.pose, &self.factor, rows).map_err(|_row| {
            vec![DerivationObstacle::DependentConstraints { constraints: constraints() }]
        })?;
        Ok(())
    }

    /// Factors the mass matrix with masses added along the held rows, where nothing moves.
    fn stiffened(
        &self,
        graph: &mut Graph,
        mut matrix: Vec<Vec<Node>>,
        rows: &[Vec<Node>],
    ) -> Result<MassFactor, usize> {
        let largest = |all: Vec<f64>| all.iter().fold(0.0, |most, it| f64::max(most, it.abs()));
        let diagonal: Vec<Node> = (0..matrix.len()).map(|k| matrix[k][k]).collect();
        let mass = largest(self.pose.all(graph, &diagonal));
        let mut weights = Vec::new();
        for row in rows {
            weights.push(mass / largest(self.pose.all(graph, row)).powi(2));
        }
        for (i, line) in matrix.iter_mut().enumerate() {
            for (j, entry) in line.iter_mut().enumerate() {
                let added = rows.iter().zip(&weights);
                let added = added.map(|(row, weight)| (graph.multiply(row[i], row[j]), *weight));
                let terms: Vec<_> = added.chain([(*entry, 1.0)]).collect();
                *entry = graph.sum(&terms);
            }
        }
        MassFactor::of(graph, &self.pose, matrix)
    }

    /// Returns the dynamic accelerations by the reduced forces `right`, with `drift` the rates of
    /// the held rows without them.
    fn solve(&self, graph: &mut Graph, right: &[Node], drift: &[Node]) -> Vec<Node> {
        let free = self.factor.solve(graph, right);
        if drift.is_empty() { free } else { self.held.meet(graph, free, drift) }
    }

    /// Returns the dynamic accelerations by the reduced forces `right` alone.
    pub(super) fn answer(&self, graph: &mut Graph, right: &[Node]) -> Vec<Node> {
        let still = vec![graph.constant(0.0); self.speeds.held.len()];
        self.solve(graph, right, &still)
    }

    /// Returns the smallest change of all speeds, by mass, that changes the held rows' rates by
    /// −`rates`.
    pub(super) fn correction(&self, graph: &mut Graph, rates: &[Node]) -> Vec<Node> {
        let zero = graph.constant(0.0);
        let free = self.held.meet(graph, vec![zero; self.dynamic.len()], rates);
        self.expand(graph, &vec![zero; self.speeds.slopes.len()], &free)
    }

    /// Returns the second rates of the held rows' constraints at the accelerations `base`.
    fn held_drift(&self, graph: &mut Graph, mechanism: &Mechanism, base: &[Node]) -> Vec<Node> {
        let mut tangent = along_map(graph, mechanism);
        let mut drift = Vec::new();
        for row in &self.speeds.held {
            let rate = row.rate(graph, mechanism);
            let own = tangent.of(graph, rate);
            let moved = inner(graph, &row.slopes, base);
            drift.push(graph.add(own, moved));
        }
        drift
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
        let drift = self.held_drift(graph, mechanism, &base);
        let free = self.solve(graph, &right, &drift);
        self.accelerations = self.expand(graph, &base, &free);
        self.right = right;
        let mut all = self.accelerations.clone();
        all.push(graph.symbol(Place::Input(2)));
        let moved = times(graph, &inertia.mass, &all, force.len());
        let residual: Vec<Node> =
            moved.iter().zip(&force).map(|(moved, force)| graph.subtract(*moved, *force)).collect();
        let HoldingForces { driving, motor, reactions } = self.holding(graph, &residual);
        (self.driving, self.motor) = (driving, motor);
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

    /// Returns the forces that balance `residual`, which is over all speeds, the input's rate and,
    /// if there are any, the clocks.
    fn holding(&self, graph: &mut Graph, residual: &[Node]) -> HoldingForces {
        let last = self.speeds.slopes.len();
        let zero = graph.constant(0.0);
        let alone = residual.get(last + 1).copied().unwrap_or(zero);
        let rows = &self.speeds.rows;
        let mut still = Substitution::new([(Place::Input(1), zero)]);
        let dependent = &self.speeds.dependent;
        let is_held = !self.speeds.held.is_empty();
        let found = (rows.len() == dependent.len() + self.speeds.held.len()).then(|| {
            if is_held {
                return self.least(graph, residual);
            }
            let a = dependent.iter().map(|j| rows.iter().map(|row| row.slopes[*j]).collect());
            let b = dependent.iter().map(|j| vec![residual[*j]]);
            let found = linear::solve(graph, &self.pose, a.collect(), b.collect())?;
            Some(found.into_iter().map(|it| it[0]).collect())
        });
        let Some(values) = found.flatten() else {
            let is_touched = rows.iter().any(|row| !graph.is_zero(row.slopes[last]));
            let rests: Vec<_> = rows.iter().map(|row| still.of(graph, row.rest)).collect();
            let is_moved = rests.iter().any(|rest| !graph.is_zero(*rest));
            return HoldingForces {
                driving: (!is_touched).then_some(residual[last]),
                motor: (!is_moved).then_some(alone),
                reactions: None,
            };
        };
        let (mut terms, mut powers) = (vec![(residual[last], 1.0)], vec![(alone, 1.0)]);
        let mut reactions = BTreeMap::new();
        for (row, value) in rows.iter().zip(values) {
            terms.push((graph.multiply(row.slopes[last], value), -1.0));
            let rest = still.of(graph, row.rest);
            powers.push((graph.multiply(rest, value), -1.0));
            if let Some(constraint) = row.constraint {
                reactions.insert(constraint, value);
            }
        }
        HoldingForces {
            driving: Some(graph.sum(&terms)),
            motor: Some(graph.sum(&powers)),
            reactions: Some(reactions),
        }
    }

    /// Returns the forces of the rows that balance `residual`, by least squares over all speeds.
    fn least(&self, graph: &mut Graph, residual: &[Node]) -> Option<Vec<Node>> {
        let n = self.speeds.slopes.len();
        let rows: Vec<_> = self.speeds.rows.iter().map(|row| row.slopes[..n].to_vec()).collect();
        let right: Vec<Node> = rows.iter().map(|row| inner(graph, row, residual)).collect();
        let matrix = symmetric(graph, &rows, &rows);
        let factor = MassFactor::of(graph, &self.pose, matrix).ok()?;
        Some(factor.solve(graph, &right))
    }

    /// Returns the effect of a generalised force over all speeds, the input's rate and the clocks.
    pub(super) fn response(
        &self,
        graph: &mut Graph,
        inertia: &InertiaTerms,
        force: &[Node],
    ) -> Response {
        let n = self.speeds.slopes.len();
        let zero = graph.constant(0.0);
        let right = self.reduced(graph, &force[..n]);
        let free = self.answer(graph, &right);
        let accelerations = self.expand(graph, &vec![zero; n], &free);
        let mut all = accelerations.clone();
        all.push(zero);
        let mut residual = times(graph, &inertia.mass, &all, inertia.mass.len());
        residual.resize(residual.len().max(force.len()), zero);
        for (left, force) in residual.iter_mut().zip(force) {
            *left = graph.subtract(*left, *force);
        }
        let HoldingForces { driving, motor, reactions } = self.holding(graph, &residual);
        Response { accelerations, driving, motor, reactions: reactions.unwrap_or_default() }
    }

    pub(super) fn reduce(&self, graph: &mut Graph, slopes: &[Node]) -> Vec<Node> {
        self.reduced(graph, &slopes[..self.speeds.slopes.len()])
    }
}
