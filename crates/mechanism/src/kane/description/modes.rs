use documents::toml::{KeyReader, SourcePlace, TomlEntry};
use documents::{choice, quoted};

use super::items::FileExpression;
use super::names::SymbolKind;
use super::reader::{CONSTANT, MOTION, MechanismReader, POSE, STATE};
use crate::kane::graph::Node;
use crate::kane::mechanism::Mode;
use crate::kane::text::{Dependence, Dimension, Measured};

impl MechanismReader {
    pub(super) fn modes(&mut self, root: &mut KeyReader<'_>) {
        let entries = root.table(&mut self.report, "modes");
        self.modes = entries.iter().map(|it| (it.name.clone(), it.place)).collect();
        self.mechanism.input.readout = self.readout(root, None);
        self.requirements(root);
        if entries.is_empty() {
            let (constraints, forces, contacts) = self.everything();
            let name = "motion".to_owned();
            self.modes.push((name.clone(), root.place));
            let acting = self.in_mode(&forces);
            self.forces_in_modes.push(acting);
            let mode = Mode { name, constraints, forces, contacts, ..Mode::default() };
            self.mechanism.modes.push(mode);
        }
        for (number, entry) in entries.iter().enumerate() {
            let mode = self.mode(number, entry).unwrap_or_default();
            self.mechanism.modes.push(mode);
        }
    }

    fn everything(&self) -> (Vec<usize>, Vec<usize>, Vec<usize>) {
        let all = |count: usize| (0..count).collect();
        (
            all(self.mechanism.constraints.len()),
            all(self.mechanism.forces.len()),
            all(self.mechanism.contacts.len()),
        )
    }

    fn in_mode(&mut self, forces: &[usize]) -> crate::kane::graph::Substitution {
        let forces = forces.to_vec();
        self.forces_acting(|force| forces.contains(&force))
    }

    fn mode(&mut self, number: usize, entry: &TomlEntry) -> Option<Mode> {
        let (mut constraints, mut forces, mut contacts) = self.everything();
        let keys = KeyReader::new(&mut self.report, entry);
        if let Some(mut keys) = keys {
            keys.text(&mut self.report, "doc");
            if keys.is_set(&mut self.report, "final") {
                self.exits.lasting.push(number);
            }
            if let Some(names) = self.name_list(&mut keys, "constraints") {
                constraints = self.constraint_numbers(&names);
            }
            if let Some(names) = self.name_list(&mut keys, "without") {
                self.leave_out(&names, &mut forces, &mut contacts);
            }
            let acting = self.in_mode(&forces);
            self.forces_in_modes.push(acting);
            let name = entry.name.clone();
            let is_configuration = name.contains(super::configurations::JOINT);
            let mut mode =
                Mode { name, is_configuration, constraints, forces, contacts, ..Mode::default() };
            self.mode_equations(&mut keys, number, &mut mode);
            mode.readout = self.readout(&mut keys, Some(number));
            mode.guards = self.guards(&mut keys, number);
            keys.finish(&mut self.report);
            return Some(mode);
        }
        let acting = self.in_mode(&forces);
        self.forces_in_modes.push(acting);
        None
    }

    fn constraint_numbers(&mut self, names: &[(String, SourcePlace)]) -> Vec<usize> {
        let mut numbers = Vec::new();
        for (name, place) in names {
            if let Some(number) = self.names.constraints.index(name) {
                numbers.push(number);
            } else {
                let help = self.names.constraints.choice(name);
                self.report.say(*place, format!("there is no constraint {}", quoted(name)), help);
            }
        }
        numbers
    }

    fn leave_out(
        &mut self,
        names: &[(String, SourcePlace)],
        forces: &mut Vec<usize>,
        contacts: &mut Vec<usize>,
    ) {
        for (name, place) in names {
            let force = self.mechanism.forces.iter().position(|it| it.name == *name);
            let contact = self.mechanism.contacts.iter().position(|it| it.name == *name);
            if self.names.laws.index(name).is_none() {
                let help = self.names.laws.choice(name);
                let message =
                    format!("there is no spring, felt, force or contact {}", quoted(name));
                self.report.say(*place, message, help);
            }
            forces.retain(|it| Some(*it) != force);
            contacts.retain(|it| Some(*it) != contact);
        }
    }

