use documents::quoted;
use documents::toml::{KeyReader, SourcePlace, TomlEntry};

use super::declare::{AT, ORIGIN};
use super::items::{ItemKind, LinkKind};
use super::reader::MechanismReader;
use crate::kane::mechanism::ConstraintKind;

impl MechanismReader {
    pub(super) fn declare_frames(&mut self, root: &mut KeyReader<'_>) {
        let ground = super::world_frame::WorldFrame::ground(&mut self.graph);
        if let Ok(index) = self.names.frames.declare("ground", SourcePlace::default()) {
            self.names.frames.set(index, ground);
        }
        self.mechanism.frames.push(super::geometry::ground());
        for entry in root.table(&mut self.report, "frames") {
            let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { continue };
            let parent = self.link(&mut keys, LinkKind::Frame, "in");
            let origin = self.triple(&mut keys, "origin");
            let turn = self.field(&mut keys, "turn");
            let axis = self.axis(&mut keys);
            keys.finish(&mut self.report);
            let Some(index) = self.declared_frame(entry) else { continue };
            self.mechanism.frames.push(crate::kane::mechanism::ReferenceFrame {
                name: entry.name.clone(),
                ..super::geometry::ground()
            });
            let [x, y, z] = origin;
            let fields = [(ORIGIN[0], x), (ORIGIN[1], y), (ORIGIN[2], z), ("turn", turn)];
            self.item(ItemKind::Frame(index, axis), entry, fields, parent.into_iter().collect());
        }
    }

    pub(super) fn declared_frame(&mut self, entry: &TomlEntry) -> Option<usize> {
        match self.names.frames.declare(&entry.name, entry.place) {
            Ok(index) => Some(index),
            Err(first) => {
                self.twice(entry, first);
                None
            }
        }
    }

    pub(super) fn axis(&mut self, keys: &mut KeyReader<'_>) -> usize {
        let Some((axis, place)) = keys.text(&mut self.report, "axis") else { return 2 };
        ["x", "y", "z"].iter().position(|known| *known == axis).unwrap_or_else(|| {
            let message = format!("there is no axis {}", quoted(axis));
            self.report.say(place, message, "use x, y or z; without it z");
            2
        })
    }

    pub(super) fn declare_points(&mut self, root: &mut KeyReader<'_>) {
        for entry in root.table(&mut self.report, "points") {
            if !self.is_name(entry) {
                continue;
            }
            let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { continue };
            let frame = self.link(&mut keys, LinkKind::Frame, "in");
            let [x, y, z] = self.triple(&mut keys, "at");
            keys.finish(&mut self.report);
            let fields = [(AT[0], x), (AT[1], y), (AT[2], z)];
            match self.names.points.declare(&entry.name, entry.place) {
                Ok(index) => {
                    self.point_places.push(None);
                    self.item(ItemKind::Point(index), entry, fields, frame.into_iter().collect());
                }
                Err(first) => self.twice(entry, first),
            }
        }
    }

    pub(super) fn declare_constraints(&mut self, root: &mut KeyReader<'_>) {
        for entry in root.table(&mut self.report, "constraints") {
            let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { continue };
            let zero = self.field(&mut keys, "zero");
            if keys.take("zero").is_none() {
                let message =
                    format!("the constraint {} does not say what is zero", quoted(&entry.name));
                self.report.miss(entry.place, message, "write zero = \"x(P) - x(Q)\"");
            }
            let kind = self.constraint_kind(&mut keys);
            keys.finish(&mut self.report);
            match self.names.constraints.declare(&entry.name, entry.place) {
                Ok(index) => {
                    let zero = [("zero", zero)];
                    self.item(ItemKind::Constraint(index, kind), entry, zero, Vec::new());
                }
                Err(first) => self.twice(entry, first),
            }
        }
    }

    pub(super) fn constraint_kind(&mut self, keys: &mut KeyReader<'_>) -> ConstraintKind {
        match keys.text(&mut self.report, "kind") {
            None | Some(("holonomic", _)) => ConstraintKind::Holonomic,
            Some(("nonholonomic", _)) => ConstraintKind::Nonholonomic,
            Some((other, place)) => {
                let help = documents::choice(other, ["holonomic", "nonholonomic"]);
                let message = format!("there is no kind {}", quoted(other));
                self.report.say(place, message, help);
                ConstraintKind::Holonomic
            }
        }
    }
}
