//! Faults, with their meaning and remedy.

use eframe::egui::{Label, RichText, ScrollArea, Sense, Ui, collapsing_header::CollapsingState};
use serde::{Deserialize, Serialize};
use telemetry::Event;

use super::nothing_ui;
use crate::fault_text::{self, Explanation};
use crate::{app_state::AppState, names, number, theme};

const SHOWN: usize = 100;

#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(super) struct View;

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        let shown = faults_ui(ui, state);
        if let Some(key) = shown.key {
            state.select(key);
        }
        if let Some(at) = shown.at {
            let scopes = state.view.scopes.values_mut();
            scopes.for_each(|scope| scope.pinned = Some(at + scope.window / 2.0));
        }
    }
}

/// Key and time that were clicked, to be shown in the other panels.
#[derive(Default)]
struct Clicked {
    key: Option<u8>,
    at: Option<f64>,
}

fn faults_ui(ui: &mut Ui, state: &AppState) -> Clicked {
    let faulty = state.store.faulty();
    let events = events(state);
    let mut clicked = Clicked::default();
    let boards = &state.store.conditions.boards;
    if faulty.is_empty() && events.is_empty() && boards.is_empty() {
        nothing_ui(ui, state, "Nothing has gone wrong.");
        return clicked;
    }
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for board in boards {
            ui.label(RichText::new(board).strong().color(theme::fault(ui)));
        }
        for key in faulty {
            faulty_key_ui(ui, state, key, &mut clicked);
        }
        for (number, event, explanation) in events {
            event_ui(ui, state, (number, event, explanation), &mut clicked);
        }
    });
    clicked
}

/// Returns the faults, newest first, each with a number that stays while others arrive.
fn events(state: &AppState) -> Vec<(u64, &Event, Explanation)> {
    let numbers = (0..state.store.events.count()).rev();
    let newest_first = numbers.zip(state.store.events.iter().rev());
    newest_first
        .filter_map(|(number, event)| Some((number, event, fault_text::event(event.kind())?)))
        .take(SHOWN)
        .collect()
}

fn faulty_key_ui(ui: &mut Ui, state: &AppState, key: u8, clicked: &mut Clicked) {
    let Some(explanation) = fault_text::fault(state.store.summaries.key(key).fault) else { return };
    let text = format!("{} is faulty now: {}", names::name(key), explanation.name);
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(text).strong().color(theme::fault(ui)));
        if ui.small_button(format!("Show {}", names::name(key))).clicked() {
            clicked.key = Some(key);
        }
    });
    ui.label(explanation.what);
    ui.weak(explanation.advice);
    ui.separator();
}

fn event_ui(
    ui: &mut Ui,
    state: &AppState,
    (number, event, explanation): (u64, &Event, Explanation),
    clicked: &mut Clicked,
) {
    let key = number::key(event.key);
    let at = state.store.when(event);
    let of = key.map(|key| format!(" of {}", names::name(key))).unwrap_or_default();
    let title = format!("{at:.3} s  {}{of}: {}", explanation.name, event.text);
    let id = ui.make_persistent_id(("event", number));
    let header = CollapsingState::load_with_default_open(ui.ctx(), id, false);
    // A header of egui's own does not wrap.
    let mut is_clicked = false;
    let mut header = header.show_header(ui, |ui| {
        let title = Label::new(title).wrap().selectable(false);
        is_clicked = ui.add(title.sense(Sense::click())).clicked();
    });
    if is_clicked {
        header.toggle();
    }
    header.body(|ui| {
        ui.label(explanation.what);
        ui.weak(explanation.advice);
        if ui.small_button("Show in the scopes").clicked() {
            *clicked = Clicked { key, at: Some(at) };
        }
    });
}
