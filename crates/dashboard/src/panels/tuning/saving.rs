//! Saves the instrument of the selected key with its changes, on the host.

use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{Button, PopupCloseBehavior, TextEdit, TextWrapMode, Ui};
use telemetry::stream::Role;

use crate::app_state::AppState;

/// Draws the button that opens the name of the instrument to save, and `typed`, that name.
pub(super) fn saving_ui(ui: &mut Ui, typed: &mut Option<String>, state: &mut AppState, key: u8) {
    let base = state.tuner.played(key).map_or("", |(_, instrument)| instrument).to_owned();
    let can_save = !base.is_empty() && state.may(Role::Owner);
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    ui.add_enabled_ui(can_save, |ui| {
        let button = Button::new("Save instrument").wrap_mode(TextWrapMode::Extend);
        let menu = MenuButton::from_button(button).config(config);
        let (button, _) = menu.ui(ui, |ui| name_ui(ui, typed, state, (key, &base)));
        let hint = "Saves the instrument of the selected key with the changes of all its keys.";
        let none = "Only an owner saves; keys with values of their own are saved with the scene.";
        button.on_hover_text(hint).on_disabled_hover_text(none);
    });
}

fn name_ui(ui: &mut Ui, typed: &mut Option<String>, state: &mut AppState, (key, base): (u8, &str)) {
    let instruments = state.store.catalogue.iter().flat_map(|it| &it.instruments);
    let own: Vec<_> = instruments.filter(|it| it.is_own).map(|it| it.name.clone()).collect();
    let is_own = |name: &str| own.iter().any(|own| own == name);
    let usual = if is_own(base) { base.to_owned() } else { format!("{base}-tuned") };
    let mut name = typed.clone().unwrap_or(usual);
    ui.horizontal(|ui| {
        let label = ui.label("as");
        let edit = ui.add(TextEdit::singleline(&mut name).desired_width(180.0));
        if edit.labelled_by(label.id).changed() {
            *typed = Some(name.clone());
        }
        // A saved instrument is replaced only by a button that says so.
        let overwrite = is_own(name.trim());
        let text = if overwrite { format!("Replace {}", name.trim()) } else { "Save".to_owned() };
        let save = ui.add_enabled(!name.trim().is_empty(), Button::new(text));
        if save.clicked()
            && let Some(request) = state.tuner.saving(key, name.trim(), &own)
        {
            state.ask(request);
            *typed = None;
            ui.close();
        }
    });
}
