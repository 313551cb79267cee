//! Mechanical form of a mode: mass matrix, forces, and the slopes of its compliant elements.

use instruments::equations::table::MechanicsLayout as Layout;
use pode::MAX_SPEEDS;

use super::equations::ModeScope;
use super::explicit::ExplicitForms;
use super::kinematics::number;
use crate::kane::graph::{Graph, Node, Place, Substitution, Tangent};
use crate::kane::mechanism::{Force, STRETCH};
use crate::kane::system::{ApartForce, EntryRole, MechanicalEquations, PressedForce};

/// Lower triangles of stiffness and damping, with the stiffness rows.
struct ElementSums {
    stiffness: Vec<Vec<(Node, f64)>>,
    damping: Vec<Vec<(Node, f64)>>,
    slopes: Vec<((usize, usize), Node)>,
}

impl ElementSums {
    fn new(speeds: usize) -> Self {
        let packed = vec![Vec::new(); Layout::packed(speeds)];
        Self { stiffness: packed.clone(), damping: packed, slopes: Vec::new() }
    }

    fn finish(&self, graph: &mut Graph) -> Vec<Node> {
        self.stiffness.iter().chain(&self.damping).map(|terms| graph.sum(terms)).collect()
    }
}

/// Slopes of an element by speeds and coordinates.
struct ElementSlopes {
    tension: Node,
    /// Slopes of the stretch's rate by the speeds.
    row: Vec<Node>,
    /// Slopes of the tension by the coordinates, and by the speeds.
    stiffness: Vec<Node>,
    damping: Vec<Node>,
}

impl ElementSlopes {
    /// Returns what the element adds to forces, stiffness and damping, then its stiffness row.
    fn added(&self, graph: &mut Graph, speeds: usize) -> Vec<Node> {
        let mut sums = ElementSums::new(speeds);
        enter(graph, &mut sums, self);
        let mut values = Vec::new();
        for slope in &self.row {
            let pull = graph.multiply(self.tension, *slope);
            values.push(graph.negate(pull));
        }
        values.extend(sums.finish(graph));
        values.extend(&self.stiffness);
        values
    }
}

