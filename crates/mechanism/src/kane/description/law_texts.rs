use documents::quoted;
use documents::toml::{KeyReader, TomlEntry, TomlNode, text};

use super::items::{DescribedItem, FrictionText, ItemKind, ItemLink, LawKind, LinkKind};
use super::laws::{law_keys, needed_keys};
use super::reader::MechanismReader;
use crate::kane::text::{Dependence, Dimension};

impl MechanismReader {
    pub(super) fn declare_laws(&mut self, root: &mut KeyReader<'_>) {
        let (mut forces, mut contacts) = (0, 0);
        for table in ["springs", "felts", "forces"] {
            for entry in root.table(&mut self.report, table) {
                let kind = match table {
                    "springs" => LawKind::Spring(forces),
                    "felts" => LawKind::Felt(forces),
                    _ => LawKind::Force(forces),
                };
                forces += usize::from(self.declare_law(entry, kind));
            }
        }
        for entry in root.table(&mut self.report, "contacts") {
            contacts += usize::from(self.declare_law(entry, LawKind::Contact(contacts)));
        }
        for entry in root.table(&mut self.report, "frictions") {
            contacts += usize::from(self.declare_law(entry, LawKind::Bearing(contacts)));
        }
    }

    pub(super) fn declare_law(&mut self, entry: &TomlEntry, kind: LawKind) -> bool {
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return false };
        let mut fields = Vec::new();
        for name in law_keys(kind) {
            if let Some(field) = self.field(&mut keys, name) {
                fields.push((*name, field));
            }
        }
        let links =
            if matches!(kind, LawKind::Spring(_)) { self.ends(&mut keys) } else { Vec::new() };
        if let LawKind::Contact(at) | LawKind::Bearing(at) = kind {
            self.contact_scale(&mut keys, kind, at);
            self.friction_text(&mut keys, entry, kind);
        }
        for needed in needed_keys(kind) {
            if keys.take(needed).is_none() {
                let message = format!("{} has no {needed}", quoted(&entry.name));
                let help = format!("write {needed} = \"…\"");
                self.report.miss(entry.place, message, help);
            }
        }
        keys.finish(&mut self.report);
        match self.names.laws.declare(&entry.name, entry.place) {
            Ok(index) => {
                let (name, place) = (entry.name.clone(), entry.place);
                let kind = ItemKind::Law(index, kind);
                self.items.push(DescribedItem { kind, name, place, fields, links });
                true
            }
            Err(first) => {
                self.twice(entry, first);
                false
            }
        }
    }

    pub(super) fn ends(&mut self, keys: &mut KeyReader<'_>) -> Vec<ItemLink> {
        let Some(entry) = keys.take("between") else { return Vec::new() };
        let items = entry.node.items().unwrap_or(&[]);
        if items.len() != 2 {
            let help = "write between = [\"P\", \"Q\"]";
            self.report.say(entry.place, "a spring is between two points", help);
            return Vec::new();
        }
        let mut links = Vec::new();
        for item in items {
            let Some((name, place)) = text(&mut self.report, "between", item) else { continue };
            if self.names.points.index(name).is_none() {
                let help = self.names.points.choice(name);
                self.report.say(place, format!("there is no point {}", quoted(name)), help);
            }
            links.push(ItemLink { kind: LinkKind::Point, name: name.to_owned(), place });
        }
        links
    }

    pub(super) fn contact_scale(&mut self, keys: &mut KeyReader<'_>, kind: LawKind, at: usize) {
        if !matches!(kind, LawKind::Contact(_)) {
            return;
        }
        let scale =
            keys.take("scale").and_then(|it| self.constant("scale", &it.node, Dimension::LENGTH));
        self.built.contact_scales.push((at, scale.unwrap_or(1e-3)));
    }

    pub(super) fn friction_text(
        &mut self,
        keys: &mut KeyReader<'_>,
        entry: &TomlEntry,
        kind: LawKind,
    ) {
        match kind {
            LawKind::Bearing(contact) => {
                let text = self.friction_fields(keys, contact, entry.name.clone());
                self.built.frictions.push(text);
            }
            LawKind::Contact(contact) => {
                let Some(friction) = keys.take("friction") else { return };
                let Some(mut keys) = KeyReader::new(&mut self.report, friction) else { return };
                let name = format!("{}_friction", entry.name);
                let text = self.friction_fields(&mut keys, contact, name);
                keys.finish(&mut self.report);
                self.built.frictions.push(text);
            }
            LawKind::Spring(_) | LawKind::Felt(_) | LawKind::Force(_) => {}
        }
    }

    pub(super) fn friction_fields(
        &mut self,
        keys: &mut KeyReader<'_>,
        contact: usize,
        name: String,
    ) -> FrictionText {
        let [slip, stiction, kinetic] =
            ["slip", "stiction", "kinetic"].map(|name| self.field(keys, name));
        let mut scales = (1.0, 1.0);
        if let Some(entry) = keys.take("scales") {
            let numbers = entry.node.items().unwrap_or(&[]);
            let mut all = [1.0, 1.0];
            for (slot, node) in all.iter_mut().zip(numbers) {
                *slot = self.friction_scale(node).unwrap_or(1.0);
            }
            scales = (all[0], all[1]);
        }
        FrictionText { contact, name, slip, stiction, kinetic, scales }
    }

    /// Returns a typical size, in the unit in which it is written.
    pub(super) fn friction_scale(&mut self, node: &TomlNode) -> Option<f64> {
        let file = self.written("scales", node)?;
        let value = self.value(&file, Dependence::NOTHING)?;
        self.graph.number(value.node)
    }
}
