//! Side view of a mechanism: outlines on frames, and springs.

use documents::quoted;
use documents::toml::{KeyReader, SourcePlace, TomlEntry, TomlKind, TomlNode, list, text};

use super::reader::{CONSTANT, MechanismReader};
use crate::kane::graph::Node;
use crate::kane::mechanism::{DrawnBody, DrawnFrame, DrawnSpring};
use crate::kane::text::Dimension;

impl MechanismReader {
    pub(super) fn drawing(&mut self, root: &mut KeyReader<'_>) {
        let Some(entry) = root.take("drawing") else { return };
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        if let Some(entry) = keys.take("view") {
            self.mechanism.instrument.drawing.view = self.view(entry);
        }
        for entry in keys.table(&mut self.report, "frames") {
            self.frame_by_mode(entry);
        }
        if let Some(outlines) = keys.take("outlines") {
            self.outlines(outlines);
        }
        for node in keys.list(&mut self.report, "springs") {
            self.drawn_spring(node);
        }
        keys.finish(&mut self.report);
    }

    fn view(&mut self, entry: &TomlEntry) -> Option<[Node; 4]> {
        let lengths = self.drawn_numbers("view", &entry.node, Dimension::LENGTH)?;
        let four = <[Node; 4]>::try_from(lengths).ok();
        if four.is_none() {
            let help = "give left, bottom, right and top";
            self.report.say(entry.place, "the view has not four edges", help);
        }
        four
    }

    pub(super) fn drawn_numbers(
        &mut self,
        name: &str,
        node: &TomlNode,
        dimension: Dimension,
    ) -> Option<Vec<Node>> {
        let mut all = Vec::new();
        for item in list(&mut self.report, name, node) {
            let file = self.written(name, item)?;
            all.push(self.node(name, &file, CONSTANT, dimension)?);
        }
        Some(all)
    }

    fn frame_by_mode(&mut self, entry: &TomlEntry) {
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        let usual = keys.text(&mut self.report, "frame").map_or(Some(0), |it| self.frame(it));
        let mut others = Vec::new();
        for entry in keys.table(&mut self.report, "in") {
            let mode = self.mode_number(&entry.name, entry.place);
            let frame = text(&mut self.report, &entry.name, &entry.node);
            others.push(mode.zip(frame.and_then(|it| self.frame(it))));
        }
        keys.finish(&mut self.report);
        let others: Option<Vec<_>> = others.into_iter().collect();
        let (Some(usual), Some(others)) = (usual, others) else { return };
        let is_known = self.names.frames.index(&entry.name).is_some();
        if is_known || self.drawn_frames.iter().any(|it| it.name == entry.name) {
            let message = format!("{} is a frame already", quoted(&entry.name));
            self.report.say(entry.place, message, "give one of the two another name");
            return;
        }
        let other = |mode| others.iter().find(|(at, _)| *at == mode).map(|(_, frame)| *frame);
        let frames = (0..self.modes.len()).map(|mode| other(mode).unwrap_or(usual)).collect();
        self.drawn_frames.push(DrawnFrame { name: entry.name.clone(), frames });
    }

    fn frame(&mut self, (name, place): (&str, SourcePlace)) -> Option<usize> {
        let found = self.names.frames.index(name);
        if found.is_none() {
            let help = self.names.frames.choice(name);
            self.report.say(place, format!("there is no frame {}", quoted(name)), help);
        }
        found
    }

    /// Returns the frame that `keys` name; otherwise that with the name of `body`, or the ground.
    pub(super) fn drawn_frame(
        &mut self,
        keys: &mut KeyReader<'_>,
        body: Option<&str>,
    ) -> Option<DrawnFrame> {
        let has = |name: &&str| {
            self.names.frames.index(name).is_some()
                || self.drawn_frames.iter().any(|it| it.name == *name)
        };
        let usual = body.filter(has).unwrap_or("ground");
        let named = keys.text(&mut self.report, "frame").unwrap_or((usual, keys.place));
        if let Some(known) = self.drawn_frames.iter().find(|it| it.name == named.0) {
            return Some(known.clone());
        }
        let frame = self.frame(named)?;
        let frames = vec![frame; self.modes.len()];
        Some(DrawnFrame { name: named.0.to_owned(), frames })
    }

    /// Returns the number of the body called `name` on a frame; of any body without a name.
    pub(super) fn drawn_body(&mut self, frame: DrawnFrame, name: Option<&str>) -> usize {
        let drawing = &mut self.mechanism.instrument.drawing;
        let named = name.unwrap_or(&frame.name).to_owned();
        let is_still = frame.frames.iter().all(|it| *it == 0);
        let known = drawing.frames.iter().position(|it| it.frames == frame.frames);
        let number = (!is_still).then(|| {
            known.unwrap_or_else(|| {
                drawing.frames.push(frame);
                drawing.frames.len() - 1
            })
        });
        let is_one = |it: &DrawnBody| it.frame == number && (name.is_none() || it.name == named);
        drawing.bodies.iter().position(is_one).unwrap_or_else(|| {
            drawing.bodies.push(DrawnBody { name: named, frame: number, outlines: Vec::new() });
            drawing.bodies.len() - 1
        })
    }

    pub(super) fn drawn_modes(&mut self, keys: &mut KeyReader<'_>) -> Vec<usize> {
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
            self.mechanism.instrument.drawing.springs.push(DrawnSpring { name, from, to, modes });
        }
    }

    fn drawn_end(
        &mut self,
        keys: &mut KeyReader<'_>,
        end: &'static str,
    ) -> Option<(usize, [Node; 2])> {
        let Some(entry) = keys.take(end) else {
            let message = format!("the spring has no {}", quoted(end));
            self.report.miss(keys.place, message, format!("write {end} = \"P\", a point"));
            return None;
        };
        if matches!(entry.node.kind, TomlKind::Table(_)) {
            return self.end_on_frame(entry);
        }
        let (name, place) = keys.text(&mut self.report, end)?;
        let Some(index) = self.names.points.index(name) else {
            let help = self.names.points.choice(name);
            self.report.say(place, format!("there is no point {}", quoted(name)), help);
            return None;
        };
        let (frame, [x, y, _]) = (*self.point_places.get(index)?)?;
        let name = self.mechanism.frames.get(frame).map(|it| it.name.clone()).unwrap_or_default();
        let frame = DrawnFrame { name, frames: vec![frame; self.modes.len()] };
        Some((self.drawn_body(frame, None), [x, y]))
    }

    fn end_on_frame(&mut self, entry: &TomlEntry) -> Option<(usize, [Node; 2])> {
        let mut keys = KeyReader::new(&mut self.report, entry)?;
        let frame = self.drawn_frame(&mut keys, None);
        let at = self.drawn_place(&mut keys, "at");
        keys.finish(&mut self.report);
        Some((self.drawn_body(frame?, None), at?))
    }
}
