//! A scope: plots over time, with epochs shaded by mode and switches as lines, as in figure 6.

mod axis;
mod compare;
mod controls;
mod cursors;
mod data;
mod lanes;
mod mouse;

use eframe::egui::{CentralPanel, Context, Ui, ViewportBuilder, ViewportId};

use super::{Pane, nothing_ui};
use crate::{app_state::AppState, scope::trigger::On};

/// Draws the panel; its window instead, if it is popped out.
pub(super) fn scope_ui(ui: &mut Ui, number: u8, state: &mut AppState) {
    let is_popped = state.view.scopes.entry(number).or_default().is_popped;
    if is_popped {
        ui.vertical_centered(|ui| {
            ui.add_space(20.0);
            ui.weak("This scope is a window of its own.");
            if ui.button("Put it back").clicked()
                && let Some(scope) = state.view.scopes.get_mut(&number)
            {
                scope.is_popped = false;
            }
        });
        return;
    }
    body_ui(ui, number, state);
}

pub(crate) fn popped_ui(ctx: &Context, state: &mut AppState) {
    let popped = state.view.scopes.iter().filter(|(_, scope)| scope.is_popped);
    for number in popped.map(|(number, _)| *number).collect::<Vec<_>>() {
        let builder = ViewportBuilder::default()
            .with_title(Pane::Scope(number).title())
            .with_inner_size([900.0, 600.0]);
        let id = ViewportId::from_hash_of(("scope", number));
        ctx.show_viewport_immediate(id, builder, |ui, _class| {
            CentralPanel::default().show(ui, |ui| body_ui(ui, number, state));
            if ui.ctx().input(|input| input.viewport().close_requested())
                && let Some(scope) = state.view.scopes.get_mut(&number)
            {
                scope.is_popped = false;
            }
        });
    }
}

fn body_ui(ui: &mut Ui, number: u8, state: &mut AppState) {
    let mut scope = state.view.scopes.remove(&number).unwrap_or_default();
    let key = scope.key.unwrap_or(state.view.selected);
    let keys = scope.keys(key);
    for key in &keys {
        state.want(*key);
    }
    let now = state.now();
    controls::controls_ui(ui, &mut scope, state, key, now);
    if scope.trigger.on != On::Nothing {
        controls::trigger_ui(ui, &mut scope, &state.store, key);
    }
    let has_rows = |key: &u8| state.store.trace(*key).is_some_and(|it| !it.ticks().is_empty());
    if keys.iter().any(has_rows) {
        lanes::lanes_ui(ui, &mut scope, &state.store, &keys, now);
    } else {
        nothing_ui(ui, state, "Nothing has moved this key since it is looked at.");
    }
    state.view.scopes.insert(number, scope);
}
