//! Numeric checks without a derivation: values over the keys, and the initial pose.

use documents::toml::SourcePlace;

use std::collections::BTreeSet;

use documents::quoted;

use super::names::number;
use super::plausible::PresetPose;
use super::reader::{MechanismReader, STATE};
use crate::kane::graph::{Node, Place};
use crate::kane::tape::{Argument, ArgumentLayout, Tape, TapeArguments};
use crate::kane::text::Dependence;

const KEYS: u8 = 88;

impl MechanismReader {
    pub(super) fn check(&mut self) {
        let is_whole = self.names.vague.is_empty()
            && self.mechanism.instrument.presets.len() == self.places.presets.len()
            && self.parameters.iter().all(|it| it.value.is_some());
        if is_whole {
            for preset in 0..self.mechanism.instrument.presets.len() {
                self.check_preset(preset);
            }
        }
        if self.report.is_empty() {
            let mut said = BTreeSet::new();
            for preset in 0..self.mechanism.instrument.presets.len() {
                self.check_pose(preset, &mut said);
            }
        }
        self.check_modes();
    }

    pub(super) fn tape(&self, nodes: &[Node]) -> Option<Tape> {
        let mut layout = ArgumentLayout::default();
        layout.place(Place::Key, Argument::Extra(0));
        let coordinates = self.mechanism.coordinates.len();
        for index in 0..self.mechanism.parameters.len() {
            layout.place(Place::Parameter(number(index)), Argument::Constant(number(index)));
        }
        for index in 0..coordinates {
            layout.place(Place::Coordinate(number(index)), Argument::State(number(index)));
        }
        for index in 0..self.mechanism.speeds.len() {
            let at = Argument::State(number(coordinates + index));
            layout.place(Place::Speed(number(index)), at);
        }
        for order in 0..4 {
            layout.place(Place::Input(order), Argument::Input(order));
        }
        Tape::lower(&self.graph, &layout, nodes).ok()
    }

    pub(super) fn preset_name(&self, preset: usize) -> String {
        quoted(self.mechanism.instrument.presets.get(preset).map_or("", |it| &it.name))
    }

    fn check_preset(&mut self, preset: usize) {
        let Some(values) =
            self.mechanism.instrument.presets.get(preset).map(|it| it.values.clone())
        else {
            return;
        };
        let margins: Vec<_> =
            self.mechanism.instrument.requirements.iter().map(|it| it.margin).collect();
        let (Some(tape), Some(requirements)) = (self.tape(&values), self.tape(&margins)) else {
            return;
        };
        let is_graded =
            values.iter().any(|it| self.graph.depends(*it, |place| place == Place::Key));
        let mut said = vec![false; values.len() + margins.len()];
        for key in 0..if is_graded { KEYS } else { 1 } {
            let extra = [f64::from(key)];
            let constants =
                tape.evaluate(&TapeArguments { extra: &extra, ..TapeArguments::default() });
            let margins = requirements
                .evaluate(&TapeArguments { constants: &constants, ..TapeArguments::default() });
            let wrong = |it: &usize| self.is_out_of_range(*it, constants[*it]);
            let mut wrong: Vec<_> = (0..constants.len()).filter(wrong).collect();
            wrong.retain(|index| mark(&mut said, *index));
            for index in wrong {
                self.say_range((preset, index), constants[index], key);
            }
            self.check_limits(preset, &constants, key);
            // NaN does not meet a requirement.
            let unmet = |it: &usize| margins[*it].is_nan() || margins[*it] <= 0.0;
            let mut unmet: Vec<_> = (0..margins.len()).filter(unmet).collect();
            unmet.retain(|index| mark(&mut said, constants.len() + index));
            for index in unmet {
                self.say_requirement(preset, index, key);
            }
        }
    }

    fn is_out_of_range(&self, index: usize, value: f64) -> bool {
        let range = self.mechanism.parameters.get(index).map(|it| it.range);
        let is_inside = range.is_some_and(|(low, high)| low <= value && value <= high);
        !(value.is_finite() && is_inside)
    }

    fn say_range(&mut self, (preset, index): (usize, usize), value: f64, key: u8) {
        let Some(parameter) = self.mechanism.parameters.get(index) else { return };
        let (low, high) = parameter.range;
        let unit = if parameter.unit == "1" { "" } else { &parameter.unit };
        let message = format!(
            "{} is {value} {unit} in preset {} on key {key}, out of range",
            quoted(&parameter.name),
            self.preset_name(preset)
        );
        let help = format!("keep it within {low} to {high} {unit}");
        let places = self.places.presets.get(preset);
        let place = places.and_then(|it| it.get(index)).copied().unwrap_or_default();
        self.report.say(place, message.replace("  ", " "), help.trim_end());
    }

    fn say_requirement(&mut self, preset: usize, index: usize, key: u8) {
        let Some(requirement) = self.mechanism.instrument.requirements.get(index) else { return };
        let message = format!(
            "{} does not hold in preset {} on key {key}",
            quoted(&requirement.text),
            self.preset_name(preset)
        );
        let place = self.places.requirements.get(index).copied().unwrap_or_default();
        self.report.say(place, message, "change the preset, or what is required");
    }

