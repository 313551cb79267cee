//! Numbers that cannot be meant: of laws on every key, and at the start of every preset.

use documents::quoted;
use documents::toml::SourcePlace;

use super::items::{FileExpression, GuardedImpact, LawLimit};
use super::names::number;
use super::reader::MechanismReader;
use crate::kane::graph::{Node, Place};
use crate::kane::mechanism::Impact;
use crate::kane::tape::TapeArguments;
use crate::kane::text::{Dimension, Measured};

/// Share of what a constraint can be within the ranges from which on a start contradicts it.
const CONTRADICTION: f64 = 1e-3;

/// Values of a preset, with the state and the mode at its start.
#[derive(Clone, Copy, Debug)]
pub(super) struct PresetPose<'a> {
    pub(super) preset: usize,
    pub(super) constants: &'a [f64],
    pub(super) state: &'a [f64],
    pub(super) mode: usize,
}

impl MechanismReader {
    /// Returns the value of a law that is not negative where it follows from the parameters.
    pub(super) fn not_negative(
        &mut self,
        name: &str,
        file: &FileExpression,
        dimension: Dimension,
    ) -> Option<Node> {
        let value = self.node(name, file, super::reader::CONSTANT, dimension)?;
        self.limit_value(name, file, value, f64::INFINITY);
        Some(value)
    }

    pub(super) fn limit_value(
        &mut self,
        name: &str,
        file: &FileExpression,
        value: Node,
        highest: f64,
    ) {
        if !self.graph.depends(value, |place| !matches!(place, Place::Parameter(_))) {
            let (name, place) = (name.to_owned(), file.place);
            self.built.plausible.limits.push(LawLimit { name, value, highest, place });
        }
    }

    /// Remembers the impacts to which a guard of this scale leads.
    pub(super) fn guard_impacts(
        &mut self,
        mode: usize,
        guard: Measured,
        (scale, place): (f64, SourcePlace),
        impacts: &[Impact],
    ) {
        let Ok(rate) = self.names.total_rate(&mut self.graph, guard) else { return };
        let (guard, rate) = (guard.node, rate.node);
        for Impact { separation, .. } in impacts.iter().copied() {
            let impact = GuardedImpact { mode, guard, rate, scale, separation, place };
            self.built.plausible.impacts.push(impact);
        }
    }

    /// Checks the limits of laws with the values of a preset for one key; each is said once.
    pub(super) fn check_limits(&mut self, preset: usize, constants: &[f64], key: u8) {
        let nodes: Vec<_> = self.built.plausible.limits.iter().map(|it| it.value).collect();
        let Some(values) = self.numbers(&nodes, constants, &[]) else { return };
        let mut values = values.into_iter();
        let is_kept = |limit: &LawLimit| {
            values.next().is_none_or(|it| it.is_nan() || (0.0..=limit.highest).contains(&it))
        };
        let (kept, beyond) =
            std::mem::take(&mut self.built.plausible.limits).into_iter().partition(is_kept);
        self.built.plausible.limits = kept;
        for LawLimit { name, highest, place, .. } in beyond {
            let (what, help) = if highest.is_finite() {
                ("outside 0 to 1", "write a restitution of 0 (plastic) to 1 (elastic)".to_owned())
            } else {
                let help = "give it another sign; a law that is meant so stands in [forces]";
                ("negative", help.to_owned())
            };
            let preset = self.preset_name(preset);
            let message = format!("{} is {what} in preset {preset} on key {key}", quoted(&name));
            self.report.say(place, message, help);
        }
    }

    fn numbers(&self, nodes: &[Node], constants: &[f64], state: &[f64]) -> Option<Vec<f64>> {
        let arguments = TapeArguments { constants, state, ..TapeArguments::default() };
        Some(self.tape(nodes)?.evaluate(&arguments))
    }

    /// Checks impacts, and what a stated start contradicts.
    pub(super) fn check_start(&mut self, pose: PresetPose<'_>) {
        for impact in self.built.plausible.impacts.clone() {
            self.check_impact(pose, impact);
        }
        if self.mechanism.rest.is_start {
            self.check_gaps(pose);
            self.check_constraints(pose);
        }
    }

