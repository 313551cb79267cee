use documents::quoted;

use super::items::{DescribedItem, FileExpression, FrictionText, ItemKind, LawKind};
use super::linear::is_linear_in_speeds;
use super::names::{LawPlace, distance, number};
use super::reader::{CONSTANT, MOTION, MechanismReader, POSE, STATE};
use crate::kane::graph::{BinaryFunction, Graph, Node, Place, Substitution};
use crate::kane::mechanism::{DryFriction, Force, MechanismContact, STRETCH, SlipKind};
use crate::kane::text::{Dimension, Measured};

#[derive(Clone, Copy, Debug)]
struct FeltParts {
    depth: Measured,
    rate: Measured,
    stiffness: Node,
    exponent: Node,
    damping: Option<Node>,
}

impl MechanismReader {
    pub(super) fn build_law(&mut self, item: &DescribedItem, index: usize, kind: LawKind) {
        let built = match kind {
            LawKind::Spring(at) => self.spring(item).map(|it| (LawPlace::Force(at), it)),
            LawKind::Felt(at) => self.felt(item, "compression").map(|it| (LawPlace::Force(at), it)),
            LawKind::Force(at) => self.force(item).map(|it| (LawPlace::Force(at), it)),
            LawKind::Contact(at) => self.contact(item, at).map(|it| (LawPlace::Contact(at), it)),
            LawKind::Bearing(at) => return self.bearing(item, index, at),
        };
        self.weigh(item.place);
        let Some((place, (force, dimension))) = built else { return };
        self.names.laws.set(index, (place, dimension));
        if let LawPlace::Force(at) = place {
            self.built.forces.push((at, force));
        }
    }

    fn stretch(&mut self, item: &DescribedItem, name: &str) -> Option<(Measured, Measured)> {
        if let Some(file) = item.field(name) {
            let stretch = self.value(file, POSE)?;
            self.watch(file, stretch, None);
            let rate = self.rate_of(file, stretch)?;
            return Some((stretch, rate));
        }
        let [from, to] = item.links.as_slice() else { return None };
        let [from, to] = [from, to].map(|link| self.names.points.index(&link.name));
        let (from, to) = (self.names.points.value(from?)?, self.names.points.value(to?)?);
        let length = match item.field("length") {
            Some(file) => self.node("length", file, CONSTANT, Dimension::LENGTH)?,
            None => self.graph.constant(0.0),
        };
        let apart = distance(&mut self.graph, from.at, to.at);
        let node = self.graph.subtract(apart, length);
        let stretch = Measured { node, dimension: Dimension::LENGTH, reach: POSE };
        let rate = self.names.total_rate(&mut self.graph, stretch).ok()?;
        Some((stretch, rate))
    }

    fn spring(&mut self, item: &DescribedItem) -> Option<(Force, Dimension)> {
        if item.field("stretch").is_none() == item.links.is_empty() {
            let message = format!("{} needs one of stretch and between", quoted(&item.name));
            self.report.miss(
                item.place,
                message,
                "write stretch = \"x - x0\" or between = [\"P\", \"Q\"]",
            );
            return None;
        }
        if item.field("stiffness").is_none() && item.field("damping").is_none() {
            let message = format!("{} has neither stiffness nor damping", quoted(&item.name));
            self.report.miss(item.place, message, "write stiffness = \"…\"");
            return None;
        }
        let (stretch, rate) = self.stretch(item, "stretch")?;
        let tension = Dimension::ENERGY.over(stretch.dimension);
        let zero = self.graph.constant(0.0);
        let mut factor = |name: &str, dimension: Dimension| match item.field(name) {
            Some(file) => self.not_negative(name, file, dimension),
            None => Some(zero),
        };
        let stiffness = factor("stiffness", tension.over(stretch.dimension));
        let damping = factor("damping", tension.over(rate.dimension));
        let (stiffness, damping) = (stiffness?, damping?);
        let graph = &mut self.graph;
        let elastic = graph.multiply(stiffness, stretch.node);
        let viscous = graph.multiply(damping, rate.node);
        let square = graph.product(&[(stiffness, 1), (stretch.node, 2)]);
        let force = Force {
            name: item.name.clone(),
            stretch: stretch.node,
            stretch_rate: rate.node,
            tension: graph.add(elastic, viscous),
            energy: graph.scale(square, 0.5),
            law: None,
        };
        Some((force, tension))
    }

