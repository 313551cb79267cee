//! Sliders for every parameter of the selected keys.

use std::fs::File;
use std::io::Write as _;
use std::ops::RangeInclusive;

use eframe::egui::{
    Button, ComboBox, Context, DragValue, RichText, ScrollArea, Slider, SliderClamping, TextEdit,
    Ui, Window,
};
use serde::{Deserialize, Serialize};
use telemetry::{Parameter, Request};

use super::nothing_ui;
use crate::desk::Desk;
use crate::tune::link::Link;
use crate::tune::preset::Preset;
use crate::tune::snapshot::Slot;
use crate::{look, names, unit};

/// Parameters over more decades than this move on a logarithm.
const DECADES: f64 = 30.0;

/// What the panel remembers.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct View {
    /// What the other keys of the range do.
    pub(crate) link: Link,
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
pub(super) fn tuning_ui(ui: &mut Ui, desk: &mut Desk) {
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
            parameter_ui(ui, desk, key, parameter);
        }
        ui.separator();
        snapshots_ui(ui, desk);
    });
}

/// Which keys, what the others do, back and forth.
fn head_ui(ui: &mut Ui, desk: &mut Desk, key: u8) {
    ui.horizontal_wrapped(|ui| {
        ui.strong(desk.title(key));
        let link = &mut desk.views.tuning.link;
        let combo = ComboBox::from_id_salt("link").width(88.0).selected_text(link.text());
        let combo = combo.show_ui(ui, |ui| {
            for other in Link::ALL {
                ui.selectable_value(link, other, other.text());
            }
        });
        combo.response.accessible_name("link").on_hover_text("What the other selected keys do.");
        if desk.views.tuning.link != Link::Alone {
            ui.label(names::range_name(&desk.range()));
            if ui.small_button("All keys").clicked() {
                desk.views.range = (0, names::LAST);
            }
        }
    });
    ui.horizontal_wrapped(|ui| {
        let history = desk.tuner.history();
        let (last, next) =
            (history.last().map(|it| it.text.clone()), history.next().map(|it| it.text.clone()));
        let undo = ui.add_enabled(last.is_some(), Button::new("Undo"));
        if undo.on_hover_text(last.unwrap_or_default()).clicked() {
            desk.tuner.undo();
        }
        let redo = ui.add_enabled(next.is_some(), Button::new("Redo"));
        if redo.on_hover_text(next.unwrap_or_default()).clicked() {
            desk.tuner.redo();
        }
        if ui.button("Save scene").clicked() {
            desk.ask(Request::Scene {});
        }
        if ui.button("Save preset").clicked() {
            desk.views.scene = preset(desk, key);
        }
    });
    if let Some(refusal) = desk.tuner.refusal() {
        ui.colored_label(look::fault(ui), refusal);
    }
}

