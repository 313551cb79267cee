//! One line on the changed keys: what the host measured of them, or why it refused a change.

use eframe::egui::{Label, RichText, Ui, vec2};
use telemetry::request::KeyFigure;

use crate::{names, theme, tune::Tuner, tune::checks::CheckedKey, unit};

/// Height of the line, which is there without a message too: no message moves the sliders (points).
const HEIGHT: f32 = 18.0;

pub(super) fn checked_ui(ui: &mut Ui, tuner: &Tuner) {
    let size = vec2(ui.available_width(), HEIGHT);
    let found = tuner.checks.found();
    let warned: Vec<String> = found
        .iter()
        .filter(|(_, checked)| !checked.warnings.is_empty())
        .map(|(key, checked)| format!("{}: {}", names::name(*key), checked.warnings.join("; ")))
        .collect();
    let text = if let Some(refusal) = tuner.refusal() {
        RichText::new(refusal).color(theme::fault(ui))
    } else if !warned.is_empty() {
        RichText::new(warned.join("; ")).color(theme::ORANGE)
    } else if let Some(key) = tuner.checks.measuring() {
        RichText::new(format!("measuring {} …", names::name(key))).weak()
    } else if found.is_empty() {
        RichText::new("")
    } else {
        let keys: Vec<_> = found.keys().map(|key| names::name(*key)).collect();
        RichText::new(format!("{}: figures as expected", keys.join(", "))).weak()
    };
    let line = ui.add_sized(size, Label::new(text).truncate().halign(eframe::egui::Align::LEFT));
    if !found.is_empty() {
        line.on_hover_ui(|ui| found.iter().for_each(|(key, it)| figures_ui(ui, *key, it)));
    }
}

fn figures_ui(ui: &mut Ui, key: u8, checked: &CheckedKey) {
    ui.strong(names::name(key));
    checked.warnings.iter().for_each(|warning| {
        ui.colored_label(theme::ORANGE, warning);
    });
    for KeyFigure { title, value, low, high, .. } in &checked.figures {
        let limit = |it: Option<f64>| it.map_or_else(|| "…".to_owned(), unit::digits);
        let expected = match (low, high) {
            (None, None) => String::new(),
            _ => format!(" ({} to {})", limit(*low), limit(*high)),
        };
        ui.label(format!("{title}: {}{expected}", unit::digits(*value)));
    }
}
