//! Offers the changes of an earlier run of the host to the present one.

use eframe::egui::{Align2, Context, Window};

use crate::{app_state::AppState, tune::edit::Snapshot};

pub(super) fn offer_ui(ctx: &Context, state: &mut AppState) {
    if !state.may_change() {
        return;
    }
    let Some(changes) = state.tuner.offer().map(Snapshot::changes) else { return };
    let plural = if changes == 1 { "change" } else { "changes" };
    let window = Window::new("The host was restarted").collapsible(false).resizable(false);
    window.anchor(Align2::CENTER_TOP, [0.0, 60.0]).show(ctx, |ui| {
        ui.label(format!("Its keys lack {changes} {plural} of the run before."));
        ui.horizontal(|ui| {
            if ui.button("Put back").clicked() {
                state.tuner.put_back();
            }
            if ui.button("Forget").clicked() {
                state.tuner.decline();
            }
        });
    });
}