/// A, B, and what lies between.
fn compare_ui(ui: &mut Ui, desk: &mut Desk) {
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
fn gesture(ui: &Ui, desk: &Desk) -> Option<u64> {
    let is_down = ui.input(|input| input.pointer.any_down());
    is_down.then_some(desk.views.tuning.gesture)
}

fn parameter_ui(ui: &mut Ui, desk: &mut Desk, key: u8, parameter: &Parameter) {
    let Some(value) = desk.tuner.value(key, &parameter.name) else { return };
    let usual = usual(desk, key, &parameter.name);
    let is_changed = usual.is_some_and(|it| 1e-9 * it.abs().max(1e-9) < (it - value).abs());
    let is_locked = desk.tuner.is_locked(&parameter.name);
    ui.horizontal(|ui| {
        let mark = if is_changed { look::ORANGE } else { ui.visuals().text_color() };
        let name = RichText::new(&parameter.name).color(mark).strong();
        let (rect, _) =
            ui.allocate_exact_size(eframe::egui::vec2(70.0, 18.0), eframe::egui::Sense::hover());
        let label = eframe::egui::Label::new(name).truncate().halign(eframe::egui::Align::Min);
        ui.put(rect, label).on_hover_text(&parameter.doc);
        let moved = ui
            .add_enabled_ui(!is_locked, |ui| value_ui(ui, parameter, value, usual.unwrap_or(value)))
            .inner;
        let reset = ui.add_enabled(is_changed && !is_locked, Button::new("Reset").small());
        let reset = reset.accessible_name(format!("reset {}", parameter.name));
        let hint = usual.map(|it| unit::text(it, &parameter.unit)).unwrap_or_default();
        let reset = reset.on_hover_text(format!("As the instrument has it: {hint}"));
        let reset = reset.clicked().then_some(()).and(usual);
        if let Some(value) = moved.or(reset) {
            let gesture = gesture(ui, desk);
            let slot = Slot::new(key, &parameter.name);
            let range = desk.range();
            let link = desk.views.tuning.link;
            desk.tuner.edit(&slot, value, (link, &range), gesture);
        }
        lock_ui(ui, desk, &parameter.name);
        if desk.tuner.is_asked(key, &parameter.name) {
            ui.weak("…");
        }
    });
}

/// How many times larger or smaller than usual a slider makes a value.
const REACH: f64 = 8.0;

/// Where a slider goes: what a model can stand is far more than a hand wants, which is near what
/// is usual. Any value of the parameter's own range can be typed.
fn travel(parameter: &Parameter, usual: f64) -> RangeInclusive<f64> {
    let Parameter { min, max, .. } = *parameter;
    if usual == 0.0 || !usual.is_finite() {
        return min.max(-1.0)..=max.min(1.0).max(min);
    }
    let (near, far) = (usual / REACH, usual * REACH);
    // Ratios have their own ends near by.
    let low = if max <= 1.0 && 0.0 <= min { min } else { near.min(far).max(min) };
    low..=near.max(far).min(max)
}

/// The slider, and the value as a number to type.
fn value_ui(ui: &mut Ui, parameter: &Parameter, value: f64, usual: f64) -> Option<f64> {
    let mut value = value;
    let range = parameter.min..=parameter.max;
    let travel = travel(parameter, usual);
    let is_wide = 0.0 < *travel.start() && DECADES < travel.end() / travel.start();
    ui.spacing_mut().slider_width = (ui.available_width() - 208.0).clamp(60.0, 260.0);
    let slider = Slider::new(&mut value, travel.clone()).show_value(false).logarithmic(is_wide);
    // A value that was typed beyond the slider's end stays what it is.
    let slider = slider.clamping(SliderClamping::Edits);
    let slid = ui.add(slider).accessible_name(&parameter.name).changed();
    let speed = (travel.end() - travel.start()) / 500.0;
    let drag = DragValue::new(&mut value).range(range).speed(speed);
    let drag = drag.custom_formatter(|value, _| unit::digits(value)).suffix(suffix(parameter));
    let drag = drag.update_while_editing(false);
    let typed =
        ui.add_sized([86.0, 18.0], drag).accessible_name(format!("{} value", parameter.name));
    (slid || typed.changed()).then_some(value)
}

fn suffix(parameter: &Parameter) -> String {
    if parameter.unit.is_empty() { String::new() } else { format!(" {}", parameter.unit) }
}

fn lock_ui(ui: &mut Ui, desk: &mut Desk, name: &str) {
    let mut locked = desk.tuner.is_locked(name);
    let lock = ui
        .checkbox(&mut locked, RichText::new("lock").small())
        .accessible_name(format!("lock {name}"));
    if lock.on_hover_text("Locked: nothing changes it.").clicked() {
        desk.tuner.toggle_lock(name);
    }
}

/// The instrument's value of a parameter.
fn usual(desk: &Desk, key: u8, name: &str) -> Option<f64> {
    let voice = desk.store.voice(key)?;
    let values = desk.store.instrument_values(&voice.instrument, key)?;
    let i = desk.store.parameters(key).iter().position(|it| it.name == name)?;
    values.get(i).copied()
}

/// Snapshots by their names.
fn snapshots_ui(ui: &mut Ui, desk: &mut Desk) {
    ui.horizontal(|ui| {
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
        ui.horizontal(|ui| {
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

/// The range's values as an instrument's file.
fn preset(desk: &Desk, key: u8) -> Option<String> {
    let model = desk.store.model_of(key)?;
    let title = format!("{}, tuned", desk.store.voice(key)?.instrument);
    let preset = Preset {
        title: &title,
        model: &model.name,
        parameters: &model.parameters,
        range: desk.range(),
    };
    Some(preset.text(|key, name| desk.tuner.value(key, name)))
}

/// A scene or a preset as a file, to be copied or written.
pub(crate) fn scene_ui(ctx: &Context, desk: &mut Desk) {
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
fn write_ui(ui: &mut Ui, desk: &mut Desk, text: &str) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slider_stays_near_what_is_usual() {
        let parameter = |min: f64, max: f64| Parameter { min, max, ..Parameter::default() };
        let is = |(min, max): (f64, f64), usual: f64, wanted: (f64, f64)| {
            let travel = travel(&parameter(min, max), usual);
            let is_near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
            let is_it = is_near(*travel.start(), wanted.0) && is_near(*travel.end(), wanted.1);
            assert!(is_it, "{min}..{max} around {usual}: {travel:?}");
        };
        is((-100.0, 100.0), 0.125, (0.125 / 8.0, 1.0));
        is((-100.0, 100.0), -0.5, (-4.0, -0.0625));
        is((0.0, 10.0), 5.0, (0.625, 10.0));
        is((0.0, 1.0), 0.1, (0.0, 0.8));
        is((-100.0, 100.0), 0.0, (-1.0, 1.0));
    }
}
