//! A scene as a file, to be copied or written.

use std::{fs::File, io::Write as _, path::Path};

use eframe::egui::{Button, Context, Key, ScrollArea, TextEdit, Ui, Window};

use crate::app_state::AppState;

/// Draws the window of a scene, to copy it, or to write it to `path`.
pub(super) fn file_ui(ctx: &Context, path: &mut String, state: &mut AppState) {
    let Some(mut text) = state.view.scene.take() else { return };
    let mut is_open = !ctx.input(|input| input.key_pressed(Key::Escape));
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

/// Draws the path for `text`; an existing file is replaced only by a button that says so.
fn write_ui(ui: &mut Ui, path: &mut String, state: &mut AppState, text: &str) {
    let label = ui.label("to");
    let edit = TextEdit::singleline(path).desired_width(220.0);
    let edit = ui.add(edit.hint_text("mine.toml")).labelled_by(label.id);
    let path = Path::new(path.trim());
    let full = std::path::absolute(path).unwrap_or_default();
    edit.on_hover_text(format!("{} on this machine", full.display()));
    let label = if path.is_file() { "Replace" } else { "Write" };
    if ui.add_enabled(path.file_name().is_some(), Button::new(label)).clicked() {
        let file = if path.is_file() { File::create(path) } else { File::create_new(path) };
        let written = file.and_then(|mut file| file.write_all(text.as_bytes()));
        let full = full.display();
        state.notify(match written {
            Ok(()) => Ok(format!("The scene is written to {full}.")),
            Err(why) => Err(format!("{full} cannot be written: {why}.")),
        });
    }
    if ui.button("Copy").clicked() {
        ui.ctx().copy_text(text.to_owned());
    }
}