    fn check_impact(&mut self, pose: PresetPose<'_>, impact: GuardedImpact) {
        let speeds = 0..self.mechanism.speeds.len();
        let mut slopes = |rate: Node| -> Vec<Node> {
            let places = speeds.clone().map(|j| Place::Speed(number(j)));
            places.map(|place| self.graph.partial(rate, place)).collect()
        };
        let [apart, separation] = [impact.rate, impact.separation].map(&mut slopes);
        let values = [apart.as_slice(), &separation, &[impact.guard]];
        let values = values.map(|it| self.numbers(it, pose.constants, pose.state));
        let [Some(a), Some(b), Some(inside)] = values else { return };
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        // Opposed to rounding: a direction that only slants may be meant.
        if dot(&a, &b) < -(1.0 - 1e-9) * (dot(&a, &a) * dot(&b, &b)).sqrt() {
            let message = "the impact of this guard is along a direction opposed to it";
            let help = "write along with the sign of this: a distance that is positive apart";
            self.report.say(impact.place, message, help);
        }
        let inside = inside.first().copied().unwrap_or(0.0);
        let is_start = self.mechanism.rest.is_start && impact.mode == pose.mode;
        if is_start && inside < -1e-9 * impact.scale {
            self.say_inside(
                pose.preset,
                "what the impact of this guard parts",
                inside,
                impact.place,
            );
        }
    }

    fn check_gaps(&mut self, pose: PresetPose<'_>) {
        let Some(mode) = self.mechanism.modes.get(pose.mode) else { return };
        let contacts = mode.contacts.iter().filter_map(|it| self.mechanism.contacts.get(*it));
        let mut inside = Vec::new();
        for contact in contacts {
            let gap = contact.gap.and_then(|gap| self.numbers(&[gap], pose.constants, pose.state));
            let gap = gap.and_then(|it| it.first().copied()).unwrap_or(0.0);
            if gap < -contact.scale {
                inside.push((contact.name.clone(), gap));
            }
        }
        for (name, gap) in inside {
            let place = self.names.laws.names.get(&name).map(|(_, place)| *place);
            self.say_inside(pose.preset, &quoted(&name), gap, place.unwrap_or_default());
        }
    }

    fn say_inside(&mut self, preset: usize, what: &str, gap: f64, place: SourcePlace) {
        let preset = self.preset_name(preset);
        let message = format!("{what} begins {:.3e} inside in preset {preset}", -gap);
        let help = "let it begin apart, or write the distance with the other sign, positive apart";
        self.report.say(place, message, help);
    }

    /// Checks constraints between coordinates that [rest] gives: others are moved onto them.
    fn check_constraints(&mut self, pose: PresetPose<'_>) {
        let Some(mode) = self.mechanism.modes.get(pose.mode) else { return };
        for constraint in mode.constraints.clone() {
            let Some(it) = self.mechanism.constraints.get(constraint).cloned() else { continue };
            let given = &self.mechanism.rest.coordinates;
            let is_open = |index: u16| given.get(usize::from(index)).is_none_or(Option::is_none);
            let is_open = |place| matches!(place, Place::Coordinate(index) if is_open(index));
            if self.graph.depends(it.zero, is_open) {
                continue;
            }
            let mut slopes = vec![it.zero];
            let mut widths = vec![0.0];
            for (index, coordinate) in self.mechanism.coordinates.iter().enumerate() {
                slopes.push(self.graph.partial(it.zero, Place::Coordinate(number(index))));
                widths.push(coordinate.range.1 - coordinate.range.0);
            }
            let Some(values) = self.numbers(&slopes, pose.constants, pose.state) else { continue };
            let size: f64 =
                values.iter().zip(widths).map(|(slope, width)| (slope * width).abs()).sum();
            let Some(zero) = values.first().filter(|it| CONTRADICTION * size < it.abs()) else {
                continue;
            };
            let preset = self.preset_name(pose.preset);
            let message = format!(
                "the start contradicts the constraint {}, which is {zero:.3e} there (preset {preset})",
                quoted(&it.name)
            );
            let help = "give coordinates that meet it, or leave one of them out: it follows then";
            self.report.say(self.places.rest, message, help);
        }
    }
}
