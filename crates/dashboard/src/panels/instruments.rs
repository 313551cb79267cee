//! Which instrument plays which keys, and another one for a range.

use std::ops::RangeInclusive;

use eframe::egui::{Grid, RichText, ScrollArea, TextEdit, Ui};
use telemetry::{Instrument, Request};

use super::nothing_ui;
use crate::desk::AppState;
use crate::{look, names};

/// What the panel remembers.
#[derive(Clone, Debug, Default)]
pub(crate) struct View {
    /// The range, while somebody writes it; else the selected one.
    range: Option<String>,
}

/// Draws the panel.
pub(super) fn instruments_ui(ui: &mut Ui, desk: &mut AppState) {
    let Some(catalogue) = desk.store.catalogue.clone() else {
        nothing_ui(ui, "The host has not told yet what it has.");
        return;
    };
    let range = range_ui(ui, desk);
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for instrument in &catalogue.instruments {
            instrument_ui(ui, desk, instrument, range.as_ref());
        }
        ui.separator();
        ui.strong("What plays now");
        ScrollArea::horizontal().show(ui, |ui| runs_ui(ui, desk));
        ui.separator();
        ui.strong("Models");
        for model in &catalogue.models {
            ui.label(&model.name).on_hover_text(format!(
                "modes: {}\nparameters: {}",
                model.modes.join(", "),
                model.parameters.len()
            ));
            ui.weak(&model.summary);
        }
    });
}

/// For which keys: typed, or selected on the keyboard.
fn range_ui(ui: &mut Ui, desk: &mut AppState) -> Option<RangeInclusive<u8>> {
    let selected = names::range_name(&desk.range());
    let mut text = desk.views.instruments.range.clone().unwrap_or_else(|| selected.clone());
    ui.horizontal_wrapped(|ui| {
        let label = ui.label("for keys");
        let edit = ui.add(TextEdit::singleline(&mut text).desired_width(90.0));
        if edit.labelled_by(label.id).changed() {
            desk.views.instruments.range = Some(text.clone());
        }
        if ui.button("Selected").clicked() {
            desk.views.instruments.range = None;
        }
        if ui.button("All").clicked() {
            desk.views.instruments.range = Some("all".to_owned());
        }
        let range = names::range(&text);
        if range.is_none() {
            ui.colored_label(look::fault(ui), "write C4..B5, C4 or all");
        }
        range
    })
    .inner
}

fn instrument_ui(
    ui: &mut Ui,
    desk: &mut AppState,
    instrument: &Instrument,
    range: Option<&RangeInclusive<u8>>,
) {
    ui.horizontal_wrapped(|ui| {
        let name = RichText::new(&instrument.name).strong();
        let button = eframe::egui::Button::new(name).min_size(eframe::egui::vec2(120.0, 0.0));
        let clicked = ui.add_enabled(range.is_some(), button).clicked();
        if clicked && let Some(range) = range {
            let keys = (*range != (0..=names::LAST)).then(|| names::range_name(range));
            desk.ask(Request::UseInstrument { instrument: instrument.name.clone(), keys });
        }
        ui.weak(&instrument.model);
    });
    if !instrument.doc.is_empty() {
        ui.label(RichText::new(&instrument.doc).small());
    }
    ui.add_space(2.0);
}

fn runs_ui(ui: &mut Ui, desk: &mut AppState) {
    Grid::new("now").num_columns(3).striped(true).spacing([14.0, 3.0]).show(ui, |ui| {
        for (range, instrument, model) in runs(desk) {
            run_ui(ui, desk, &range, instrument, &model);
            ui.end_row();
        }
    });
}

/// A stretch of keys; a click selects it.
fn run_ui(
    ui: &mut Ui,
    desk: &mut AppState,
    range: &RangeInclusive<u8>,
    instrument: String,
    model: &str,
) {
    if ui.link(names::range_name(range)).clicked() {
        desk.select(*range.start());
        desk.select_up_to(*range.end());
    }
    ui.label(instrument);
    ui.weak(model);
}

/// Stretches of keys that the same instrument plays.
fn runs(desk: &AppState) -> Vec<(RangeInclusive<u8>, String, String)> {
    let mut runs: Vec<(RangeInclusive<u8>, String, String)> = Vec::new();
    for (key, voice) in desk.store.voices() {
        if let Some((range, instrument, model)) = runs.last_mut()
            && *instrument == voice.instrument
            && *model == voice.model
            && range.end() + 1 == key
        {
            *range = *range.start()..=key;
        } else {
            runs.push((key..=key, voice.instrument.clone(), voice.model.clone()));
        }
    }
    runs
}