    fn mode_equations(&mut self, keys: &mut KeyReader<'_>, number: usize, mode: &mut Mode) {
        for entry in keys.table(&mut self.report, "solved") {
            let Some(index) = self.coordinate(entry) else { continue };
            let Some(file) = self.written(&entry.name, &entry.node) else { continue };
            let of = self.names.coordinates.get(index).copied().unwrap_or_default();
            let Some(value) = self.mode_value(&entry.name, &file, POSE, of, number) else {
                continue;
            };
            mode.solved.push((index, value));
        }
        if let Some(names) = self.name_list(keys, "independent") {
            let numbers = names.iter().filter_map(|(name, place)| self.speed(name, *place));
            mode.independent = Some(numbers.collect());
        }
        for entry in keys.table(&mut self.report, "equations") {
            let Some(index) = self.rate_of_speed(entry) else { continue };
            let Some(file) = self.written(&entry.name, &entry.node) else { continue };
            let of = self.names.speeds.get(index).copied().unwrap_or_default();
            let of = of.over(Dimension::TIME);
            let reach = STATE.and(Dependence::FORCES).and(Dependence::REACTIONS);
            let Some(value) = self.mode_value(&entry.name, &file, reach, of, number) else {
                continue;
            };
            mode.equations.push((index, value));
        }
        let mut extra = |name, dimension, reach| {
            let file = self.field(keys, name)?;
            self.mode_value(name, &file, reach, dimension, number)
        };
        mode.energy = extra("energy", Dimension::ENERGY, STATE);
        mode.dissipated = extra("dissipated", Dimension::POWER, STATE.and(Dependence::FORCES));
        if let Some(file) = self.field(keys, "longest_projection") {
            mode.longest_projection = self.value(&file, CONSTANT).map(|it| it.node);
        }
    }

    pub(super) fn coordinate(&mut self, entry: &TomlEntry) -> Option<usize> {
        if let Some((SymbolKind::Coordinate(index), _)) = self.names.symbols.get(&entry.name) {
            return Some(*index);
        }
        let known = self.mechanism.coordinates.iter().map(|it| it.name.as_str());
        let help = choice(&entry.name, known);
        let message = format!("there is no coordinate {}", quoted(&entry.name));
        self.report.say(entry.place, message, help);
        None
    }

    pub(super) fn speed(&mut self, name: &str, place: SourcePlace) -> Option<usize> {
        let found = self.mechanism.speeds.iter().position(|it| it.name == name);
        if found.is_none() {
            let help = choice(name, self.mechanism.speeds.iter().map(|it| it.name.as_str()));
            self.report.say(place, format!("there is no speed {}", quoted(name)), help);
        }
        found
    }

    /// Returns the number of the speed with the rate `u'` or `theta''`.
    fn rate_of_speed(&mut self, entry: &TomlEntry) -> Option<usize> {
        if let Some(name) = entry.name.strip_suffix('\'') {
            return self.speed(name, entry.place);
        }
        let message = format!("{} is not the rate of a speed", quoted(&entry.name));
        let help = "write a prime behind a speed, as \"u'\" or \"theta''\"";
        self.report.say(entry.place, message, help);
        None
    }

    fn readout(&mut self, keys: &mut KeyReader<'_>, mode: Option<usize>) -> Option<Node> {
        let file = self.field(keys, "readout")?;
        let dimension = Dimension::ENERGY.over(self.names.input);
        if let Some(mode) = mode {
            return self.mode_value("readout", &file, MOTION, dimension, mode);
        }
        let node = self.node("readout", &file, MOTION, dimension)?;
        let mut all = self.forces_acting(|_| true);
        Some(all.of(&mut self.graph, node))
    }

    /// Returns the node of `file` in a mode, in which inactive forces are 0.
    pub(super) fn mode_value(
        &mut self,
        name: &str,
        file: &FileExpression,
        allowed: Dependence,
        dimension: Dimension,
        mode: usize,
    ) -> Option<Node> {
        let value = self.value(file, allowed)?;
        self.fits(name, file, value, dimension).then_some(())?;
        Some(self.acting(file, value, mode).node)
    }

    pub(super) fn acting(
        &mut self,
        file: &FileExpression,
        value: Measured,
        mode: usize,
    ) -> Measured {
        let mut value = value;
        if value.reach.meets(Dependence::FORCES)
            && let Some(forces) = self.forces_in_modes.get_mut(mode)
        {
            value.node = forces.of(&mut self.graph, value.node);
            self.weigh(file.place);
        }
        self.watch(file, value, Some(mode));
        value
    }

    pub(super) fn mode_number(&mut self, name: &str, place: SourcePlace) -> Option<usize> {
        let found = self.modes.iter().position(|(known, _)| known == name);
        if found.is_none() {
            let help = choice(name, self.modes.iter().map(|(known, _)| known));
            self.report.say(place, format!("there is no mode {}", quoted(name)), help);
        }
        found
    }
}
