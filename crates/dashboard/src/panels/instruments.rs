//! Instruments and their keys, and another instrument for a range.

use std::ops::RangeInclusive;

use eframe::egui::{Button, Grid, RichText, ScrollArea, TextEdit, Ui, vec2};
use serde::{Deserialize, Serialize};
use telemetry::{Instrument, Model};

use super::nothing_ui;
use crate::{app_state::AppState, names, store::Store, theme, tune::edit::BaseValues};

#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct View {
    /// The range as typed; the selected one if `None`.
    #[serde(skip)]
    range: Option<String>,
}

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        let Some(catalogue) = &state.store.catalogue else {
            nothing_ui(ui, state, "The host has not told yet what it has.");
            return;
        };
        let range = self.range_ui(ui, state).filter(|_| state.may_change());
        let area = ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let mut chosen = None;
            for instrument in &catalogue.instruments {
                let playing = keys_of(&state.store, &instrument.name);
                let choice = instrument_ui(ui, instrument, range.as_ref(), &playing);
                chosen = chosen.or(choice.map(|it| (instrument.name.clone(), it)));
            }
            ui.separator();
            ui.strong("What plays now");
            let run = ScrollArea::horizontal().show(ui, |ui| runs_ui(ui, &state.store)).inner;
            ui.separator();
            ui.strong("Models");
            catalogue.models.iter().for_each(|model| model_ui(ui, model));
            (chosen, run)
        });
        let (chosen, run) = area.inner;
        if let Some(((instrument, values), range)) = chosen.zip(range) {
            state.tuner.use_instrument(&instrument, &range, values);
        }
        if let Some(run) = run {
            state.select(*run.start());
            state.select_up_to(*run.end());
        }
    }
}

impl View {
    fn range_ui(&mut self, ui: &mut Ui, state: &AppState) -> Option<RangeInclusive<u8>> {
        let mut text = self.range.clone().unwrap_or_else(|| names::range_name(&state.range()));
        ui.horizontal_wrapped(|ui| {
            let label = ui.label("for keys");
            let edit = ui.add(TextEdit::singleline(&mut text).desired_width(90.0));
            if edit.labelled_by(label.id).changed() {
                self.range = Some(text.clone());
            }
            if ui.button("Selected").clicked() {
                self.range = None;
            }
            if ui.button("All").clicked() {
                self.range = Some("all".to_owned());
            }
            let range = names::range(&text);
            if range.is_none() {
                ui.colored_label(theme::fault(ui), "write C4..B5, C4 or all");
            }
            range
        })
        .inner
    }
}

fn instrument_ui(
    ui: &mut Ui,
    instrument: &Instrument,
    range: Option<&RangeInclusive<u8>>,
    playing: &str,
) -> Option<BaseValues> {
    let row = ui.horizontal_wrapped(|ui| {
        let name = RichText::new(&instrument.name).strong();
        let button = Button::new(name).min_size(vec2(120.0, 0.0)).selected(!playing.is_empty());
        let is_chosen = ui.add_enabled(range.is_some(), button).clicked();
        ui.weak(&instrument.model);
        ui.weak(playing);
        is_chosen.then_some(BaseValues::Saved)
    });
    let mut choice = row.inner;
    if instrument.base_changed {
        ui.horizontal_wrapped(|ui| {
            let Instrument { base, .. } = instrument;
            ui.colored_label(theme::ORANGE, format!("{base} has changed since this was saved:"));
            if ui.button("as saved").clicked() {
                choice = Some(BaseValues::Saved);
            }
            if ui.button(format!("on the present {base}")).clicked() {
                choice = Some(BaseValues::Present);
            }
        });
    }
    if !instrument.doc.is_empty() {
        ui.label(RichText::new(&instrument.doc).small());
    }
    ui.add_space(2.0);
    choice
}

fn keys_of(store: &Store, instrument: &str) -> String {
    let of_it = runs(store).into_iter().filter(|run| run.instrument == instrument);
    let ranges: Vec<_> = of_it.map(|run| names::range_name(&run.keys)).collect();
    if ranges.is_empty() { String::new() } else { format!("plays {}", ranges.join(", ")) }
}

fn model_ui(ui: &mut Ui, model: &Model) {
    ui.label(&model.name).on_hover_text(format!(
        "modes: {}\nparameters: {}",
        model.modes.join(", "),
        model.parameters.len()
    ));
    ui.weak(&model.summary);
}

fn runs_ui(ui: &mut Ui, store: &Store) -> Option<RangeInclusive<u8>> {
    let mut clicked = None;
    Grid::new("now").num_columns(3).striped(true).spacing([14.0, 3.0]).show(ui, |ui| {
        for run in runs(store) {
            if ui.link(names::range_name(&run.keys)).clicked() {
                clicked = Some(run.keys);
            }
            ui.label(run.instrument);
            ui.weak(run.model);
            ui.end_row();
        }
    });
    clicked
}

struct InstrumentRun<'a> {
    keys: RangeInclusive<u8>,
    instrument: &'a str,
    model: &'a str,
}

fn runs(store: &Store) -> Vec<InstrumentRun<'_>> {
    let mut runs: Vec<InstrumentRun<'_>> = Vec::new();
    for (key, voice) in store.voices() {
        if let Some(run) = runs.last_mut()
            && run.instrument == voice.instrument
            && run.model == voice.model
            && run.keys.end() + 1 == key
        {
            run.keys = *run.keys.start()..=key;
        } else {
            let (instrument, model) = (&voice.instrument, &voice.model);
            runs.push(InstrumentRun { keys: key..=key, instrument, model });
        }
    }
    runs
}