    /// Checks values at the rest pose, with a preset's values for the lowest key.
    fn check_pose(&mut self, preset: usize, said: &mut BTreeSet<SourcePlace>) {
        let Some(values) =
            self.mechanism.instrument.presets.get(preset).map(|it| it.values.clone())
        else {
            return;
        };
        let Some(tape) = self.tape(&values) else { return };
        let constants = tape.evaluate(&TapeArguments { extra: &[0.0], ..TapeArguments::default() });
        let mode = self.rest_mode_of(&constants);
        let state = self.rest_state(preset, &constants, mode);
        if self.report.is_empty() {
            let (constants, state) = (&constants, &state);
            self.check_start(PresetPose { preset, constants, state, mode });
        }
        for (node, place, text) in self.at_rest(mode) {
            let Some(tape) = self.tape(&[node]) else { continue };
            let arguments =
                TapeArguments { constants: &constants, state: &state, ..TapeArguments::default() };
            let value = tape.evaluate(&arguments).first().copied().unwrap_or(0.0);
            if !value.is_finite() && said.insert(place) {
                self.say_pose((preset, &text), value, place);
            }
        }
    }

    fn say_pose(&mut self, (preset, text): (usize, &str), value: f64, place: SourcePlace) {
        let what = if value.is_nan() { "not a number" } else { "infinite" };
        let (text, preset) = (quoted(text), self.preset_name(preset));
        let message = format!("{text} is {what} at the initial pose of preset {preset}");
        let help = "look for a division by zero, or correct the pose in [rest]";
        self.report.say(place, message, help);
    }

    fn rest_mode_of(&self, constants: &[f64]) -> usize {
        let rest = &self.mechanism.rest;
        let holds = |when: Node| {
            let arguments = TapeArguments { constants, ..TapeArguments::default() };
            let margin = self.tape(&[when]).map(|it| it.evaluate(&arguments));
            margin.and_then(|it| it.first().copied()).is_some_and(|it| it > 0.0)
        };
        let other = rest.instead.iter().find(|(when, _)| holds(*when));
        other.map_or(rest.mode, |(_, mode)| *mode)
    }

    /// Returns the coordinates at rest, then the speeds: those of a stated start, else 0.
    fn rest_state(&mut self, preset: usize, constants: &[f64], mode: usize) -> Vec<f64> {
        let count = self.mechanism.coordinates.len();
        let mut state = vec![0.0; count + self.mechanism.speeds.len()];
        let given = self.mechanism.rest.coordinates.clone();
        let solved = self.mechanism.modes.get(mode).map(|it| it.solved.clone()).unwrap_or_default();
        let open = |index: &usize| given.get(*index).is_none_or(Option::is_none);
        let first = given.iter().enumerate().filter_map(|(index, it)| Some((index, (*it)?)));
        let then = solved.into_iter().filter(|(index, _)| open(index));
        let speeds = self.mechanism.rest.speeds.iter().enumerate();
        let speeds = speeds.filter_map(|(index, it)| Some((count + index, (*it)?)));
        for (index, node) in first.chain(then).chain(speeds).collect::<Vec<_>>() {
            let arguments = TapeArguments { constants, state: &state, ..TapeArguments::default() };
            let value = self.tape(&[node]).map(|it| it.evaluate(&arguments));
            let value = value.and_then(|it| it.first().copied()).unwrap_or(0.0);
            self.check_rest_value(preset, index, value);
            if let Some(slot) = state.get_mut(index) {
                *slot = value;
            }
        }
        state
    }

    fn check_rest_value(&mut self, preset: usize, index: usize, value: f64) {
        let Some(coordinate) = self.mechanism.coordinates.get(index) else { return };
        let (low, high) = coordinate.range;
        if low <= value && value <= high {
            return;
        }
        let message = format!(
            "{} is {value} {} at the initial pose of preset {}, out of its range of motion",
            quoted(&coordinate.name),
            coordinate.unit,
            self.preset_name(preset)
        );
        let help = format!("keep it within {low} to {high}, or widen the range");
        let place =
            self.places.rest_coordinates.get(index).copied().flatten().unwrap_or(self.places.rest);
        self.report.say(place, message, help);
    }

    /// Returns a mode's own expressions, those of all modes, and the forces that act in it.
    fn at_rest(&self, mode: usize) -> Vec<(Node, SourcePlace, String)> {
        let counts = |reach: Dependence, of: Option<usize>| {
            STATE.and(Dependence::FORCES).covers(reach) && of.is_none_or(|of| of == mode)
        };
        let watched = self.watched.iter().filter(|it| counts(it.reach, it.mode));
        let mut all: Vec<_> = watched.map(|it| (it.node, it.place, it.text.clone())).collect();
        let acting = self.mechanism.modes.get(mode).map_or(&[][..], |it| &it.forces);
        for force in acting.iter().filter_map(|it| self.mechanism.forces.get(*it)) {
            let place = self.names.laws.names.get(&force.name).map(|(_, place)| *place);
            for node in [force.tension, force.energy] {
                all.push((node, place.unwrap_or_default(), force.name.clone()));
            }
        }
        all
    }
}

fn mark(said: &mut [bool], index: usize) -> bool {
    said.get_mut(index).is_some_and(|slot| !std::mem::replace(slot, true))
}
