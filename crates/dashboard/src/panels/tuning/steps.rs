//! Undo and redo: one step, or to any of the last ones.

use std::collections::BTreeSet;

use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{Button, PopupCloseBehavior, RichText, ScrollArea, Ui};

use crate::tune::Tuner;
use crate::tune::history::UndoStep;
use crate::tune::snapshot::SlotValues;
use crate::{names, unit};

/// Height of the list before it scrolls (points).
const HEIGHT: f32 = 320.0;

pub(super) fn steps_ui(ui: &mut Ui, tuner: &mut Tuner) {
    let history = tuner.history();
    let text = |step: Option<&UndoStep>| step.map(|step| line(step, tuner));
    let (last, next) = (text(history.last()), text(history.next()));
    let undo = ui.add_enabled(last.is_some(), Button::new("Undo"));
    if undo.on_hover_text(last.unwrap_or_default()).clicked() {
        tuner.undo();
    }
    let redo = ui.add_enabled(next.is_some(), Button::new("Redo"));
    if redo.on_hover_text(next.unwrap_or_default()).clicked() {
        tuner.redo();
    }
    // The menu stays open, so that one can listen to several steps in turn.
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let (button, _) = MenuButton::new("History").config(config).ui(ui, |ui| list_ui(ui, tuner));
    button.on_hover_text("What was changed; a click goes back to it, or forward.");
}

/// Draws all steps, the newest above; undone ones are faint.
fn list_ui(ui: &mut Ui, tuner: &mut Tuner) {
    let history = tuner.history();
    let here = history.steps().len();
    let done = history.steps().iter().rev().map(|step| line(step, tuner));
    let mut undone: Vec<String> = history.undone().map(|step| line(step, tuner)).collect();
    undone.reverse();
    let first = std::iter::once("as it was before".to_owned());
    let lines: Vec<String> = undone.into_iter().chain(done).chain(first).collect();
    let chosen = ScrollArea::vertical().max_height(HEIGHT).show(ui, |ui| {
        let mut chosen = None;
        for (place, line) in (0..lines.len()).rev().zip(&lines) {
            let text = RichText::new(line);
            let text = if here < place { text.weak() } else { text };
            if ui.selectable_label(place == here, text).clicked() {
                chosen = Some(place);
            }
        }
        chosen
    });
    if let Some(place) = chosen.inner {
        tuner.go_to(place);
    }
}

/// Describes the keys and values that a step changed.
fn line(step: &UndoStep, tuner: &Tuner) -> String {
    let parameters: BTreeSet<&str> = step.after.keys().map(|it| it.parameter.as_str()).collect();
    let first = step.after.keys().next();
    let Some(slot) = first.filter(|_| parameters.len() == 1) else {
        return format!("{}: {} values of {}", step.text, step.after.len(), keys(&step.after));
    };
    let unit = tuner.parameter(slot.key, &slot.parameter).map_or("", |it| it.unit.as_str());
    let (before, after) = (span(&step.before), span(&step.after));
    format!("{}: from {before} to {after}{}", step.text, unit::suffix(unit))
}

/// Returns the keys of some values, from the lowest to the highest.
fn keys(values: &SlotValues) -> String {
    let keys = || values.keys().map(|slot| slot.key);
    let range = keys().min().zip(keys().max());
    range.map_or_else(String::new, |(low, high)| names::range_name(&(low..=high)))
}

/// Returns the smallest and the largest value, or the only one.
fn span(values: &SlotValues) -> String {
    let low = unit::exact(values.values().copied().fold(f64::INFINITY, f64::min));
    let high = unit::exact(values.values().copied().fold(f64::NEG_INFINITY, f64::max));
    if low == high { low } else { format!("{low}..{high}") }
}
