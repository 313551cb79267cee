//! Messages sent to a synthesizer.

use eframe::egui::{RichText, ScrollArea, TextEdit, TextStyle, Ui};
use serde::{Deserialize, Serialize};
use telemetry::Midi;

use super::{nothing_ui, piece_ui};
use crate::app_state::AppState;

#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct View {
    filter: String,
}

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        self.controls_ui(ui, state);
        let filter = self.filter.as_str();
        let shown: Vec<&Midi> =
            state.store.midi.iter().filter(|midi| midi.text.contains(filter)).collect();
        if shown.is_empty() {
            nothing_ui(ui, state, "No message yet.");
            return;
        }
        let height = ui.text_style_height(&TextStyle::Monospace);
        let area = ScrollArea::both().auto_shrink(false).stick_to_bottom(true);
        area.show_rows(ui, height, shown.len(), |ui, rows| {
            for midi in &shown[rows] {
                piece_ui(ui, RichText::new(line(midi)).monospace());
            }
        });
    }
}

impl View {
    fn controls_ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        ui.horizontal_wrapped(|ui| {
            let label = ui.label("only with");
            let filter = TextEdit::singleline(&mut self.filter).desired_width(110.0);
            ui.add(filter.hint_text("note on")).labelled_by(label.id);
            if ui.button("Clear").clicked() {
                state.store.midi.clear();
            }
            piece_ui(ui, RichText::new(format!("{} in all", state.store.midi.count())).weak());
        });
    }
}

fn line(midi: &Midi) -> String {
    let bytes: Vec<String> = midi.bytes.iter().map(|byte| format!("{byte:02X}")).collect();
    format!("{:>9.3} s  {:<9} {}", midi.at, bytes.join(" "), midi.text)
}
