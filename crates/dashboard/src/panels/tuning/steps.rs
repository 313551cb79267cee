//! Undo and redo: one step, or to any of the last ones.

use std::collections::BTreeSet;

use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{Button, PopupCloseBehavior, RichText, ScrollArea, Ui};
use telemetry::Difference;

use crate::tune::edit::{EditPatch, ParameterSlot};
use crate::unit::{self, ParameterReading};
use crate::{app_state::AppState, names, tune::Tuner, tune::history::UndoStep};

/// Height of the list before it scrolls (points).
const HEIGHT: f32 = 320.0;

pub(super) fn steps_ui(ui: &mut Ui, state: &mut AppState) {
    let tuner = &state.tuner;
    let history = tuner.history();
    let text = |step: Option<&UndoStep>| step.map(|step| line(step, tuner));
    let (last, next) = (text(history.last()), text(history.next()));
    let undo = ui.add_enabled(last.is_some(), Button::new("Undo"));
    if undo.on_hover_text(last.unwrap_or_default()).clicked() {
        state.undo();
    }
    let redo = ui.add_enabled(next.is_some(), Button::new("Redo"));
    if redo.on_hover_text(next.unwrap_or_default()).clicked() {
        state.redo();
    }
    // The menu stays open, so that one can listen to several steps in turn.
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let (button, _) = MenuButton::new("History").config(config).ui(ui, |ui| list_ui(ui, state));
    button.on_hover_text("What was changed; a click goes back to it, or forward.");
}

fn list_ui(ui: &mut Ui, state: &mut AppState) {
    let tuner = &state.tuner;
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
        let keys = state.tuner.go_to(place);
        state.show_keys(keys);
    }
}

fn line(step: &UndoStep, tuner: &Tuner) -> String {
    let UndoStep { text, before, after, .. } = step;
    let slots = after.slots.keys();
    let parameters: BTreeSet<&str> = slots.map(|it| it.parameter.as_str()).collect();
    if !after.instruments.is_empty() {
        let names: BTreeSet<&str> = before.instruments.values().map(String::as_str).collect();
        let names: Vec<_> = names.into_iter().collect();
        return format!("{text}, before: {}", names.join(", "));
    }
    let first = after.slots.keys().next();
    let Some(slot) = first.filter(|_| parameters.len() == 1) else {
        let keys = after.keys().map_or_else(String::new, |keys| names::range_name(&keys));
        return format!("{text}: {} values of {keys}", after.slots.len());
    };
    let Some(parameter) = tuner.parameter(slot.key, &slot.parameter) else { return text.clone() };
    let reading = unit::of(parameter);
    format!("{text}: from {} to {}", span(before, tuner, reading), span(after, tuner, reading))
}

fn span(patch: &EditPatch, tuner: &Tuner, reading: ParameterReading<'_>) -> String {
    let value = |(slot, difference): (&ParameterSlot, &Option<Difference>)| {
        let base = tuner.base(slot.key, &slot.parameter)?;
        Some(difference.map_or(base, |it| it.applied_to(base)))
    };
    let texts: Vec<_> = patch.slots.iter().filter_map(value).map(|it| reading.text(it)).collect();
    match (texts.first(), texts.last()) {
        (Some(first), Some(last)) if first != last => format!("{first}..{last}"),
        (first, _) => first.cloned().unwrap_or_default(),
    }
}
