use documents::toml::{KeyReader, TomlEntry, TomlNode, list};
use documents::{choice, quoted};

use super::reader::{CONSTANT, MechanismReader};
use crate::kane::graph::Node;
use crate::kane::mechanics::turned;
use crate::kane::mechanism::{Material, Outline};
use crate::kane::text::Dimension;

const MOST_POINTS: usize = 2_000;

const CORNERS: u8 = 24;

const MATERIALS: [(&str, Material); 6] = [
    ("wood", Material::Wood),
    ("felt", Material::Felt),
    ("metal", Material::Metal),
    ("string", Material::String),
    ("ground", Material::Ground),
    ("finger", Material::Finger),
];

/// Transformation of an outline on its frame: scale, rotation and translation.
#[derive(Clone, Copy, Debug)]
struct OutlinePlace {
    scale: Option<Node>,
    turn: Option<Node>,
    origin: [Node; 2],
}

impl MechanismReader {
    pub(super) fn outlines(&mut self, entry: &TomlEntry) {
        let Some(bodies) = entry.node.entries() else {
            for node in list(&mut self.report, "outlines", &entry.node) {
                self.outline(node, None);
            }
            return;
        };
        for body in bodies {
            for node in list(&mut self.report, &body.name, &body.node) {
                self.outline(node, Some(&body.name));
            }
        }
    }

    fn outline(&mut self, node: &TomlNode, body: Option<&str>) {
        let Some(mut keys) = KeyReader::of(&mut self.report, "outlines", node) else { return };
        let frame = self.drawn_frame(&mut keys, body);
        let name = keys.text(&mut self.report, "name").map(|(name, _)| name).or(body);
        let material = self.material(&mut keys);
        let is_closed = keys.is_set(&mut self.report, "closed");
        let place = self.outline_place(&mut keys);
        let is_scaled = place.is_some_and(|it| it.scale.is_some());
        let dimension = if is_scaled { Dimension::NONE } else { Dimension::LENGTH };
        let points = self.outline_points(&mut keys, dimension);
        let modes = self.drawn_modes(&mut keys);
        let shapes = ["points", "rectangle", "disc"].map(|shape| keys.take(shape).is_some());
        if shapes == [false; 3] {
            let help =
                "write points = [[\"0 m\", \"0 m\"], …] or disc = [\"x\", \"y\", \"radius\"]";
            self.report.miss(node.place, "the outline has no points", help);
        }
        keys.finish(&mut self.report);
        let is_closed = is_closed || !shapes[0];
        let (Some(frame), Some(place), Some(points)) = (frame, place, points) else { return };
        let points: Vec<_> = points.into_iter().map(|it| self.placed(place, it)).collect();
        let lines = self.mechanism.instrument.drawing.bodies.iter().flat_map(|body| &body.outlines);
        let drawn: usize = lines.map(|it| it.points.len()).sum();
        if drawn + points.len() > MOST_POINTS {
            let help = format!("there are {MOST_POINTS} at most");
            self.report.say(node.place, "too many points are drawn", help);
            return;
        }
        let body = self.drawn_body(frame.clone(), Some(name.unwrap_or(&frame.name)));
        if let Some(body) = self.mechanism.instrument.drawing.bodies.get_mut(body) {
            body.outlines.push(Outline { material, is_closed, points, modes });
        }
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

    fn outline_place(&mut self, keys: &mut KeyReader<'_>) -> Option<OutlinePlace> {
        let origin = match keys.take("origin") {
            Some(_) => self.drawn_place(keys, "origin"),
            None => Some([self.graph.constant(0.0); 2]),
        };
        let [scale, turn] =
            [("scale", Dimension::LENGTH), ("turn", Dimension::NONE)].map(|(name, dimension)| {
                match self.field(keys, name) {
                    Some(file) => self.node(name, &file, CONSTANT, dimension).map(Some),
                    None => keys.take(name).is_none().then_some(None),
                }
            });
        Some(OutlinePlace { scale: scale?, turn: turn?, origin: origin? })
    }

    /// Returns a point over the parameters (m).
    pub(super) fn drawn_place(
        &mut self,
        keys: &mut KeyReader<'_>,
        name: &'static str,
    ) -> Option<[Node; 2]> {
        let Some(entry) = keys.take(name) else {
            let message = format!("the place has no {}", quoted(name));
            self.report.miss(keys.place, message, format!("write {name} = [\"0 m\", \"0 m\"]"));
            return None;
        };
        self.pair(name, &entry.node, Dimension::LENGTH)
    }

    fn pair(&mut self, name: &str, node: &TomlNode, dimension: Dimension) -> Option<[Node; 2]> {
        let pair = <[Node; 2]>::try_from(self.drawn_numbers(name, node, dimension)?).ok();
        if pair.is_none() {
            self.report.say(node.place, "this is no point", "give x and y");
        }
        pair
    }

    /// Returns points as written: lengths, or multiples of a scale.
    fn outline_points(
        &mut self,
        keys: &mut KeyReader<'_>,
        dimension: Dimension,
    ) -> Option<Vec<[Node; 2]>> {
        let points = keys.take("points").and_then(|entry| {
            let items = list(&mut self.report, "points", &entry.node);
            items.iter().map(|item| self.pair("points", item, dimension)).collect()
        });
        let rectangle = keys.take("rectangle").and_then(|it| self.rectangle(it, dimension));
        let disc = keys.take("disc").and_then(|it| self.disc(it, dimension));
        points.or(rectangle).or(disc)
    }

    fn rectangle(&mut self, entry: &TomlEntry, dimension: Dimension) -> Option<Vec<[Node; 2]>> {
        let numbers = self.drawn_numbers("rectangle", &entry.node, dimension)?;
        let [left, bottom, right, top] = numbers.as_slice() else {
            let help = "give left, bottom, right and top";
            self.report.say(entry.place, "the rectangle has not four edges", help);
            return None;
        };
        Some(vec![[*left, *bottom], [*right, *bottom], [*right, *top], [*left, *top]])
    }

    fn disc(&mut self, entry: &TomlEntry, dimension: Dimension) -> Option<Vec<[Node; 2]>> {
        let numbers = self.drawn_numbers("disc", &entry.node, dimension)?;
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

    fn placed(&mut self, place: OutlinePlace, point: [Node; 2]) -> [Node; 2] {
        let graph = &mut self.graph;
        let [x, y] = place.scale.map_or(point, |it| point.map(|node| graph.multiply(node, it)));
        let [x, y] = place.turn.map_or([x, y], |angle| turned(graph, [x, y], angle));
        [graph.add(place.origin[0], x), graph.add(place.origin[1], y)]
    }
}