impl ModeScope<'_> {
    /// Returns the mechanical form; `None` if a coordinate's rate is a mixture of speeds, or if
    /// multipliers or plain equations move a speed.
    pub(super) fn mechanical(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        is_free: &[bool],
    ) -> Option<MechanicalEquations> {
        let motion = self.motion();
        let independent = &motion.speeds.independent;
        let speeds: Vec<Place> =
            motion.dynamic.iter().map(|k| Place::Speed(number(independent[*k]))).collect();
        if !motion.speeds.held.is_empty() || speeds.is_empty() || speeds.len() > MAX_SPEEDS {
            return None;
        }
        let roles = self.roles(graph, forms, (is_free, &speeds))?;
        let places = coordinates(self.state, &roles, speeds.len());
        let internal = self.internal(graph, forms, (&roles, &speeds));
        let mut sums = ElementSums::new(speeds.len());
        let all: Vec<_> = self.mode().forces.iter().map(|f| &self.mechanism.forces[*f]).collect();
        for (element, force) in all.into_iter().enumerate() {
            let slopes = slopes(graph, forms, force, (&speeds, &places));
            enter(graph, &mut sums, &slopes);
            let rows = slopes.stiffness.iter().enumerate().filter(|(_, it)| !graph.is_zero(**it));
            sums.slopes.extend(rows.map(|(k, it)| ((element, k), *it)));
        }
        let mut values = internal.iter().map(|it| it.1).collect::<Vec<_>>();
        for (row, entries) in motion.mass.iter().enumerate() {
            values.extend(entries[..=row].iter().map(|it| forms.finished(graph, *it)));
        }
        values.extend(motion.right.iter().map(|it| forms.finished(graph, *it)));
        values.extend(sums.finish(graph));
        values.extend(sums.slopes.iter().map(|it| it.1));
        let mut ends = Substitution::new(internal.iter().copied());
        let moved = values.split_off(internal.len());
        values.extend(moved.iter().map(|it| ends.of(graph, *it)));
        let contacts = self.pressed(graph, forms, (&speeds, &places), &mut ends);
        Some(MechanicalEquations {
            roles,
            speeds: speeds.len(),
            values,
            slopes: sums.slopes.iter().map(|it| it.0).collect(),
            contacts,
        })
    }

    /// Returns the rate of a coordinate.
    fn rate_of(&self, place: Place) -> Option<Node> {
        let Place::Coordinate(i) = place else { return None };
        Some(self.mechanism.coordinates[usize::from(i)].rate)
    }

    fn entry(&self, place: Place) -> Option<usize> {
        self.state.iter().position(|it| *it == place)
    }

    fn roles(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        (is_free, speeds): (&[bool], &[Place]),
    ) -> Option<Vec<EntryRole>> {
        let mut internals = 0..;
        let mut roles = Vec::new();
        for (place, is_free) in self.state.iter().zip(is_free) {
            let rate = self.rate_of(*place).filter(|_| *is_free);
            let role = if let Some(rate) = rate {
                let rate = forms.finished(graph, rate);
                let own = speeds.iter().position(|it| graph.symbol(*it) == rate);
                own.map(EntryRole::Coordinate).or_else(|| internals.next().map(EntryRole::Internal))
            } else if *is_free {
                speeds.iter().position(|it| it == place).map(EntryRole::Speed)
            } else {
                Some(EntryRole::Slaved)
            };
            roles.push(role?);
        }
        let is_whole = (0..speeds.len()).all(|k| {
            let own = EntryRole::Coordinate(k);
            roles.iter().filter(|it| **it == own).count() <= 1 && self.entry(speeds[k]).is_some()
        });
        is_whole.then_some(roles)
    }

    /// Returns the internal states with their values at the end of the step: of the linear rate
    /// r − b z, with e^(−bh) by its Padé fraction.
    fn internal(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        (roles, speeds): (&[EntryRole], &[Place]),
    ) -> Vec<(Place, Node)> {
        let (one, h) = (graph.constant(1.0), graph.symbol(extra(Layout::STEP)));
        let mut middles = Vec::new();
        for (k, place) in speeds.iter().enumerate() {
            let a = graph.symbol(extra(Layout::ACCELERATION + k));
            let (end, moved) = (graph.symbol(*place), graph.multiply(h, a));
            middles.push((*place, graph.sum(&[(end, 1.0), (moved, -0.5)])));
        }
        let mut middles = Substitution::new(middles);
        let mut ends = Vec::new();
        for (place, role) in self.state.iter().zip(roles) {
            let (EntryRole::Internal(_), Some(rate)) = (role, self.rate_of(*place)) else {
                continue;
            };
            let rate = forms.finished(graph, rate);
            let rate = middles.of(graph, rate);
            let slope = graph.partial(rate, *place);
            let u = graph.multiply(h, slope);
            let square = graph.power(u, 2);
            let under = graph.sum(&[(one, 1.0), (u, -0.5), (square, 1.0 / 12.0)]);
            let rise = graph.product(&[(h, 1), (rate, 1), (under, -1)]);
            let symbol = graph.symbol(*place);
            ends.push((*place, graph.add(symbol, rise)));
        }
        ends
    }

    fn pressed(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        (speeds, places): (&[Place], &[Option<Place>]),
        ends: &mut Substitution,
    ) -> Vec<Option<PressedForce>> {
        let mut all = Vec::new();
        for contact in self.mode().contacts.iter().map(|c| &self.mechanism.contacts[*c]) {
            let pressing = contact.force.as_ref().filter(|_| contact.friction.is_none());
            all.push(pressing.map(|force| {
                let slopes = slopes(graph, forms, force, (speeds, places));
                let added = slopes.added(graph, speeds.len());
                let added = added.iter().map(|it| ends.of(graph, *it)).collect();
                // A contact without a sound may rest.
                let apart = contact
                    .sounds
                    .and_then(|_| self.apart(graph, forms, (force, &slopes), (speeds, places)));
                PressedForce { added, apart }
            }));
        }
        all
    }

    /// Returns a force as one on a single speed; `None` if it presses several, or one whose mass is
    /// coupled to others.
    fn apart(
        &self,
        graph: &mut Graph,
        forms: &mut ExplicitForms,
        (force, slopes): (&Force, &ElementSlopes),
        (speeds, places): (&[Place], &[Option<Place>]),
    ) -> Option<ApartForce> {
        let mut pressed = (0..speeds.len()).filter(|k| !graph.is_zero(slopes.row[*k]));
        let (Some(speed), None) = (pressed.next(), pressed.next()) else { return None };
        places[speed]?;
        let mass = &self.motion().mass;
        let mut others = (0..speeds.len()).filter(|k| *k != speed);
        let is_alone = others.all(|k| {
            let entry = forms.finished(graph, mass[k.max(speed)][k.min(speed)]);
            graph.is_zero(entry)
        });
        let depth = forms.finished(graph, force.stretch);
        let is_driven = |place| matches!(place, Place::Input(_));
        if !is_alone || graph.depends(depth, is_driven) || graph.depends(force.tension, is_driven) {
            return None;
        }
        let law = along_law(graph, force, (speeds, places))?;
        let mass = forms.finished(graph, mass[speed][speed]);
        let mut moved =
            Substitution::new(STRETCH.into_iter().zip([0, 1].map(|at| graph.symbol(extra(at)))));
        Some(ApartForce {
            place: [depth, slopes.row[speed], mass],
            law: law.map(|it| moved.of(graph, it)),
            speed,
        })
    }
}

