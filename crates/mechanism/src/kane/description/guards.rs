//! Guards of modes with their targets and reset maps.
#![expect(
    clippy::wildcard_enum_match_arm,
    reason = "TOML has many kinds of values, and each place takes few of them"
)]

use documents::toml::{KeyReader, SourcePlace, TomlEntry, TomlKind, TomlNode, text};
use documents::{choice, quoted};

use super::items::FileExpression;
use super::linear::is_linear_in_speeds;
use super::names::SymbolKind;
use super::reader::{CONSTANT, MOTION, MechanismReader, STATE};
use crate::kane::assemble::stays_at_zero;
use crate::kane::mechanism::{Fires, Guard, GuardBranch, Impact, Target};
use crate::kane::text::{Dependence, Dimension, Form, Measured};

const MOST_GUARDS: usize = 32;

#[derive(Clone, Debug, Default)]
struct GuardChanges {
    set: Vec<(Target, crate::kane::graph::Node)>,
    impact: Option<Impact>,
}

impl MechanismReader {
    pub(super) fn guards(&mut self, keys: &mut KeyReader<'_>, mode: usize) -> Vec<Guard> {
        let nodes = keys.list(&mut self.report, "guards");
        let mut guards: Vec<Guard> = Vec::new();
        if let Some(node) = nodes.get(MOST_GUARDS) {
            let help = format!("there are {MOST_GUARDS} at most");
            self.report.say(node.place, "too many guards of one mode", help);
        }
        for node in nodes.iter().take(MOST_GUARDS) {
            let Some(mut keys) = KeyReader::of(&mut self.report, "guards", node) else { continue };
            let guard = self.guard(&mut keys, mode, guards.len());
            keys.finish(&mut self.report);
            let Some((guard, place)) = guard else {
                self.exits.has_lost = true;
                continue;
            };
            if guards.iter().any(|it| it.name == guard.name) {
                let message = format!("this mode has two guards {}", quoted(&guard.name));
                self.report.say(place, message, "give one of the two another name");
            }
            guards.push(guard);
        }
        guards
    }

    fn guard(
        &mut self,
        keys: &mut KeyReader<'_>,
        mode: usize,
        order: usize,
    ) -> Option<(Guard, SourcePlace)> {
        let named = keys.text(&mut self.report, "name");
        if named.is_none() {
            self.report.miss(keys.place, "the guard has no name", "write name = \"release\"");
        }
        let positive = self.field(keys, "positive");
        if keys.take("positive").is_none() {
            let help = "write positive = \"…\", which is positive while the mode is valid";
            self.report.miss(keys.place, "the guard does not say what is positive", help);
        }
        let value = positive.as_ref().and_then(|it| self.guard_value(it, mode));
        let scale = keys.take("scale");
        let scale = match (scale, value) {
            (Some(entry), Some(value)) => self.constant("scale", &entry.node, value.dimension),
            _ => None,
        };
        let priority = self.priority(keys, order);
        let fires = self.fires(keys);
        let changes = self.changes(keys, mode);
        let branches = self.branches(keys, mode, &changes);
        let sounds = self.field(keys, "sounds");
        let reach = STATE.and(Dependence::FORCES);
        let sounds =
            sounds.and_then(|it| self.mode_value("sounds", &it, reach, Dimension::SPEED, mode));
        let (name, place) = named?;
        let impacts: Vec<_> = branches.iter().filter_map(|it| it.impact).collect();
        if !impacts.is_empty() {
            let place = positive.map_or(place, |it| it.place);
            self.guard_impacts(mode, value?, (scale.unwrap_or(1.0), place), &impacts);
        }
        let unit = value?.dimension.to_string();
        let value = value?.node;
        let name = name.to_owned();
        let guard =
            Guard { name, unit, value, scale, priority, fires, closes: None, branches, sounds };
        Some((guard, place))
    }

    fn guard_value(&mut self, file: &FileExpression, mode: usize) -> Option<Measured> {
        let value = self.value(file, MOTION)?;
        if stays_at_zero(&mut self.graph, value.node) {
            let message = "the guard stays at zero behind its zero, where it never fires";
            let help = "write what goes on below zero, as x for max(x, 0)";
            self.report.say(file.place, message, help);
        }
        Some(self.acting(file, value, mode))
    }

    fn priority(&mut self, keys: &mut KeyReader<'_>, order: usize) -> u8 {
        let order = u8::try_from(order).unwrap_or(u8::MAX);
        let Some(entry) = keys.take("priority") else { return order };
        match entry.node.kind {
            TomlKind::Integer(priority) if (0..256).contains(&priority) => {
                u8::try_from(priority).unwrap_or(order)
            }
            _ => {
                let message = "the priority is no whole number of 0 to 255";
                self.report.say(
                    entry.node.place,
                    message,
                    "write it without quotes; the lowest goes first",
                );
                order
            }
        }
    }

    fn fires(&mut self, keys: &mut KeyReader<'_>) -> Fires {
        match keys.text(&mut self.report, "fires") {
            None | Some(("negative", _)) => Fires::WhileNegative,
            Some(("crossing", _)) => Fires::OnCrossing,
            Some((other, place)) => {
                let message = format!("a guard cannot fire {}", quoted(other));
                self.report.say(place, message, choice(other, ["negative", "crossing"]));
                Fires::WhileNegative
            }
        }
    }

