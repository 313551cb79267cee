use documents::quoted;
use documents::toml::{KeyReader, TomlEntry, TomlKind, list};

use super::declare::{AT, ORIGIN, zero};
use super::items::{DescribedItem, FileExpression, ItemLink, LinkKind};
use super::reader::{CONSTANT, MechanismReader, POSE};
use super::world_frame::{WorldFrame, WorldPoint};
use crate::kane::graph::{Node, Place};
use crate::kane::mechanism::{ReferenceFrame, RigidBody};
use crate::kane::text::Dimension;

pub(super) fn ground() -> ReferenceFrame {
    ReferenceFrame { name: "ground".to_owned(), parent: 0, origin: [None; 3], turn: None }
}

impl MechanismReader {
    /// Returns the frame that `link` names; the ground without a link.
    fn parent(&mut self, link: Option<&ItemLink>) -> Option<WorldFrame> {
        let Some(link) = link else { return self.names.frames.value(0) };
        let Some(index) = self.names.frames.index(&link.name) else {
            let message = format!("there is no frame {}", quoted(&link.name));
            let help = self.names.frames.choice(&link.name);
            self.report.say(link.place, message, help);
            return None;
        };
        self.names.frames.value(index)
    }

    /// Returns up to three lengths; `None` for one that is 0.
    fn lengths(
        &mut self,
        item: &DescribedItem,
        names: [&'static str; 3],
    ) -> Option<[Option<Node>; 3]> {
        let mut all = [None; 3];
        for (slot, name) in all.iter_mut().zip(names) {
            let Some(file) = item.field(name) else { continue };
            let node = self.node(names[0], file, POSE, Dimension::LENGTH)?;
            *slot = (!self.graph.is_zero(node)).then_some(node);
        }
        Some(all)
    }

    fn filled(&mut self, all: [Option<Node>; 3]) -> [Node; 3] {
        let zero = zero(&mut self.graph).node;
        all.map(|it| it.unwrap_or(zero))
    }

    pub(super) fn build_frame(&mut self, item: &DescribedItem, index: usize, axis: usize) {
        let Some(parent) = self.parent(item.links.first()) else { return };
        let Some(origin) = self.lengths(item, ORIGIN) else { return };
        let turn = match item.field("turn") {
            None => None,
            Some(file) => match self.node("turn", file, POSE, Dimension::NONE) {
                None => return,
                Some(angle) => Some((axis, angle)),
            },
        };
        if let Some(frame) = self.mechanism.frames.get_mut(index) {
            *frame = ReferenceFrame { name: item.name.clone(), parent: parent.index, origin, turn };
        }
        let at = self.filled(origin);
        let world = parent.child(&mut self.graph, index, at, turn);
        self.weigh(item.place);
        self.names.frames.set(index, world);
    }

    pub(super) fn build_point(&mut self, item: &DescribedItem, index: usize) {
        let Some(frame) = self.parent(item.links.first()) else { return };
        let Some(at) = self.lengths(item, AT) else { return };
        let at = self.filled(at);
        let world = frame.point(&mut self.graph, at);
        self.weigh(item.place);
        let is_moving = |place| matches!(place, Place::Coordinate(_) | Place::Input(_));
        let moves = world.iter().any(|node| self.graph.depends(*node, is_moving));
        let reach = if moves { POSE } else { CONSTANT };
        self.names.points.set(index, WorldPoint { at: world, reach });
        if let Some(place) = self.point_places.get_mut(index) {
            *place = Some((frame.index, at));
        }
    }

    pub(super) fn bodies(&mut self, root: &mut KeyReader<'_>) {
        let gravity = self.triple(root, "gravity");
        self.mechanism.masses.gravity = gravity.map(|file| {
            let file = file?;
            let node = self.node("gravity", &file, CONSTANT, Dimension::ACCELERATION)?;
            (!self.graph.is_zero(node)).then_some(node)
        });
        for entry in root.table(&mut self.report, "bodies") {
            self.body(entry);
        }
    }

    fn body(&mut self, entry: &TomlEntry) {
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        let frame = self.link(&mut keys, LinkKind::Frame, "frame");
        let mass = self.field(&mut keys, "mass");
        if keys.take("mass").is_none() {
            let message = format!("the body {} has no mass", quoted(&entry.name));
            self.report.miss(entry.place, message, "write mass = \"0.1 kg\"");
        }
        let centre = self.triple(&mut keys, "centre");
        let inertia = self.inertia_texts(&mut keys);
        let about = keys.text(&mut self.report, "about");
        keys.finish(&mut self.report);
        let about_origin = match about {
            None | Some(("centre", _)) => false,
            Some(("origin", _)) => true,
            Some((other, place)) => {
                let message = format!("there is no {} to take inertia about", quoted(other));
                self.report.say(place, message, "use centre or origin; without it centre");
                false
            }
        };
        let Some(frame) = self.parent(frame.as_ref()) else { return };
        let mass = mass.and_then(|it| {
            let value = self.value(&it, CONSTANT)?;
            self.watch(&it, value, None);
            self.fits("mass", &it, value, Dimension::MASS).then_some(value.node)
        });
        let centre = centre.map(|file| self.optional("centre", &file?, Dimension::LENGTH));
        let inertia = inertia.map(|file| self.optional("inertia", &file?, Dimension::INERTIA));
        let Some(mass) = mass else { return };
        let inertia = if about_origin { self.shifted(mass, centre, inertia) } else { inertia };
        let (name, frame) = (entry.name.clone(), frame.index);
        self.mechanism.masses.bodies.push(RigidBody { name, frame, mass, centre, inertia });
    }

    /// Returns a value over the parameters; `None` for one that is 0.
    fn optional(
        &mut self,
        name: &str,
        file: &FileExpression,
        dimension: Dimension,
    ) -> Option<Node> {
        let node = self.node(name, file, CONSTANT, dimension)?;
        (!self.graph.is_zero(node)).then_some(node)
    }

    /// Reads one moment about z, or xx, yy, zz, xy, yz, zx.
    fn inertia_texts(&mut self, keys: &mut KeyReader<'_>) -> [Option<FileExpression>; 6] {
        let mut all = [const { None }; 6];
        let Some(entry) = keys.take("inertia") else { return all };
        if !matches!(entry.node.kind, TomlKind::List(_)) {
            all[2] = self.written("inertia", &entry.node);
            return all;
        }
        let items = list(&mut self.report, "inertia", &entry.node);
        if items.len() != 6 {
            let message = format!("the inertia has {} values", items.len());
            let help = "give one, about z, or six: xx, yy, zz, xy, yz, zx";
            self.report.say(entry.place, message, help);
            return all;
        }
        for (slot, item) in all.iter_mut().zip(items) {
            *slot = self.written("inertia", item);
        }
        all
    }

    /// Moves the inertia from the frame's origin to the mass centre: I − m (|c|² − c cᵀ).
    fn shifted(
        &mut self,
        mass: Node,
        centre: [Option<Node>; 3],
        inertia: [Option<Node>; 6],
    ) -> [Option<Node>; 6] {
        let centre = self.filled(centre);
        let graph = &mut self.graph;
        let mut all = [None; 6];
        for (index, old) in inertia.into_iter().enumerate() {
            let (first, second) = ((index + 1) % 3, (index + 2) % 3);
            let moved = if index < 3 {
                let (a, b) = (graph.power(centre[first], 2), graph.power(centre[second], 2));
                let square = graph.add(a, b);
                graph.multiply(mass, square)
            } else {
                let (a, b) = (centre[index - 3], centre[(index - 2) % 3]);
                let product = graph.product(&[(mass, 1), (a, 1), (b, 1)]);
                graph.negate(product)
            };
            // Missing moments stay missing: a planar mechanism has zz only.
            all[index] = old.map(|old| graph.subtract(old, moved));
        }
        all
    }
}
