use super::inertia::{InertiaTerms, rates};
use super::kinematics::{along_places, number};
use crate::kane::graph::{Graph, Node, Place, Tangent};
use crate::kane::mechanism::{Force, Mechanism, Mode};

/// Energy (J), and powers (W) of a mode, over all coordinates and speeds.
pub(super) struct BalanceTerms {
    pub(super) energy: Node,
    pub(super) dissipated: Node,
    /// Supplied by forces that depend on a clock, where their stretch does not.
    pub(super) supplied: Node,
}

impl BalanceTerms {
    pub(super) fn of(
        graph: &mut Graph,
        mechanism: &Mechanism,
        inertia: &InertiaTerms,
        mode: &Mode,
    ) -> Self {
        let mut tangent = along_places(graph, mechanism);
        let mut energy = vec![(inertia.energy, 1.0)];
        let (mut dissipated, mut supplied) = (Vec::new(), Vec::new());
        let clocks = clocks(graph, mechanism);
        let is_timed = |graph: &Graph, node| graph.depends(node, |place| clocks.contains(&place));
        for force in mode.forces.iter().map(|f| &mechanism.forces[*f]) {
            energy.push((force.energy, 1.0));
            let lost = lost(graph, &mut tangent, mechanism, force);
            if is_timed(graph, force.tension) && !is_timed(graph, force.stretch) {
                supplied.push((lost, -1.0));
            } else {
                dissipated.push((lost, 1.0));
            }
        }
        energy.extend(mode.energy.map(|it| (it, 1.0)));
        dissipated.extend(mode.dissipated.map(|it| (it, 1.0)));
        Self {
            energy: graph.sum(&energy),
            dissipated: graph.sum(&dissipated),
            supplied: graph.sum(&supplied),
        }
    }
}

/// Returns the coordinates whose rates depend on no speed.
fn clocks(graph: &Graph, mechanism: &Mechanism) -> Vec<Place> {
    let is_speed = |place| matches!(place, Place::Speed(_) | Place::Input(_));
    let coordinates = mechanism.coordinates.iter().enumerate();
    let clocks = coordinates.filter(|(_, it)| !graph.depends(it.rate, is_speed));
    clocks.map(|(i, _)| Place::Coordinate(number(i))).collect()
}

/// Returns the power that a force takes from the motion and does not store (W).
pub(super) fn lost(
    graph: &mut Graph,
    tangent: &mut Tangent,
    mechanism: &Mechanism,
    force: &Force,
) -> Node {
    let stored = tangent.of(graph, force.energy);
    // The part of the tension that is the energy's slope, if the stretch's rate is a factor of the
    // stored power: the remainder then has no difference of large terms.
    let slope = graph.divide(stored, force.stretch_rate);
    let places = rates(mechanism);
    if graph.depends(slope, |place| places.contains(&place)) {
        let taken = graph.multiply(force.tension, force.stretch_rate);
        return graph.subtract(taken, stored);
    }
    let left = graph.subtract(force.tension, slope);
    graph.multiply(left, force.stretch_rate)
}