    fn changes(&mut self, keys: &mut KeyReader<'_>, mode: usize) -> GuardChanges {
        let mut set = Vec::new();
        for entry in keys.table(&mut self.report, "set") {
            let Some((target, dimension)) = self.target(entry, &[]) else { continue };
            let Some(file) = self.written(&entry.name, &entry.node) else { continue };
            let reach = STATE.and(Dependence::FORCES);
            let value = self.mode_value(&entry.name, &file, reach, dimension, mode);
            set.extend(value.map(|value| (target, value)));
        }
        let impact = keys.take("impact").and_then(|entry| self.impact(entry));
        GuardChanges { set, impact }
    }

    /// Returns the coordinate or speed of that name; `others` are names that could be meant instead.
    pub(super) fn target(
        &mut self,
        entry: &TomlEntry,
        others: &[&str],
    ) -> Option<(Target, Dimension)> {
        let symbol = self.names.symbols.get(&entry.name).map(|(kind, _)| *kind);
        if let Some(SymbolKind::Coordinate(index)) = symbol {
            return Some((Target::Coordinate(index), self.names.coordinates.get(index).copied()?));
        }
        let speed = self.mechanism.speeds.iter().position(|it| it.name == entry.name);
        if let Some(index) = speed {
            return Some((Target::Speed(index), self.names.speeds.get(index).copied()?));
        }
        let mechanism = &self.mechanism;
        let coordinates = mechanism.coordinates.iter().map(|it| it.name.as_str());
        let known = coordinates.chain(mechanism.speeds.iter().map(|it| it.name.as_str()));
        let known = known.chain(others.iter().copied());
        let help = choice(&entry.name, known);
        let message = format!("there is no coordinate or speed {}", quoted(&entry.name));
        self.report.say(entry.place, message, help);
        None
    }

    fn impact(&mut self, entry: &TomlEntry) -> Option<Impact> {
        let mut keys = KeyReader::new(&mut self.report, entry)?;
        let along = self.field(&mut keys, "along");
        let restitution = self.field(&mut keys, "restitution");
        let within = keys.text(&mut self.report, "within");
        let settles = keys.text(&mut self.report, "settles");
        if keys.take("along").is_none() {
            let help = "write along = \"…\", a distance that is positive apart";
            self.report.miss(entry.place, "the impact does not say along what", help);
        }
        keys.finish(&mut self.report);
        let along = along?;
        let value = self.value(&along, STATE)?;
        // For a distance the rate is meant; a speed is one already.
        let speeds = Dependence::SPEEDS.and(Dependence::INPUT_RATES);
        let is_rate = value.reach.meets(speeds);
        let separation = if is_rate { value } else { self.rate_of(&along, value)? };
        if !is_linear_in_speeds(&self.graph, separation.node) {
            let help = "give the distance itself, or its rate";
            self.report.say(along.place, "the impact's rate is not linear in the speeds", help);
            return None;
        }
        let restitution = match restitution {
            Some(file) => {
                let value = self.node("restitution", &file, CONSTANT, Dimension::NONE)?;
                self.limit_value("restitution", &file, value, 1.0);
                value
            }
            None => self.graph.constant(0.0),
        };
        let within = within.and_then(|(name, place)| self.mode_number(name, place));
        let settles = settles.and_then(|(name, place)| self.mode_number(name, place));
        Some(Impact { separation: separation.node, restitution, within, settles })
    }

    fn branches(
        &mut self,
        keys: &mut KeyReader<'_>,
        mode: usize,
        changes: &GuardChanges,
    ) -> Vec<GuardBranch> {
        let Some(entry) = keys.take("to") else {
            let help = "write to = \"…\", the mode after it; its own mode for a rebound";
            self.report.miss(keys.place, "the guard leads nowhere", help);
            return Vec::new();
        };
        // A single branch means a list of one.
        let one = entry.node.entries().map(|_| std::slice::from_ref(&entry.node));
        let Some(items) = entry.node.items().or(one) else {
            let Some((name, place)) = text(&mut self.report, "to", &entry.node) else {
                return Vec::new();
            };
            let Some(to) = self.mode_number(name, place) else { return Vec::new() };
            let GuardChanges { set, impact } = changes.clone();
            return vec![GuardBranch { when: None, to, set, impact }];
        };
        let mut branches = Vec::new();
        for item in items {
            let branch = self.branch(item, mode, changes);
            self.exits.has_lost |= branch.is_none();
            branches.extend(branch);
        }
        let last = branches.len().saturating_sub(1);
        let is_open = branches.iter().enumerate().any(|(at, it)| it.when.is_none() && at != last);
        if is_open {
            let help = "put the way without a condition last";
            self.report.say(
                entry.place,
                "ways after one without a condition are never taken",
                help,
            );
        }
        branches
    }

    fn branch(
        &mut self,
        node: &TomlNode,
        mode: usize,
        changes: &GuardChanges,
    ) -> Option<GuardBranch> {
        let mut keys = KeyReader::of(&mut self.report, "to", node)?;
        let when = keys.take("when");
        let when = when.and_then(|it| self.written_as("when", &it.node, Form::Condition));
        let target = keys.text(&mut self.report, "mode");
        if target.is_none() {
            self.report.miss(node.place, "this way leads nowhere", "write mode = \"…\"");
        }
        let own = self.changes(&mut keys, mode);
        keys.finish(&mut self.report);
        let when = match when {
            Some(file) => {
                let value = self.value(&file, STATE.and(Dependence::FORCES))?;
                Some(self.acting(&file, value, mode).node)
            }
            None => None,
        };
        let (name, place) = target?;
        let to = self.mode_number(name, place)?;
        let set = if own.set.is_empty() { changes.set.clone() } else { own.set };
        Some(GuardBranch { when, to, set, impact: own.impact.or(changes.impact) })
    }
}
