//! Effect of contacts and frictions on a mode's motion.

use std::collections::BTreeMap;

use super::balance::lost;
use super::explicit::ExplicitForms;
use super::inertia::{InertiaTerms, drift, gradient};
use super::kinematics::{along_places, number};
use super::motion::ModeMotion;
use crate::kane::graph::{Graph, Node, Place, Tangent};
use crate::kane::mechanism::{DryFriction, Mechanism, MechanismContact, Mode};
use crate::kane::system::{ContactEquations, ForceResponse, FrictionEquations};

pub(super) struct ContactScope<'a> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) inertia: &'a InertiaTerms,
    pub(super) motion: &'a ModeMotion,
    pub(super) state: &'a [Place],
}

impl ContactScope<'_> {
    pub(super) fn all(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        mode: &Mode,
    ) -> Vec<ContactEquations> {
        mode.contacts.iter().map(|contact| self.one(graph, forms, mode, *contact)).collect()
    }

    fn one(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        mode: &Mode,
        number: usize,
    ) -> ContactEquations {
        let contact = &self.mechanism.contacts[number];
        let gap = contact.gap.map(|gap| {
            let rate = along_places(graph, self.mechanism).of(graph, gap);
            (gap, rate)
        });
        let normal_response = gap.map(|(_, rate)| self.response(graph, forms, rate));
        ContactEquations {
            contact: number,
            gap: gap.map(|(gap, rate)| [gap, rate].map(|it| forms.value(graph, it))),
            normal: self.normal(graph, forms, contact),
            normal_response: normal_response.unwrap_or_default(),
            sounds: contact.sounds.map(|it| forms.value(graph, it)),
            friction: contact.friction.as_ref().map(|it| self.friction(graph, forms, mode, it)),
        }
    }

    fn normal(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        contact: &MechanismContact,
    ) -> Option<[Node; 3]> {
        let force = contact.force.as_ref()?;
        let mut tangent = along_places(graph, self.mechanism);
        let lost = lost(graph, &mut tangent, self.mechanism, force);
        Some([force.tension, force.energy, lost].map(|it| forms.value(graph, it)))
    }

    /// Returns the contributions of 1 N along `rate`.
    fn response(&self, graph: &mut Graph, forms: &mut ExplicitForms, rate: Node) -> ForceResponse {
        let mut slopes = gradient(graph, self.mechanism, rate);
        slopes.push(drift(graph, self.mechanism, rate));
        let response = self.motion.response(graph, self.inertia, &slopes);
        let zero = graph.constant(0.0);
        let entries = self.state.iter().map(|place| {
            let Place::Speed(j) = place else { return zero };
            forms.value(graph, response.accelerations[usize::from(*j)])
        });
        ForceResponse {
            derivative: entries.collect(),
            readout: response.driving.map(|it| forms.value(graph, it)),
            motor: response.motor.map(|it| forms.value(graph, it)),
        }
    }

    fn friction(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        mode: &Mode,
        friction: &DryFriction,
    ) -> FrictionEquations {
        let slip = forms.value(graph, friction.slip);
        let gradient = self.state.iter().map(|place| graph.partial(slip, *place)).collect();
        let by_time = (0..2).map(|k| (Place::Input(k), graph.symbol(Place::Input(k + 1))));
        let drift = Tangent::new(by_time.collect::<Vec<_>>()).of(graph, slip);
        FrictionEquations {
            slip,
            gradient,
            drift,
            response: self.response(graph, forms, friction.slip),
            stiction: forms.value(graph, friction.stiction),
            kinetic: forms.value(graph, friction.kinetic),
            kept: None,
            pressed: self.pressed(graph, forms, mode, &[friction.stiction, friction.kinetic]),
        }
    }

    /// Returns what 1 N of each friction of the mode adds to `nodes` by the reactions in them, friction
    /// by friction; nothing if all is 0.
    pub(super) fn pressed(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        mode: &Mode,
        nodes: &[Node],
    ) -> Vec<Node> {
        let is_reaction = |place| matches!(place, Place::Reaction(_));
        if !nodes.iter().any(|node| graph.depends(*node, is_reaction)) {
            return Vec::new();
        }
        let contacts = mode.contacts.iter().map(|contact| &self.mechanism.contacts[*contact]);
        let mut all = Vec::new();
        for friction in contacts.filter_map(|contact| contact.friction.as_ref()) {
            let slopes = gradient(graph, self.mechanism, friction.slip);
            let reactions = self.motion.response(graph, self.inertia, &slopes).reactions;
            for node in nodes {
                let sum = added(graph, *node, &reactions);
                all.push(forms.value(graph, sum));
            }
        }
        let is_nothing = all.iter().all(|node| graph.is_zero(*node));
        if is_nothing { Vec::new() } else { all }
    }
}

/// Returns the entries of the state: coordinates, then speeds.
pub(super) fn places(mechanism: &Mechanism, is_kept: impl Fn(Place) -> bool) -> Vec<Place> {
    let coordinates = (0..mechanism.coordinates.len()).map(|i| Place::Coordinate(number(i)));
    let speeds = (0..mechanism.speeds.len()).map(|j| Place::Speed(number(j)));
    coordinates.chain(speeds).filter(|place| is_kept(*place)).collect()
}

/// Returns what `reactions` add to `node`, which is linear in them.
fn added(graph: &mut Graph, node: Node, reactions: &BTreeMap<usize, Node>) -> Node {
    let mut terms = Vec::new();
    for (constraint, reaction) in reactions {
        let slope = graph.partial(node, Place::Reaction(number(*constraint)));
        terms.push((graph.multiply(slope, *reaction), 1.0));
    }
    graph.sum(&terms)
}
