//! `[rest]`: the rest pose, and the damper that the key lifts.

use documents::quoted;
use documents::toml::{KeyReader, TomlEntry, TomlNode};

use super::reader::{CONSTANT, MechanismReader};
use crate::kane::mechanism::{Rest, StringDamper, Target};
use crate::kane::text::{Dependence, Dimension, Form};

impl MechanismReader {
    pub(super) fn rest(&mut self, root: &mut KeyReader<'_>) {
        let mut rest =
            Rest { coordinates: vec![None; self.names.coordinates.len()], ..Rest::default() };
        rest.speeds = vec![None; self.names.speeds.len()];
        let entry = root.take("rest");
        self.places.rest_coordinates = vec![None; self.names.coordinates.len()];
        self.places.rest = entry.map_or(root.place, |it| it.place);
        if let Some(entry) = entry
            && let Some(mut keys) = KeyReader::new(&mut self.report, entry)
        {
            self.rest_mode(&mut keys, &mut rest);
            rest.is_start = keys.is_set(&mut self.report, "start");
            rest.place = self.report.file_position(entry.place);
            let others: Vec<_> = keys.others().collect();
            for entry in others {
                self.rest_entry(entry, &mut rest);
            }
        }
        self.mechanism.rest = rest;
    }

    fn rest_mode(&mut self, keys: &mut KeyReader<'_>, rest: &mut Rest) {
        let Some(entry) = keys.take("mode") else { return };
        if let Some(name) = entry.node.text() {
            rest.mode = self.mode_number(name, entry.node.place).unwrap_or(0);
            return;
        }
        let mut is_decided = false;
        for node in keys.list(&mut self.report, "mode") {
            let Some((mode, when)) = self.rest_way(node) else { continue };
            if let Some(when) = when {
                rest.instead.push((when, mode));
            } else {
                rest.mode = mode;
                is_decided = true;
            }
        }
        if !is_decided {
            let help = "end the list with { mode = \"…\" }, without a condition";
            self.report.miss(entry.place, "the mode at rest is not decided in every case", help);
        }
    }

    fn rest_way(&mut self, node: &TomlNode) -> Option<(usize, Option<crate::kane::graph::Node>)> {
        let mut keys = KeyReader::of(&mut self.report, "mode", node)?;
        let when = keys.take("when");
        let file = when.and_then(|it| self.written_as("when", &it.node, Form::Condition));
        let named = keys.text(&mut self.report, "mode");
        keys.finish(&mut self.report);
        let when = match file {
            Some(file) => Some(self.value(&file, CONSTANT)?.node),
            None => None,
        };
        let (name, place) = named?;
        Some((self.mode_number(name, place)?, when))
    }

    fn rest_entry(&mut self, entry: &TomlEntry, rest: &mut Rest) {
        let Some((target, dimension)) = self.target(entry, &["mode", "start"]) else { return };
        if matches!(target, Target::Speed(_)) && !rest.is_start {
            let message = format!("{} is a speed, and what rests has none", quoted(&entry.name));
            self.report.say(entry.place, message, "write start = true if it starts so");
            return;
        }
        let Some(file) = self.written(&entry.name, &entry.node) else { return };
        let reach = CONSTANT.and(Dependence::INPUT);
        let value = self.node(&entry.name, &file, reach, dimension);
        let (slot, place) = match target {
            Target::Coordinate(index) => {
                (rest.coordinates.get_mut(index), self.places.rest_coordinates.get_mut(index))
            }
            Target::Speed(index) => (rest.speeds.get_mut(index), None),
        };
        if let Some(slot) = slot {
            *slot = value;
        }
        if let Some(slot) = place {
            *slot = Some(entry.place);
        }
    }

    pub(super) fn damper(&mut self, root: &mut KeyReader<'_>) {
        let Some(entry) = root.take("damper") else { return };
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        let mut number = |name: &'static str, dimension| {
            let found = keys.take(name);
            if found.is_none() {
                let message = format!("the damper has no {}", quoted(name));
                self.report.miss(entry.place, message, format!("write {name} = \"…\""));
            }
            self.constant(name, &found?.node, dimension)
        };
        let lift = number("lift", Dimension::LENGTH);
        let fall = number("fall", Dimension::LENGTH);
        let softest_tone = number("softest_tone", Dimension::SPEED);
        keys.finish(&mut self.report);
        let (Some(lift), Some(fall), Some(softest_tone)) = (lift, fall, softest_tone) else {
            return;
        };
        if lift <= fall {
            let help = "lift above fall, so that a key held there does not chatter";
            self.report.say(entry.place, "the damper is lifted no higher than it falls", help);
        }
        self.mechanism.instrument.sound = Some(StringDamper { lift, fall, softest_tone });
    }
}
