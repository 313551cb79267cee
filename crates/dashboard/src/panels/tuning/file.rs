//! A scene or a preset as a file, to be copied or written.

use std::fs::File;
use std::io::Write as _;

use eframe::egui::{Button, Context, ScrollArea, TextEdit, Ui, Window};

use crate::desk::AppState;
use crate::tune::preset::SavedPreset;

/// The range's values as an instrument's file.
pub(super) fn preset(desk: &AppState, key: u8) -> Option<String> {
    let model = desk.store.model_of(key)?;
    let title = format!("{}, tuned", desk.store.voice(key)?.instrument);
    let preset = SavedPreset {
        title: &title,
        model: &model.name,
        parameters: &model.parameters,
        range: desk.range(),
    };
    Some(preset.text(|key, name| desk.tuner.value(key, name)))
}

/// A scene or a preset as a file, to be copied or written.
pub(crate) fn scene_ui(ctx: &Context, desk: &mut AppState) {
    let Some(mut text) = desk.views.scene.clone() else { return };
    let mut is_open = true;
    let window = Window::new("As a file").open(&mut is_open);
    window.default_pos([380.0, 190.0]).default_size([460.0, 360.0]).show(ctx, |ui| {
        ui.horizontal(|ui| write_ui(ui, desk, &text));
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let edit = TextEdit::multiline(&mut text).code_editor().desired_width(f32::INFINITY);
            ui.add(edit).accessible_name("file");
        });
    });
    desk.views.scene = is_open.then_some(text);
}

/// Where it is written to; a file that is there already stays as it is.
fn write_ui(ui: &mut Ui, desk: &mut AppState, text: &str) {
    let label = ui.label("to");
    let path = TextEdit::singleline(&mut desk.views.tuning.file).desired_width(220.0);
    ui.add(path.hint_text("mine.toml")).labelled_by(label.id);
    let path = desk.views.tuning.file.trim().to_owned();
    if ui.add_enabled(!path.is_empty(), Button::new("Write")).clicked() {
        let written = File::create_new(&path).and_then(|mut file| file.write_all(text.as_bytes()));
        desk.views.notice = Some(match written {
            Ok(()) => Ok(format!("{path} is written.")),
            Err(why) => Err(format!("{path} cannot be written: {why}.")),
        });
    }
    if ui.button("Copy").clicked() {
        ui.ctx().copy_text(text.to_owned());
    }
}