pub(in crate::kane) fn extra(index: usize) -> Place {
    Place::Extra(number(index))
}

/// Returns the coordinate of each speed, if it has one.
fn coordinates(state: &[Place], roles: &[EntryRole], speeds: usize) -> Vec<Option<Place>> {
    let own = |k: usize| {
        let is_own = |role: &EntryRole| matches!(role, EntryRole::Coordinate(it) if *it == k);
        Some(state[roles.iter().position(is_own)?])
    };
    (0..speeds).map(own).collect()
}

/// Returns the slopes of a force. The stretch's rate counts as constant along the coordinates: a
/// matter of the geometry's bending, far below the element's stiffness.
fn slopes(
    graph: &mut Graph,
    forms: &mut ExplicitForms,
    force: &Force,
    (speeds, places): (&[Place], &[Option<Place>]),
) -> ElementSlopes {
    let (one, zero) = (graph.constant(1.0), graph.constant(0.0));
    let tension = forms.finished(graph, force.tension);
    let rate = forms.finished(graph, force.stretch_rate);
    let row: Vec<_> = speeds.iter().map(|it| graph.partial(rate, *it)).collect();
    let has_places = row.iter().zip(places).all(|(it, at)| at.is_some() || graph.is_zero(*it));
    let along = along_stretch(graph, force, (speeds, places)).filter(|_| has_places);
    if let Some(along) = along {
        let [stiffness, damping] = along.map(|it| {
            let along = forms.finished(graph, it);
            row.iter().map(|it| graph.multiply(along, *it)).collect()
        });
        return ElementSlopes { tension, row, stiffness, damping };
    }
    let damping = speeds.iter().map(|it| graph.partial(tension, *it)).collect();
    let mut stiffness = Vec::new();
    for place in places {
        stiffness.push(place.map_or(zero, |place| {
            Tangent::new([(place, one)]).with_constant(graph, rate).of(graph, tension)
        }));
    }
    ElementSlopes { tension, row, stiffness, damping }
}

/// Returns the slopes of a tension by its stretch and the stretch's rate; `None` if it depends on
/// the motion in another way.
fn along_stretch(
    graph: &mut Graph,
    force: &Force,
    motion: (&[Place], &[Option<Place>]),
) -> Option<[Node; 2]> {
    let [_, slopes @ ..] = along_law(graph, force, motion)?;
    let own = [force.stretch, force.stretch_rate];
    let mut back = Substitution::new(STRETCH.into_iter().zip(own));
    Some(slopes.map(|it| back.of(graph, it)))
}

/// Returns a tension with its stretch and the stretch's rate replaced by [`STRETCH`], as far as they
/// are found in it.
fn over_stretch(graph: &mut Graph, force: &Force) -> Node {
    let mut by_stretch = Substitution::new([]);
    for (node, place) in [force.stretch, force.stretch_rate].into_iter().zip(STRETCH) {
        let symbol = graph.symbol(place);
        if graph.number(node).is_none() {
            by_stretch.set_within_sums(graph, node, symbol);
        }
    }
    by_stretch.of(graph, force.tension)
}

/// Returns a tension over [`STRETCH`], and its slopes by both; `None` if it depends on the motion in
/// another way.
fn along_law(
    graph: &mut Graph,
    force: &Force,
    (speeds, places): (&[Place], &[Option<Place>]),
) -> Option<[Node; 3]> {
    let tension = force.law.unwrap_or_else(|| over_stretch(graph, force));
    let moves = |place: Place| {
        matches!(place, Place::Speed(_) | Place::Acceleration(_))
            || speeds.contains(&place)
            || places.contains(&Some(place))
    };
    if graph.depends(tension, moves) {
        return None;
    }
    let [by_depth, by_rate] = STRETCH.map(|place| graph.partial(tension, place));
    Some([tension, by_depth, by_rate])
}

/// Adds the products of row and slopes to the lower triangles.
fn enter(graph: &mut Graph, sums: &mut ElementSums, slopes: &ElementSlopes) {
    let mut at = 0;
    for (i, row) in slopes.row.iter().enumerate() {
        for j in 0..=i {
            let both = [slopes.stiffness[j], slopes.damping[j]];
            let [stiffness, damping] = both.map(|it| (graph.multiply(*row, it), 1.0));
            sums.stiffness[at].push(stiffness);
            sums.damping[at].push(damping);
            at += 1;
        }
    }
}
