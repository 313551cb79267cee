use super::balance::BalanceTerms;
use super::contact::ContactScope;
use super::error::DerivationObstacle;
use super::explicit::ExplicitForms;
use super::generalised::inner;
use super::inertia::{InertiaTerms, gradient};
use super::motion::ModeMotion;
use super::projection::Projection;
use super::reset::ResetScope;
use crate::kane::graph::{Graph, Node, Place};
use crate::kane::mechanism::{ContactFamily, Guard, GuardBranch, Mechanism, Mode, Target};
use crate::kane::system::{GuardEquations, ImpactEquations, ModeEquations, Way};

pub(super) struct ModeScope<'a> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) inertia: &'a InertiaTerms,
    pub(super) motions: &'a [ModeMotion],
    pub(super) number: usize,
    pub(super) state: &'a [Place],
}

/// Returns the obstacles of forces and plain equations that depend on accelerations or reactions.
pub(super) fn implicit(
    graph: &Graph,
    mechanism: &Mechanism,
    mode: &Mode,
) -> Vec<DerivationObstacle> {
    let is_implicit = |node: Node| {
        graph.depends(node, |place| {
            matches!(
                place,
                Place::Acceleration(_)
                    | Place::Reaction(_)
                    | Place::Contact(_)
                    | Place::Friction(_)
            )
        })
    };
    let forces = mode.forces.iter().map(|f| &mechanism.forces[*f]);
    let forces = forces.map(|it| (it.name.clone(), vec![it.stretch_rate, it.tension, it.energy]));
    let rates = mode.equations.iter();
    let rates = rates.map(|(j, node)| (format!("{}'", mechanism.speeds[*j].name), vec![*node]));
    let found =
        forces.chain(rates).filter(|(_, nodes)| nodes.iter().any(|node| is_implicit(*node)));
    found.map(|(what, _)| DerivationObstacle::ImplicitForce { what }).collect()
}

