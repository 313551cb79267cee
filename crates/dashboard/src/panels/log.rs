//! Messages of the host and of this window, in sentences.

use eframe::egui::{ScrollArea, Ui};
use serde::{Deserialize, Serialize};
use telemetry::log::Level;

use super::nothing_ui;
use crate::{app_state::AppState, theme};

#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(super) struct View;

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        if state.store.log.is_empty() {
            nothing_ui(ui, state, "No messages yet.");
            return;
        }
        ScrollArea::vertical().auto_shrink(false).stick_to_bottom(true).show(ui, |ui| {
            for (_at, entry) in &state.store.log {
                match entry.level() {
                    Level::Info => ui.label(&entry.text),
                    Level::Warning => ui.colored_label(theme::warning(ui), &entry.text),
                    Level::Error => ui.colored_label(theme::fault(ui), &entry.text),
                };
            }
        });
    }
}
