//! How a mechanism looks from the side.

use diagnostics::{choice, quoted};

use super::key_reader::{KeyReader, list};
use super::reader::{CONSTANT, MechanismReader};
use super::toml_tree::{TomlEntry, TomlNode};
use crate::graph::Node;
use crate::mechanism::{DrawnSpring, Material, Outline};
use crate::text::Dimension;

/// Most points of all outlines.
const MOST_POINTS: usize = 2_000;

/// Corners of a disc.
const CORNERS: u8 = 24;

const MATERIALS: [(&str, Material); 6] = [
    ("wood", Material::Wood),
    ("felt", Material::Felt),
    ("metal", Material::Metal),
    ("string", Material::String),
    ("ground", Material::Ground),
    ("finger", Material::Finger),
];

impl MechanismReader {
    pub(super) fn drawing(&mut self, root: &mut KeyReader<'_>) {
        let Some(entry) = root.take("drawing") else { return };
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        if let Some(entry) = keys.take("view") {
            self.mechanism.drawing.view = self.view(entry);
        }
        for node in keys.list(&mut self.report, "outlines") {
            self.outline(node);
        }
        for node in keys.list(&mut self.report, "springs") {
            self.drawn_spring(node);
        }
        keys.finish(&mut self.report);
    }

    fn view(&mut self, entry: &TomlEntry) -> Option<[Node; 4]> {
        let lengths = self.drawn_lengths("view", &entry.node)?;
        let four = <[Node; 4]>::try_from(lengths).ok();
        if four.is_none() {
            let help = "give left, bottom, right and top";
            self.report.say(entry.place, "the view has not four edges", help);
        }
        four
    }

    fn drawn_lengths(&mut self, name: &str, node: &TomlNode) -> Option<Vec<Node>> {
        let mut all = Vec::new();
        for item in list(&mut self.report, name, node) {
            let file = self.written(name, item)?;
            all.push(self.node(name, &file, CONSTANT, Dimension::LENGTH)?);
        }
        Some(all)
    }

    fn outline(&mut self, node: &TomlNode) {
        let Some(mut keys) = KeyReader::of(&mut self.report, "outlines", node) else { return };
        let frame = keys.text(&mut self.report, "frame").map_or(Some(0), |(name, place)| {
            let found = self.names.frames.index(name);
            if found.is_none() {
                let help = self.names.frames.choice(name);
                self.report.say(place, format!("there is no frame {}", quoted(name)), help);
            }
            found
        });
        let name = keys.text(&mut self.report, "name").map(|(name, _)| name.to_owned());
        let material = self.material(&mut keys);
        let is_closed = keys.is_set(&mut self.report, "closed");
        let points = keys.take("points").and_then(|it| self.outline_points(it));
        let disc = keys.take("disc").and_then(|it| self.disc(it));
        let modes = self.drawn_modes(&mut keys);
        let is_empty = keys.take("points").is_none() && keys.take("disc").is_none();
        if is_empty {
            let help =
                "write points = [[\"0 m\", \"0 m\"], …] or disc = [\"x\", \"y\", \"radius\"]";
            self.report.miss(node.place, "the outline has no points", help);
        }
        keys.finish(&mut self.report);
        let is_closed = is_closed || disc.is_some();
        let (Some(frame), Some(points)) = (frame, points.or(disc)) else { return };
        let drawn: usize = self.mechanism.drawing.outlines.iter().map(|it| it.points.len()).sum();
        if drawn + points.len() > MOST_POINTS {
            let help = format!("there are {MOST_POINTS} at most");
            self.report.say(node.place, "too many points are drawn", help);
            return;
        }
        let named = self.mechanism.frames.get(frame).map(|it| it.name.clone());
        let name = name.or(named).unwrap_or_default();
        let outline = Outline { name, frame, material, is_closed, points, modes };
        self.mechanism.drawing.outlines.push(outline);
    }

    fn material(&mut self, keys: &mut KeyReader<'_>) -> Material {
        let Some((name, place)) = keys.text(&mut self.report, "material") else {
            return Material::Wood;
        };
        let found = MATERIALS.iter().find(|(known, _)| *known == name);
        found.map_or_else(
            || {
                let help = choice(name, MATERIALS.iter().map(|(known, _)| *known));
                self.report.say(place, format!("there is no material {}", quoted(name)), help);
                Material::Wood
            },
            |(_, material)| *material,
        )
    }

    fn outline_points(&mut self, entry: &TomlEntry) -> Option<Vec<[Node; 2]>> {
        let mut points = Vec::new();
        for item in list(&mut self.report, "points", &entry.node) {
            let pair = self.drawn_lengths("points", item)?;
            let Ok(pair) = <[Node; 2]>::try_from(pair) else {
                self.report.say(item.place, "this is no point", "give x and y");
                return None;
            };
            points.push(pair);
        }
        Some(points)
    }

    /// A polygon that looks round.
    fn disc(&mut self, entry: &TomlEntry) -> Option<Vec<[Node; 2]>> {
        let numbers = self.drawn_lengths("disc", &entry.node)?;
        let [x, y, radius] = numbers.as_slice() else {
            self.report.say(entry.place, "the disc has not three numbers", "give x, y and radius");
            return None;
        };
        let corners = (0..CORNERS).map(|corner| {
            let angle = std::f64::consts::TAU * f64::from(corner) / f64::from(CORNERS);
            let (sine, cosine) = angle.sin_cos();
            let graph = &mut self.graph;
            [graph.sum(&[(*x, 1.0), (*radius, cosine)]), graph.sum(&[(*y, 1.0), (*radius, sine)])]
        });
        Some(corners.collect())
    }

    fn drawn_modes(&mut self, keys: &mut KeyReader<'_>) -> Vec<usize> {
        let names = self.name_list(keys, "modes").unwrap_or_default();
        names.iter().filter_map(|(name, place)| self.mode_number(name, *place)).collect()
    }

    fn drawn_spring(&mut self, node: &TomlNode) {
        let Some(mut keys) = KeyReader::of(&mut self.report, "springs", node) else { return };
        let name =
            keys.text(&mut self.report, "name").map_or("spring", |(name, _)| name).to_owned();
        let [from, to] = ["from", "to"].map(|end| self.drawn_end(&mut keys, end));
        let modes = self.drawn_modes(&mut keys);
        keys.finish(&mut self.report);
        if let (Some(from), Some(to)) = (from, to) {
            self.mechanism.drawing.springs.push(DrawnSpring { name, from, to, modes });
        }
    }

    fn drawn_end(
        &mut self,
        keys: &mut KeyReader<'_>,
        end: &'static str,
    ) -> Option<(usize, [Node; 2])> {
        let Some((name, place)) = keys.text(&mut self.report, end) else {
            let message = format!("the spring has no {}", quoted(end));
            self.report.miss(keys.place, message, format!("write {end} = \"P\", a point"));
            return None;
        };
        let Some(index) = self.names.points.index(name) else {
            let help = self.names.points.choice(name);
            self.report.say(place, format!("there is no point {}", quoted(name)), help);
            return None;
        };
        let (frame, [x, y, _]) = (*self.point_places.get(index)?)?;
        Some((frame, [x, y]))
    }
}
