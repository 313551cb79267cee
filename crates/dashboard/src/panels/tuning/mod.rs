//! Sliders for every parameter of the selected keys.

mod file;
mod parameter;
mod steps;

use eframe::egui::{Button, ComboBox, RichText, ScrollArea, Slider, TextEdit, Ui};
use serde::{Deserialize, Serialize};
use telemetry::Request;

pub(crate) use file::scene_ui;

use super::nothing_ui;
use crate::desk::AppState;
use crate::tune::link::LinkedKeys;
use crate::{look, names};

/// Points that the slider between A and B takes with its name.
const MORPH: f32 = 150.0;

/// What the panel remembers.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct View {
    /// What the other keys of the range do.
    pub(crate) link: LinkedKeys,
    /// Name of the next snapshot.
    name: String,
    /// Where a scene or a preset is written to.
    file: String,
    /// Between A and B.
    morph: f64,
    /// Counts presses of the mouse: what is done in one is taken back as one.
    #[serde(skip)]
    gesture: u64,
}

/// Draws the panel.
pub(super) fn tuning_ui(ui: &mut Ui, desk: &mut AppState) {
    if ui.input(|input| input.pointer.any_pressed()) {
        desk.views.tuning.gesture += 1;
    }
    let key = desk.views.selected;
    head_ui(ui, desk, key);
    compare_ui(ui, desk);
    ui.separator();
    let parameters = desk.store.parameters(key).to_vec();
    if parameters.is_empty() {
        nothing_ui(ui, "Nothing of this key can be changed.");
        return;
    }
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for parameter in &parameters {
            parameter::parameter_ui(ui, desk, key, parameter);
        }
        ui.separator();
        snapshots_ui(ui, desk);
    });
}

/// Which keys, what the others do, back and forth.
fn head_ui(ui: &mut Ui, desk: &mut AppState, key: u8) {
    ui.horizontal_wrapped(|ui| {
        ui.strong(desk.title(key));
        let link = &mut desk.views.tuning.link;
        let combo = ComboBox::from_id_salt("link").width(88.0).selected_text(link.text());
        let combo = combo.show_ui(ui, |ui| {
            for other in LinkedKeys::ALL {
                ui.selectable_value(link, other, other.text());
            }
        });
        combo.response.accessible_name("link").on_hover_text("What the other selected keys do.");
        if desk.views.tuning.link != LinkedKeys::Alone {
            ui.label(names::range_name(&desk.range()));
            if ui.small_button("All keys").clicked() {
                desk.views.range = (0, names::LAST);
            }
        }
    });
    ui.horizontal_wrapped(|ui| {
        steps::steps_ui(ui, desk);
        if ui.button("Save scene").clicked() {
            desk.ask(Request::Scene {});
        }
        if ui.button("Save preset").clicked() {
            desk.views.scene = file::preset(desk, key);
        }
    });
    if let Some(refusal) = desk.tuner.refusal() {
        ui.colored_label(look::fault(ui), refusal);
    }
}

/// A, B, and what lies between.
fn compare_ui(ui: &mut Ui, desk: &mut AppState) {
    ui.horizontal_wrapped(|ui| {
        for (i, name) in ["A", "B"].into_iter().enumerate() {
            if ui.small_button(format!("Store {name}")).clicked() {
                desk.tuner.kept.compared[i] = Some(desk.tuner.snapshot());
            }
            let kept = desk.tuner.kept.compared[i].clone();
            let recall = ui.add_enabled(kept.is_some(), Button::new(RichText::new(name).strong()));
            if recall.clicked()
                && let Some(kept) = kept
            {
                desk.tuner.recall(&kept, name);
            }
        }
        let has_both = desk.tuner.kept.compared.iter().all(Option::is_some);
        let gesture = gesture(ui, desk);
        if ui.available_size_before_wrap().x < MORPH {
            ui.end_row();
        }
        ui.add_enabled_ui(has_both, |ui| {
            ui.spacing_mut().slider_width = 90.0;
            let slider = Slider::new(&mut desk.views.tuning.morph, 0.0..=1.0);
            if ui.add(slider.show_value(false).text("morph")).changed() {
                desk.tuner.morph(desk.views.tuning.morph, gesture);
            }
        });
    });
}

/// What is done while the mouse is down is taken back as one.
fn gesture(ui: &Ui, desk: &AppState) -> Option<u64> {
    let is_down = ui.input(|input| input.pointer.any_down());
    is_down.then_some(desk.views.tuning.gesture)
}

/// Snapshots by their names.
fn snapshots_ui(ui: &mut Ui, desk: &mut AppState) {
    ui.horizontal_wrapped(|ui| {
        let label = ui.label("snapshot");
        let name = TextEdit::singleline(&mut desk.views.tuning.name).desired_width(120.0);
        ui.add(name.hint_text("its name")).labelled_by(label.id);
        let has_name = !desk.views.tuning.name.trim().is_empty();
        if ui.add_enabled(has_name, Button::new("Keep")).clicked() {
            let name = desk.views.tuning.name.trim().to_owned();
            desk.tuner.kept.named.insert(name, desk.tuner.snapshot());
        }
    });
    let names: Vec<String> = desk.tuner.kept.named.keys().cloned().collect();
    for name in names {
        ui.horizontal_wrapped(|ui| {
            if ui.button(format!("Recall {name}")).clicked()
                && let Some(snapshot) = desk.tuner.kept.named.get(&name).cloned()
            {
                desk.tuner.recall(&snapshot, &name);
            }
            if ui.small_button(format!("Forget {name}")).clicked() {
                desk.tuner.kept.named.remove(&name);
            }
        });
    }
}
