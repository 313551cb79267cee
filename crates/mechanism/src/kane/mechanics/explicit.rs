use std::collections::BTreeSet;

use super::error::DerivationObstacle;
use super::inertia::{InertiaTerms, gradient};
use super::kinematics::{along_places, number};
use super::motion::ModeMotion;
use crate::kane::graph::{Graph, Node, Place, Substitution, Tangent};
use crate::kane::mechanism::{Mechanism, Mode};

/// Expressions of a mode without accelerations, reactions and dependent entries, and their rates.
///
/// The frictions of the contacts `rubbing` act and have a symbol; the others are 0.
#[derive(Debug)]
pub(super) struct ExplicitForms {
    known: Substitution,
    finish: Substitution,
    /// Direction of the motion, with pressing contacts.
    motion: Tangent,
    undetermined: BTreeSet<u16>,
}

impl ExplicitForms {
    pub(super) fn of(
        graph: &mut Graph,
        mechanism: &Mechanism,
        inertia: &InertiaTerms,
        mode: &Mode,
        motion: &ModeMotion,
        rubbing: &[usize],
    ) -> Self {
        let zero = graph.constant(0.0);
        let mut accelerations = motion.accelerations.clone();
        let mut reactions = motion.reactions.clone();
        let mut known = Vec::new();
        for c in 0..mechanism.contacts.len() {
            let pressing = pressing(graph, mechanism, mode, c);
            known.push((Place::Contact(number(c)), pressing.map_or(zero, |it| it.0)));
            let rubbing = rubbing.contains(&c).then(|| friction(graph, mechanism, c)).flatten();
            known.push((Place::Friction(number(c)), rubbing.map_or(zero, |it| it.0)));
            for (force, rate) in pressing.into_iter().chain(rubbing) {
                let slopes = gradient(graph, mechanism, rate);
                let response = motion.response(graph, inertia, &slopes);
                let all = accelerations.iter_mut().zip(response.accelerations);
                add(graph, all.collect(), force);
                let determined = reactions
                    .iter_mut()
                    .filter_map(|(k, it)| it.as_mut().zip(response.reactions.get(k).copied()));
                add(graph, determined.collect(), force);
            }
        }
        let mut undetermined = BTreeSet::new();
        for k in 0..mechanism.constraints.len() {
            let reaction = reactions.get(&k).copied().unwrap_or(Some(zero));
            if reaction.is_none() {
                undetermined.insert(number(k));
            }
            known.push((Place::Reaction(number(k)), reaction.unwrap_or(zero)));
        }
        let numbered = accelerations.iter().enumerate();
        known.extend(numbered.map(|(j, it)| (Place::Acceleration(number(j)), *it)));
        Self {
            known: Substitution::new(known),
            finish: motion.finishing(),
            motion: along_motion(graph, mechanism, &accelerations),
            undetermined,
        }
    }

    pub(super) fn value(&mut self, graph: &mut Graph, node: Node) -> Node {
        let known = self.known.of(graph, node);
        self.finish.of(graph, known)
    }

    /// Returns `node`, which has no accelerations and reactions, without dependent entries.
    pub(super) fn finished(&mut self, graph: &mut Graph, node: Node) -> Node {
        self.finish.of(graph, node)
    }

    pub(super) fn rate(&mut self, graph: &mut Graph, node: Node) -> Node {
        let known = self.known.of(graph, node);
        let rate = self.motion.of(graph, known);
        self.finish.of(graph, rate)
    }

    pub(super) fn obstacle(
        &self,
        graph: &Graph,
        mechanism: &Mechanism,
        node: Node,
    ) -> Option<DerivationObstacle> {
        let missing = self
            .undetermined
            .iter()
            .find(|k| graph.depends(node, |place| place == Place::Reaction(**k)))?;
        let constraint = mechanism.constraints[usize::from(*missing)].name.clone();
        Some(DerivationObstacle::UndeterminedReaction { constraint })
    }
}

/// Returns the friction force of a contact, as its symbol, and its slip.
fn friction(graph: &mut Graph, mechanism: &Mechanism, contact: usize) -> Option<(Node, Node)> {
    let slip = mechanism.contacts[contact].friction.as_ref()?.slip;
    Some((graph.symbol(Place::Friction(number(contact))), slip))
}

fn pressing(
    graph: &mut Graph,
    mechanism: &Mechanism,
    mode: &Mode,
    contact: usize,
) -> Option<(Node, Node)> {
    let described = &mechanism.contacts[contact];
    let (Some(gap), Some(force)) = (described.gap, &described.force) else { return None };
    if !mode.contacts.contains(&contact) {
        return None;
    }
    let zero = graph.constant(0.0);
    let rate = along_places(graph, mechanism).of(graph, gap);
    Some((graph.select(gap, zero, force.tension), rate))
}

fn add(graph: &mut Graph, entries: Vec<(&mut Node, Node)>, force: Node) {
    for (entry, by) in entries {
        let more = graph.multiply(by, force);
        *entry = graph.add(*entry, more);
    }
}

fn along_motion(graph: &mut Graph, mechanism: &Mechanism, accelerations: &[Node]) -> Tangent {
    let coordinates = mechanism.coordinates.iter().enumerate();
    let mut seeds: Vec<_> =
        coordinates.map(|(i, it)| (Place::Coordinate(number(i)), it.rate)).collect();
    seeds.extend(accelerations.iter().enumerate().map(|(j, it)| (Place::Speed(number(j)), *it)));
    for k in 0..3 {
        seeds.push((Place::Input(k), graph.symbol(Place::Input(k + 1))));
    }
    Tangent::new(seeds)
}
