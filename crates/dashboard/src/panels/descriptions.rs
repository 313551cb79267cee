//! Descriptions that play: versions, mistakes in their files, and another one to open.

use eframe::egui::{Button, Label, RichText, ScrollArea, TextEdit, Ui};
use serde::{Deserialize, Serialize};
use telemetry::{Catalogue, Description, Request};

use super::nothing_ui;
use crate::{app_state::AppState, names, store::Store, theme};

#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct View {
    #[serde(skip)]
    file: String,
    /// The keys for it as typed; if empty, those that play it.
    #[serde(skip)]
    keys: String,
}

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        let Some(catalogue) = &state.store.catalogue else {
            nothing_ui(ui, state, "The host has not told yet what it has.");
            return;
        };
        let opened = self.open_ui(ui);
        ui.separator();
        let area = ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let store = &state.store;
            let plays = |it: &&Description| 0 < keys_of(it, store);
            let mut newest_first = catalogue.descriptions.iter().rev().filter(plays).peekable();
            if newest_first.peek().is_none() {
                ui.weak("Only models of the program play, and none that a file describes.");
            }
            let asked = newest_first.filter_map(|it| description_ui(ui, it, store, catalogue));
            asked.last()
        });
        if let Some(request) = area.inner.or(opened) {
            state.ask(request);
        }
    }
}

impl View {
    fn open_ui(&mut self, ui: &mut Ui) -> Option<Request> {
        let typed = ui.horizontal_wrapped(|ui| {
            let label = ui.label("file");
            ui.add(TextEdit::singleline(&mut self.file).desired_width(220.0)).labelled_by(label.id);
            let label = ui.label("on keys");
            let hint = TextEdit::singleline(&mut self.keys).hint_text("C4..B5").desired_width(80.0);
            ui.add(hint).labelled_by(label.id);
            let keys = (!self.keys.trim().is_empty()).then(|| names::range(self.keys.trim()));
            if keys.as_ref().is_some_and(Option::is_none) {
                ui.colored_label(theme::fault(ui), "write C4..B5, C4 or all");
            }
            let is_whole = !self.file.trim().is_empty() && keys != Some(None);
            let button = ui.add_enabled(is_whole, Button::new("Open"));
            button.clicked().then(|| keys.flatten().map(|keys| names::range_name(&keys)))
        });
        let description = self.file.trim().to_owned();
        typed.inner.map(|keys| Request::Load { description, keys })
    }
}

fn description_ui(
    ui: &mut Ui,
    it: &Description,
    store: &Store,
    catalogue: &Catalogue,
) -> Option<Request> {
    let path = it.files.first().map_or("", |file| file.path.as_str());
    let clicked = ui.horizontal_wrapped(|ui| {
        ui.strong(&it.model);
        ui.weak(path);
        ui.button("Reload").on_hover_text("reads the file again now").clicked()
    });
    ui.label(standing(it, store, catalogue));
    for base in it.files.iter().skip(1) {
        ui.weak(format!("based on {}", base.path));
    }
    if !it.mistakes.is_empty() {
        let text = "What stands in the file now is wrong, and this version plays on:";
        ui.colored_label(theme::fault(ui), text);
        let id = ("mistakes", it.version);
        ScrollArea::horizontal().id_salt(id).show(ui, |ui| mistakes_ui(ui, &it.mistakes));
    }
    ui.add_space(6.0);
    let description = path.to_owned();
    clicked.inner.then_some(Request::Load { description, keys: None })
}

/// Draws mistakes. Indented lines of the file are not wrapped, so carets stay in position.
fn mistakes_ui(ui: &mut Ui, mistakes: &str) {
    let width = ui.available_width();
    ui.spacing_mut().item_spacing.y = 0.0;
    let lines: Vec<_> = mistakes.lines().collect();
    for paragraph in lines.chunk_by(|a, b| is_of_file(a) == is_of_file(b)) {
        let text = RichText::new(paragraph.join("\n")).monospace();
        if paragraph.first().is_some_and(|line| is_of_file(line)) {
            ui.add(Label::new(text).extend());
        } else {
            ui.scope(|ui| {
                ui.set_max_width(width);
                ui.add(Label::new(text).wrap());
            });
        }
    }
}

/// Returns `true` for a quoted line of the file, or the caret below it.
fn is_of_file(line: &str) -> bool {
    line.starts_with("  ")
}

fn keys_of(it: &Description, store: &Store) -> usize {
    store.voices().filter(|(_key, voice)| voice.version == it.version).count()
}

fn standing(it: &Description, store: &Store, catalogue: &Catalogue) -> String {
    let n = keys_of(it, store);
    let since = match it.since.saturating_sub(catalogue.began) {
        0 => "from the beginning".to_owned(),
        ns => format!("since {:.1} s", ns as f64 * 1e-9),
    };
    let keys = if n == 1 { "1 key".to_owned() } else { format!("{n} keys") };
    let watched = if it.watched { "; its files are watched" } else { "" };
    format!("version {} plays on {keys} {since}{watched}", it.version)
}
