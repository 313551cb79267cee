//! What people should read.

use eframe::egui::{ScrollArea, Ui};
use telemetry::log::Level;

use super::nothing_ui;
use crate::desk::AppState;
use crate::look;

/// Draws the panel.
pub(super) fn log_ui(ui: &mut Ui, desk: &AppState) {
    if desk.store.log.is_empty() {
        nothing_ui(ui, "Nothing to read.");
        return;
    }
    ScrollArea::vertical().auto_shrink(false).stick_to_bottom(true).show(ui, |ui| {
        for entry in &desk.store.log {
            match entry.level() {
                Level::Info => ui.label(&entry.text),
                Level::Warning => ui.colored_label(look::ORANGE, &entry.text),
                Level::Error => ui.colored_label(look::fault(ui), &entry.text),
            };
        }
    });
}