    /// Builds F = k dⁿ (1 + c d'), never below 0; also the law of a contact.
    fn felt(&mut self, item: &DescribedItem, name: &'static str) -> Option<(Force, Dimension)> {
        let (mut depth, mut rate) = self.stretch(item, name)?;
        if name == "gap" {
            depth.node = self.graph.negate(depth.node);
            rate.node = self.graph.negate(rate.node);
        }
        let tension = Dimension::ENERGY.over(depth.dimension);
        let exponent = match item.field("exponent") {
            Some(file) => self.node("exponent", file, CONSTANT, Dimension::NONE)?,
            None => self.graph.constant(1.0),
        };
        // With an exponent that is no number, the stiffness is the force at a depth of 1.
        let stiffness_unit = match self.graph.number(exponent) {
            Some(power) => tension.over(depth.dimension.to(power)),
            None => tension,
        };
        let stiffness = self.not_negative("stiffness", item.field("stiffness")?, stiffness_unit);
        let per_rate = Dimension::NONE.over(rate.dimension);
        let damping = match item.field("damping") {
            Some(file) => Some(self.not_negative("damping", file, per_rate)?),
            None => None,
        };
        let parts = FeltParts { depth, rate, stiffness: stiffness?, exponent, damping };
        Some((felt_force(&mut self.graph, &item.name, &parts), tension))
    }

    fn force(&mut self, item: &DescribedItem) -> Option<(Force, Dimension)> {
        let (stretch, rate) = self.stretch(item, "stretch")?;
        let tension = Dimension::ENERGY.over(stretch.dimension);
        let law = item.field("force")?;
        let force = self.value(law, STATE)?;
        self.watch(law, force, None);
        self.fits("force", law, force, tension).then_some(())?;
        let energy = self.node("energy", item.field("energy")?, POSE, Dimension::ENERGY)?;
        let force = Force {
            name: item.name.clone(),
            stretch: stretch.node,
            stretch_rate: rate.node,
            tension: force.node,
            energy,
            law: None,
        };
        Some((force, tension))
    }

    fn contact(&mut self, item: &DescribedItem, at: usize) -> Option<(Force, Dimension)> {
        let gap = self.value(item.field("gap")?, POSE)?;
        self.fits("gap", item.field("gap")?, gap, Dimension::LENGTH).then_some(())?;
        self.slip(at);
        let (force, dimension) = self.felt(item, "gap")?;
        let sounds = match item.field("sounds") {
            Some(file) => Some(self.node("sounds", file, STATE, Dimension::SPEED)?),
            None => None,
        };
        let scale = self.built.contact_scales.iter().find(|(contact, _)| *contact == at);
        let contact = MechanismContact {
            name: item.name.clone(),
            gap: Some(gap.node),
            scale: scale.map_or(1e-3, |(_, scale)| *scale),
            force: Some(force.clone()),
            friction: None,
            sounds,
        };
        self.built.contacts.push((at, contact));
        Some((force, dimension))
    }

    /// Builds a bearing: its friction alone, with limits that are built after all forces.
    fn bearing(&mut self, item: &DescribedItem, index: usize, at: usize) {
        let Some(slip) = self.slip(at) else { return };
        let dimension = Dimension::POWER.over(slip.dimension);
        self.names.laws.set(index, (LawPlace::Bearing(at), dimension));
        let name = item.name.clone();
        let contact = MechanismContact {
            name,
            gap: None,
            scale: 1.0,
            force: None,
            friction: None,
            sounds: None,
        };
        self.built.contacts.push((at, contact));
    }

    pub(super) fn slip_text(&self, kind: ItemKind) -> Option<&FileExpression> {
        let ItemKind::Law(_, LawKind::Contact(at) | LawKind::Bearing(at)) = kind else {
            return None;
        };
        self.built.frictions.iter().find(|it| it.contact == at)?.slip.as_ref()
    }

    /// Builds the slip of a contact or bearing; `None` without a friction.
    fn slip(&mut self, contact: usize) -> Option<Measured> {
        let text = self.built.frictions.iter().find(|it| it.contact == contact)?;
        let slip = self.value(&text.slip.clone()?, STATE)?;
        self.names.slips.insert(contact, slip);
        Some(slip)
    }

    /// Builds frictions with their limits, which may contain the forces of all springs and contacts.
    pub(super) fn build_frictions(&mut self) {
        for text in std::mem::take(&mut self.built.frictions) {
            let Some(friction) = self.friction(&text) else { continue };
            let found = self.built.contacts.iter_mut().find(|(at, _)| *at == text.contact);
            if let Some((_, contact)) = found {
                contact.friction = Some(friction);
            }
        }
    }

