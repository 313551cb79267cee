//! Further keys in the same plots.

use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{Key, PopupCloseBehavior, TextEdit, Ui};

use crate::{app_state::AppState, names, scope::Scope, theme};

pub(super) fn compare_ui(ui: &mut Ui, scope: &mut Scope, state: &AppState) {
    // The menu stays open, so that one can add several keys in turn.
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let menu = MenuButton::new("Compare").config(config);
    let (button, _) = menu.ui(ui, |ui| {
        typed_ui(ui, scope);
        if ui.button(format!("Add {}", names::range_name(&state.range()))).clicked() {
            scope.compare(state.range());
        }
        for key in scope.compared.clone() {
            if ui.button(format!("Remove {}", names::name(key))).clicked() {
                scope.compared.remove(&key);
            }
        }
    });
    button.on_hover_text("Further keys in the same plots.");
}

fn typed_ui(ui: &mut Ui, scope: &mut Scope) {
    let is_entered = ui
        .horizontal(|ui| {
            let label = ui.label("with");
            let edit = TextEdit::singleline(&mut scope.typed).desired_width(120.0);
            let edit = ui.add(edit.hint_text("E4, G4..B4")).labelled_by(label.id);
            edit.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter))
        })
        .inner;
    let keys = keys(&scope.typed);
    if keys.is_none() {
        ui.colored_label(theme::fault(ui), "write E4 or E4, G4..B4");
    }
    if is_entered && let Some(keys) = keys {
        scope.compare(keys);
        scope.typed.clear();
    }
}

fn keys(text: &str) -> Option<Vec<u8>> {
    let words = text.split([',', ' ']).filter(|word| !word.is_empty());
    let ranges: Option<Vec<_>> = words.map(names::range).collect();
    ranges.map(|ranges| ranges.into_iter().flatten().collect())
}
