//! One file for each panel. To make another: copy a small one, add it to [`Pane`] and to
//! [`panel_ui`], and a snapshot of it to `tests/snapshots.rs`.

pub(crate) mod deadlines;
mod faults;
pub(crate) mod instruments;
pub(crate) mod keyboard;
pub(crate) mod links;
mod log;
mod mechanism;
pub(crate) mod midi;
mod overview;
pub(crate) mod phase;
pub(crate) mod scope;
mod timeline;
pub(crate) mod tuning;

use eframe::egui::{Color32, Label, ProgressBar, Response, RichText, Ui};

use crate::desk::AppState;
use crate::layout::Pane;

/// Draws a panel.
pub(crate) fn panel_ui(ui: &mut Ui, pane: Pane, desk: &mut AppState) {
    match pane {
        Pane::Overview => overview::overview_ui(ui, desk),
        Pane::Mechanism => mechanism::mechanism_ui(ui, desk),
        Pane::Scope(number) => scope::scope_ui(ui, number, desk),
        Pane::Phase => phase::phase_ui(ui, desk),
        Pane::Tuning => tuning::tuning_ui(ui, desk),
        Pane::Instruments => instruments::instruments_ui(ui, desk),
        Pane::Deadlines => deadlines::deadlines_ui(ui, desk),
        Pane::Links => links::links_ui(ui, desk),
        Pane::Midi => midi::midi_ui(ui, desk),
        Pane::Faults => faults::faults_ui(ui, desk),
        Pane::Timeline => timeline::timeline_ui(ui, desk),
        Pane::Keyboard => keyboard::keyboard_ui(ui, desk),
        Pane::Log => log::log_ui(ui, desk),
    }
}

/// What stands where there is nothing to show yet, and what to do about it.
fn nothing_ui(ui: &mut Ui, text: &str) {
    ui.centered_and_justified(|ui| ui.weak(text));
}

/// A few words that stay together: where a row has no room for them, they begin the next one.
fn piece_ui(ui: &mut Ui, text: RichText) -> Response {
    ui.add(Label::new(text).extend())
}

/// A share of a whole as a bar, with its number beside: on the bar it would not be read on light
/// ground. One that is no number is not known.
fn share_ui(ui: &mut Ui, share: f64, color: Color32) {
    if !share.is_finite() {
        ui.weak("–").on_hover_text("not known: nothing tells how much it can carry");
        return;
    }
    let part = crate::number::f32(share.clamp(0.0, 1.0));
    ui.horizontal(|ui| {
        ui.add(ProgressBar::new(part).desired_width(80.0).desired_height(12.0).fill(color));
        ui.label(format!("{:.1} %", share * 100.0));
    });
}
