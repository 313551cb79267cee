//! What was sent to a synthesizer.

use eframe::egui::{RichText, ScrollArea, TextEdit, TextStyle, Ui};
use serde::{Deserialize, Serialize};
use telemetry::Midi;

use super::{nothing_ui, piece_ui};
use crate::desk::AppState;

/// What the panel remembers.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct View {
    /// Messages in whose words this is.
    filter: String,
}

/// Draws the panel.
pub(super) fn midi_ui(ui: &mut Ui, desk: &mut AppState) {
    ui.horizontal_wrapped(|ui| {
        let label = ui.label("only with");
        let filter = TextEdit::singleline(&mut desk.views.midi.filter).desired_width(110.0);
        ui.add(filter.hint_text("note on")).labelled_by(label.id);
        if ui.button("Clear").clicked() {
            desk.store.midi.clear();
        }
        piece_ui(ui, RichText::new(format!("{} in all", desk.store.midi.count())).weak());
    });
    let filter = desk.views.midi.filter.as_str();
    let shown: Vec<&Midi> =
        desk.store.midi.iter().filter(|midi| midi.text.contains(filter)).collect();
    if shown.is_empty() {
        nothing_ui(ui, "No message yet.");
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

fn line(midi: &Midi) -> String {
    let bytes: Vec<String> = midi.bytes.iter().map(|byte| format!("{byte:02X}")).collect();
    format!("{:>9.3} s  {:<9} {}", midi.at, bytes.join(" "), midi.text)
}
