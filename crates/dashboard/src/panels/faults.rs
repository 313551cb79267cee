//! What went wrong: what it means, and what to do.

use eframe::egui::collapsing_header::CollapsingState;
use eframe::egui::{Label, RichText, ScrollArea, Sense, Ui};
use telemetry::Event;

use super::nothing_ui;
use crate::desk::AppState;
use crate::explain::{self, Explained};
use crate::{look, names, number};

/// Events that are shown.
const SHOWN: usize = 100;

/// Draws the panel.
pub(super) fn faults_ui(ui: &mut Ui, desk: &mut AppState) {
    let faulty = desk.store.faulty();
    let events = events(desk);
    if faulty.is_empty() && events.is_empty() {
        nothing_ui(ui, "Nothing has gone wrong.");
        return;
    }
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for key in faulty {
            standing_ui(ui, desk, key);
        }
        for (number, event, explained) in events {
            event_ui(ui, desk, number, &event, explained);
        }
    });
}

/// What went wrong, newest first, each with the number that it keeps while others arrive.
fn events(desk: &AppState) -> Vec<(u64, Event, Explained)> {
    let numbers = (0..desk.store.events.count()).rev();
    let newest_first = numbers.zip(desk.store.events.iter().rev());
    newest_first
        .filter_map(|(number, event)| Some((number, event.clone(), explain::event(event.kind())?)))
        .take(SHOWN)
        .collect()
}

/// A key that has a fault now.
fn standing_ui(ui: &mut Ui, desk: &mut AppState, key: u8) {
    let Some(explained) = explain::fault(desk.store.glances.key(key).fault) else { return };
    let text = format!("{} is faulty now: {}", names::name(key), explained.name);
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(text).strong().color(look::fault(ui)));
        if ui.small_button(format!("Show {}", names::name(key))).clicked() {
            desk.select(key);
        }
    });
    ui.label(explained.what);
    ui.weak(explained.advice);
    ui.separator();
}

/// Something that happened; unfolded, what it means.
fn event_ui(ui: &mut Ui, desk: &mut AppState, number: u64, event: &Event, explained: Explained) {
    let key = number::key(event.key);
    let at = desk.store.when(event);
    let of = key.map(|key| format!(" of {}", names::name(key))).unwrap_or_default();
    let title = format!("{at:.3} s  {}{of}: {}", explained.name, event.text);
    let id = ui.make_persistent_id(("event", number));
    let state = CollapsingState::load_with_default_open(ui.ctx(), id, false);
    // A header of egui's own does not wrap.
    let mut is_clicked = false;
    let mut header = state.show_header(ui, |ui| {
        let title = Label::new(title).wrap().selectable(false);
        is_clicked = ui.add(title.sense(Sense::click())).clicked();
    });
    if is_clicked {
        header.toggle();
    }
    header.body(|ui| {
        ui.label(explained.what);
        ui.weak(explained.advice);
        if ui.small_button("Show in the scopes").clicked() {
            if let Some(key) = key {
                desk.select(key);
            }
            desk.views.scopes.values_mut().for_each(|it| it.pinned = Some(at + it.window / 2.0));
        }
    });
}
