//! What went wrong: what it means, and what to do.

use eframe::egui::{CollapsingHeader, RichText, ScrollArea, Ui};
use telemetry::Event;

use super::nothing_ui;
use crate::desk::Desk;
use crate::explain::{self, Explained};
use crate::{look, names, number};

/// Events that are shown.
const SHOWN: usize = 100;

/// Draws the panel.
pub(super) fn faults_ui(ui: &mut Ui, desk: &mut Desk) {
    let faulty = desk.store.faulty();
    let events: Vec<(Event, Explained)> = desk
        .store
        .events
        .iter()
        .rev()
        .filter_map(|event| Some((event.clone(), explain::event(event.kind())?)))
        .take(SHOWN)
        .collect();
    if faulty.is_empty() && events.is_empty() {
        nothing_ui(ui, "Nothing has gone wrong.");
        return;
    }
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for key in faulty {
            standing_ui(ui, desk, key);
        }
        for (i, (event, explained)) in events.into_iter().enumerate() {
            event_ui(ui, desk, i, &event, explained);
        }
    });
}

/// A key that has a fault now.
fn standing_ui(ui: &mut Ui, desk: &mut Desk, key: u8) {
    let Some(explained) = explain::fault(desk.store.glances.key(key).fault) else { return };
    let text = format!("{} is faulty now: {}", names::name(key), explained.name);
    ui.horizontal(|ui| {
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
fn event_ui(ui: &mut Ui, desk: &mut Desk, i: usize, event: &Event, explained: Explained) {
    let key = number::key(event.key);
    let at = desk.store.when(event);
    let of = key.map(|key| format!(" of {}", names::name(key))).unwrap_or_default();
    let title = format!("{at:.3} s  {}{of}: {}", explained.name, event.text);
    CollapsingHeader::new(title).id_salt((event.tick, event.key, event.kind, i)).show(ui, |ui| {
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
