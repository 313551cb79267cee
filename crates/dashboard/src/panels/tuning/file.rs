//! A scene or a preset as a file, to be copied or written.

use std::fs::File;
use std::io::Write as _;

use eframe::egui::{Button, Context, ScrollArea, TextEdit, Ui, Window};

use crate::app_state::AppState;
use crate::tune::preset::SavedPreset;

pub(super) fn preset(state: &AppState, key: u8) -> Option<String> {
    let model = state.store.model_of(key)?;
    let title = format!("{}, tuned", state.store.voice(key)?.instrument);
    let preset = SavedPreset {
        title: &title,
        model: &model.name,
        parameters: &model.parameters,
        range: state.range(),
    };
    Some(preset.text(|key, name| state.tuner.value(key, name)))
}

/// Draws the window of a scene or a preset, to copy it, or to write it to `path`.
pub(super) fn file_ui(ctx: &Context, path: &mut String, state: &mut AppState) {
    let Some(mut text) = state.view.scene.take() else { return };
    let mut is_open = true;
    let window = Window::new("As a file").open(&mut is_open);
    window.default_pos([380.0, 190.0]).default_size([460.0, 360.0]).show(ctx, |ui| {
        ui.horizontal(|ui| write_ui(ui, path, state, &text));
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let edit = TextEdit::multiline(&mut text).code_editor().desired_width(f32::INFINITY);
            ui.add(edit).accessible_name("file");
        });
    });
    state.view.scene = is_open.then_some(text);
}

/// Draws the path for `text`; an existing file is not overwritten.
fn write_ui(ui: &mut Ui, path: &mut String, state: &mut AppState, text: &str) {
    let label = ui.label("to");
    let edit = TextEdit::singleline(path).desired_width(220.0);
    ui.add(edit.hint_text("mine.toml")).labelled_by(label.id);
    let path = path.trim();
    if ui.add_enabled(!path.is_empty(), Button::new("Write")).clicked() {
        let written = File::create_new(path).and_then(|mut file| file.write_all(text.as_bytes()));
        state.view.notice = Some(match written {
            Ok(()) => Ok(format!("{path} is written.")),
            Err(why) => Err(format!("{path} cannot be written: {why}.")),
        });
    }
    if ui.button("Copy").clicked() {
        ui.ctx().copy_text(text.to_owned());
    }
}