    fn friction(&mut self, text: &FrictionText) -> Option<DryFriction> {
        let slip_file = text.slip.as_ref()?;
        let slip = *self.names.slips.get(&text.contact)?;
        if !is_linear_in_speeds(&self.graph, slip.node) {
            let message = format!("the slip of {} is not linear in the speeds", quoted(&text.name));
            self.report.say(
                slip_file.place,
                message,
                "write the speed of one surface on the other",
            );
            return None;
        }
        let limit = Dimension::POWER.over(slip.dimension);
        let stiction_file = text.stiction.as_ref()?;
        let stiction = self.limit("stiction", stiction_file, limit)?;
        let kinetic = match &text.kinetic {
            Some(file) => self.limit("kinetic", file, limit)?,
            None => stiction,
        };
        let (name, scales) = (text.name.clone(), text.scales);
        let kind = SlipKind::Speed;
        Some(DryFriction { name, slip: slip.node, stiction, kinetic, scales, kind })
    }

    fn limit(&mut self, name: &str, file: &FileExpression, limit: Dimension) -> Option<Node> {
        let node = self.node(name, file, MOTION, limit)?;
        self.limit_value(name, file, node, f64::INFINITY);
        let mut all = self.forces_acting(|_| true);
        Some(all.of(&mut self.graph, node))
    }

    /// Replaces the names of forces by their tensions: 0 for an inactive force.
    pub(super) fn forces_acting(&mut self, acts: impl Fn(usize) -> bool) -> Substitution {
        let zero = self.graph.constant(0.0);
        let tension = |(at, force): &(usize, Force)| {
            (Place::Extra(number(*at)), if acts(*at) { force.tension } else { zero })
        };
        Substitution::new(self.built.forces.iter().map(tension).collect::<Vec<_>>())
    }
}

impl FeltParts {
    fn pressed(graph: &mut Graph, depth: Node) -> Node {
        let zero = graph.constant(0.0);
        graph.binary(BinaryFunction::Max, depth, zero)
    }

    fn tension(&self, graph: &mut Graph, [depth, rate]: [Node; 2]) -> Node {
        let pressed = Self::pressed(graph, depth);
        let power = graph.binary(BinaryFunction::Power, pressed, self.exponent);
        let elastic = graph.multiply(self.stiffness, power);
        let Some(damping) = self.damping else { return elastic };
        let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
        let loss = graph.multiply(damping, rate);
        let factor = graph.add(one, loss);
        let factor = graph.binary(BinaryFunction::Max, factor, zero);
        graph.multiply(elastic, factor)
    }
}

fn felt_force(graph: &mut Graph, name: &str, parts: &FeltParts) -> Force {
    let FeltParts { depth, rate, stiffness, exponent, .. } = *parts;
    let tension = parts.tension(graph, [depth.node, rate.node]);
    let symbols = STRETCH.map(|place| graph.symbol(place));
    let law = Some(parts.tension(graph, symbols));
    let pressed = FeltParts::pressed(graph, depth.node);
    let one = graph.constant(1.0);
    let above = graph.add(exponent, one);
    let higher = graph.binary(BinaryFunction::Power, pressed, above);
    let energy = graph.product(&[(stiffness, 1), (higher, 1), (above, -1)]);
    let (stretch, stretch_rate) = (depth.node, rate.node);
    Force { name: name.to_owned(), stretch, stretch_rate, tension, energy, law }
}

pub(super) const fn law_keys(kind: LawKind) -> &'static [&'static str] {
    match kind {
        LawKind::Spring(_) => &["stretch", "length", "stiffness", "damping"],
        LawKind::Felt(_) => &["compression", "stiffness", "exponent", "damping"],
        LawKind::Force(_) => &["stretch", "force", "energy"],
        LawKind::Contact(_) => &["gap", "stiffness", "exponent", "damping", "sounds"],
        LawKind::Bearing(_) => &[],
    }
}

pub(super) const fn needed_keys(kind: LawKind) -> &'static [&'static str] {
    match kind {
        LawKind::Spring(_) => &[],
        LawKind::Felt(_) => &["compression", "stiffness"],
        LawKind::Force(_) => &["stretch", "force", "energy"],
        LawKind::Contact(_) => &["gap", "stiffness"],
        LawKind::Bearing(_) => &["slip", "stiction"],
    }
}