impl ModeScope<'_> {
    pub(super) const fn motion(&self) -> &ModeMotion {
        &self.motions[self.number]
    }

    pub(super) fn mode(&self) -> &Mode {
        &self.mechanism.modes[self.number]
    }

    pub(super) fn equations(
        &self,
        graph: &mut Graph,
    ) -> Result<ModeEquations, Vec<DerivationObstacle>> {
        let (mechanism, mode, motion) = (self.mechanism, self.mode(), self.motion());
        let mut forms = ExplicitForms::of(graph, mechanism, self.inertia, mode, motion, &[]);
        self.check(graph, &forms)?;
        let mut equations = ModeEquations::default();
        self.move_state(graph, &mut forms, &mut equations);
        self.project(graph, &mut equations);
        equations.mechanical = self.mechanical(graph, &mut forms, &equations.is_free);
        let scope = ContactScope { mechanism, inertia: self.inertia, motion, state: self.state };
        equations.contacts = scope.all(graph, &mut forms, mode);
        let stated = mode.readout.or(mechanism.input.readout);
        let readout = stated.or(motion.driving).map(|it| forms.value(graph, it));
        let rate = graph.symbol(Place::Input(1));
        equations.readout = readout;
        let balance = BalanceTerms::of(graph, mechanism, self.inertia, mode);
        let driven = readout.map(|it| (graph.multiply(it, rate), 1.0));
        let others = motion.motor.into_iter().chain([balance.supplied]);
        let others: Vec<_> = others.map(|it| (forms.value(graph, it), 1.0)).collect();
        let terms: Vec<_> = driven.into_iter().chain(others).collect();
        equations.balance.supplied = Some(graph.sum(&terms));
        equations.balance.energy = Some(forms.value(graph, balance.energy));
        equations.balance.dissipated = Some(forms.value(graph, balance.dissipated));
        let outputs = mechanism.outputs.iter().filter_map(|it| it.values.get(self.number));
        let mut with_friction =
            mechanism.contacts.iter().any(|it| it.friction.is_some()).then(|| {
                ExplicitForms::of(graph, mechanism, self.inertia, mode, motion, &mode.contacts)
            });
        let of_outputs = with_friction.as_mut().unwrap_or(&mut forms);
        equations.outputs = outputs.map(|it| of_outputs.value(graph, *it)).collect();
        equations.impacts = self.impacts(graph, &mut forms);
        equations.guards =
            mode.guards.iter().map(|guard| self.guard(graph, &mut forms, guard)).collect();
        Ok(equations)
    }

    fn check(&self, graph: &Graph, forms: &ExplicitForms) -> Result<(), Vec<DerivationObstacle>> {
        let (mechanism, mode) = (self.mechanism, self.mode());
        let mut obstacles = Vec::new();
        let guards = mode.guards.iter().map(|guard| guard.value);
        let outputs = mechanism.outputs.iter().filter_map(|it| it.values.get(self.number).copied());
        let readout = mode.readout.or(mechanism.input.readout);
        for node in guards.chain(outputs).chain(readout) {
            obstacles.extend(forms.obstacle(graph, mechanism, node));
        }
        if readout.is_none() && self.motion().driving.is_none() {
            let names = mode.constraints.iter().map(|c| mechanism.constraints[*c].name.clone());
            let constraint = names.collect::<Vec<_>>().join(", ");
            obstacles.push(DerivationObstacle::UndeterminedReaction { constraint });
        }
        for guard in &mode.guards {
            self.check_guard(graph, guard, &mut obstacles);
        }
        obstacles.dedup();
        if obstacles.is_empty() { Ok(()) } else { Err(obstacles) }
    }

    fn check_guard(&self, graph: &Graph, guard: &Guard, obstacles: &mut Vec<DerivationObstacle>) {
        if graph.depends(guard.value, |place| place == Place::Input(3)) {
            obstacles.push(DerivationObstacle::TooManyInputRates { what: guard.name.clone() });
        }
        for (target, _) in guard.branches.iter().flat_map(|branch| &branch.set) {
            let (place, name) = match target {
                Target::Coordinate(i) => {
                    let name = &self.mechanism.coordinates[*i].name;
                    (Place::Coordinate(super::kinematics::number(*i)), name)
                }
                Target::Speed(j) => {
                    (Place::Speed(super::kinematics::number(*j)), &self.mechanism.speeds[*j].name)
                }
            };
            if !self.state.contains(&place) {
                obstacles.push(DerivationObstacle::NotInState {
                    guard: guard.name.clone(),
                    name: name.clone(),
                });
            }
        }
    }

    fn move_state(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        equations: &mut ModeEquations,
    ) {
        let motion = self.motion();
        for place in self.state {
            let symbol = graph.symbol(*place);
            let (rate, is_solved) = if let Place::Coordinate(i) = place {
                let i = usize::from(*i);
                (self.mechanism.coordinates[i].rate, motion.solved.contains_key(&i))
            } else if let Place::Speed(j) = place {
                let j = usize::from(*j);
                (motion.accelerations[j], motion.speeds.dependent.contains(&j))
            } else {
                (symbol, true)
            };
            equations.derivative.push(forms.finished(graph, rate));
            equations.slaved.push(motion.finishing().of(graph, symbol));
            equations.is_free.push(!is_solved);
        }
    }

    fn project(&self, graph: &mut Graph, equations: &mut ModeEquations) {
        let projection = Projection::of(graph, self.mechanism, self.mode(), self.motion());
        if projection.drift.is_empty() {
            return;
        }
        equations.projection = self
            .state
            .iter()
            .zip(&equations.slaved)
            .map(|(place, slaved)| projection.moved.get(place).copied().unwrap_or(*slaved))
            .collect();
        equations.drift = projection.drift;
        equations.is_held = !self.motion().speeds.held.is_empty();
    }

    /// Returns the number in the next mode of the guard that closes the contact whose reaction the
    /// `guard` watches, where the branch releases it.
    fn released(&self, graph: &mut Graph, guard: &Guard, branch: &GuardBranch) -> Option<usize> {
        let next = &self.mechanism.modes[branch.to];
        let own = self.mode().constraints.iter().filter(|it| !next.constraints.contains(it));
        let mut own = own.filter(|it| {
            let reaction = Place::Reaction(super::kinematics::number(**it));
            graph.depends(guard.value, |place| place == reaction)
        });
        let zero = self.mechanism.constraints[*own.next()?].zero;
        let gaps = [zero, graph.negate(zero)];
        next.guards.iter().position(|it| gaps.contains(&it.value))
    }

    /// Returns the impacts of the family whose first mode this is.
    fn impacts(&self, graph: &mut Graph, forms: &mut ExplicitForms) -> Option<ImpactEquations> {
        let families = &self.mechanism.instrument.impacts.families;
        let is_own = |it: &&ContactFamily| it.members.first().is_some_and(|it| it.0 == self.number);
        let family = families.iter().find(is_own)?;
        let constraints = family.contacts.iter().map(|it| &self.mechanism.constraints[it.0]);
        let constraints: Vec<_> = constraints.collect();
        let mut meeting: Vec<Node> = Vec::new();
        meeting.extend(constraints.iter().map(|it| forms.value(graph, it.zero)));
        meeting.extend(constraints.iter().map(|it| forms.value(graph, it.rate)));
        meeting.extend(family.contacts.iter().map(|it| forms.value(graph, it.1)));
        let slopes: Vec<_> =
            constraints.iter().map(|it| gradient(graph, self.mechanism, it.rate)).collect();
        let pushed: Vec<_> =
            slopes.iter().map(|it| self.motion().response(graph, self.inertia, it)).collect();
        for i in 0..slopes.len() {
            for j in 0..slopes.len() {
                // One expression for both halves, whatever their rounding.
                let (row, column) = (&slopes[i.max(j)], &pushed[i.min(j)].accelerations);
                let entry = inner(graph, row, column);
                meeting.push(forms.value(graph, entry));
            }
        }
        let zero = graph.constant(0.0);
        let responses = pushed.iter().map(|it| {
            let changes = self.state.iter().map(|place| change(*place, &it.accelerations, zero));
            let nodes = changes.chain([it.driving.unwrap_or(zero)]);
            nodes.map(|node| forms.value(graph, node)).collect()
        });
        let responses = responses.collect();
        Some(ImpactEquations { meeting, responses })
    }

    fn guard(&self, graph: &mut Graph, forms: &mut ExplicitForms, guard: &Guard) -> GuardEquations {
        let scope = ResetScope {
            mechanism: self.mechanism,
            inertia: self.inertia,
            motions: self.motions,
            from: self.number,
            state: self.state,
        };
        let contacts = ContactScope {
            mechanism: self.mechanism,
            inertia: self.inertia,
            motion: self.motion(),
            state: self.state,
        };
        GuardEquations {
            pressed: contacts.pressed(graph, forms, self.mode(), &[guard.value]),
            name: guard.name.clone(),
            unit: guard.unit.clone(),
            value: forms.value(graph, guard.value),
            rate: forms.rate(graph, guard.value),
            scale: guard.scale.unwrap_or(1.0),
            priority: guard.priority,
            fires: guard.fires,
            closes: guard.closes,
            ways: (guard.branches.iter())
                .map(|branch| Way {
                    releases: self.released(graph, guard, branch),
                    ..scope.way(graph, forms, branch)
                })
                .collect(),
            sounds: guard.sounds.map(|it| forms.value(graph, it)),
        }
    }
}

fn change(place: Place, accelerations: &[Node], none: Node) -> Node {
    let Place::Speed(j) = place else { return none };
    accelerations[usize::from(j)]
}
