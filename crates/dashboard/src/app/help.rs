//! The shortcuts, in a window.

use eframe::egui::{Context, Grid, Window};

use super::shortcuts;
use crate::app_state::AppState;

pub(super) fn help_ui(ctx: &Context, state: &mut AppState) {
    let mut is_open = state.view.shows_help;
    Window::new("Shortcuts").open(&mut is_open).resizable(false).collapsible(false).show(
        ctx,
        |ui| {
            Grid::new("shortcuts").num_columns(2).striped(true).show(ui, |ui| {
                for (keys, text) in shortcuts::list(ctx) {
                    ui.monospace(keys);
                    ui.label(text);
                    ui.end_row();
                }
            });
            ui.separator();
            ui.label("In a scope: drag moves, the wheel zooms, a drag with the right button");
            ui.label("zooms to what it covers, a double click follows again.");
            ui.label("Shift and the wheel, or the y axis under the mouse, zoom in values;");
            ui.label("a double click on the axis shows all of them again.");
            ui.label("Shift and a click on a key selects all keys up to it.");
        },
    );
    state.view.shows_help = is_open;
}
