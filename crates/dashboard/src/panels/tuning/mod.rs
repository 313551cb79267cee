//! Sliders for every parameter of the selected keys, steps back and forth, and snapshots.

mod checked;
mod file;
mod offer;
mod parameter;
mod saving;
mod steps;

use eframe::egui::{
    Button, ComboBox, Context, DragValue, InputState, RichText, ScrollArea, Slider, TextEdit, Ui,
};
use serde::{Deserialize, Serialize};
use telemetry::{Parameter, Request};

use super::nothing_ui;
use crate::tune::link::{FollowingKeys, LinkedKeys};
use crate::{app_state::AppState, names, tune::Tuner};

/// Width of the slider between A and B with its name (points).
const MORPH: f32 = 150.0;

/// Number of parameters above which a search by name is offered.
const MANY: usize = 20;

#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct View {
    link: LinkedKeys,
    /// Number of keys beside the range over which a change fades.
    fade: u8,
    name: String,
    #[serde(skip)]
    instrument: Option<String>,
    #[serde(skip)]
    find: String,
    file: String,
    /// Position between A (0) and B (1).
    morph: f64,
    /// Counts presses of the mouse: the changes of one are undone as one.
    #[serde(skip)]
    gesture: u64,
}

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        if ui.input(|input| input.pointer.any_pressed()) {
            self.gesture += 1;
        }
        state.tuner.checks.is_held = ui.input(|input| input.pointer.any_down());
        if !state.may_change() {
            ui.disable();
        }
        let key = state.view.selected;
        self.head_ui(ui, state, key);
        self.compare_ui(ui, &mut state.tuner);
        if MANY < state.store.parameters(key).len() {
            let find = TextEdit::singleline(&mut self.find).hint_text("find a parameter");
            ui.add(find.desired_width(160.0));
        }
        ui.separator();
        if state.store.parameters(key).is_empty() {
            nothing_ui(ui, state, "Nothing of this key can be changed.");
            return;
        }
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            self.parameters_ui(ui, state, key);
            ui.separator();
            self.snapshots_ui(ui, &mut state.tuner);
        });
    }
}

impl View {
    fn head_ui(&mut self, ui: &mut Ui, state: &mut AppState, key: u8) {
        ui.horizontal_wrapped(|ui| {
            ui.strong(state.title(key));
            let combo = ComboBox::from_id_salt("link").width(88.0).selected_text(self.link.text());
            let combo = combo.show_ui(ui, |ui| {
                for other in LinkedKeys::ALL {
                    ui.selectable_value(&mut self.link, other, other.text());
                }
            });
            let combo = combo.response.accessible_name("link");
            combo.on_hover_text("What the other selected keys do.");
            if self.link != LinkedKeys::Alone {
                ui.label(names::range_name(&state.range()));
                if ui.small_button("All keys").clicked() {
                    state.view.range = (0, names::LAST);
                }
                if self.link == LinkedKeys::Change {
                    let fade = ui.add(DragValue::new(&mut self.fade).range(0..=24).prefix("fade "));
                    fade.on_hover_text("Keys beside the range over which the change fades.");
                }
            }
        });
        ui.horizontal_wrapped(|ui| {
            steps::steps_ui(ui, state);
            if ui.button("Save scene").clicked() {
                state.ask(Request::Scene {});
            }
            saving::saving_ui(ui, &mut self.instrument, state, key);
        });
        checked::checked_ui(ui, &state.tuner);
    }

    fn compare_ui(&mut self, ui: &mut Ui, tuner: &mut Tuner) {
        let present = tuner.snapshot();
        ui.horizontal_wrapped(|ui| {
            for (i, name) in ["A", "B"].into_iter().enumerate() {
                if ui.small_button(format!("Store {name}")).clicked() {
                    tuner.kept.compared[i] = Some(present.clone());
                }
                let is_kept = tuner.kept.compared[i].is_some();
                let is_present = tuner.kept.compared[i].as_ref() == Some(&present);
                let button = Button::new(RichText::new(name).strong()).selected(is_present);
                let recall = ui.add_enabled(is_kept, button);
                if recall.clicked()
                    && let Some(kept) = tuner.kept.compared[i].clone()
                {
                    tuner.recall(&kept, name);
                }
            }
            let has_both = tuner.kept.compared.iter().all(Option::is_some);
            let gesture = self.gesture(ui);
            if ui.available_size_before_wrap().x < MORPH {
                ui.end_row();
            }
            ui.add_enabled_ui(has_both, |ui| {
                ui.spacing_mut().slider_width = 90.0;
                let slider = Slider::new(&mut self.morph, 0.0..=1.0);
                if ui.add(slider.show_value(false).text("morph")).changed() {
                    tuner.morph(self.morph, gesture);
                }
            });
        });
    }

    fn parameters_ui(&self, ui: &mut Ui, state: &mut AppState, key: u8) {
        let following = FollowingKeys { link: self.link, range: state.range(), fade: self.fade };
        let AppState { store, tuner, .. } = state;
        let found = self.find.trim().to_lowercase();
        let is_found = |it: &&Parameter| {
            [&it.name, &it.title].iter().any(|text| text.to_lowercase().contains(&found))
        };
        for parameter in store.parameters(key).iter().filter(is_found) {
            let usual = tuner.base(key, &parameter.name);
            let moved = parameter::parameter_ui(ui, tuner, key, (parameter, usual));
            if let Some(value) = moved {
                let slot = (key, parameter.name.as_str());
                tuner.edit(slot, value, &following, self.gesture(ui));
            }
        }
    }

    /// Returns the number of the mouse's press while it lasts, and in the frame of its release,
    /// which may still move a value.
    fn gesture(&self, ui: &Ui) -> Option<u64> {
        let lasts = |input: &InputState| input.pointer.any_down() || input.pointer.any_released();
        ui.input(lasts).then_some(self.gesture)
    }

    fn snapshots_ui(&mut self, ui: &mut Ui, tuner: &mut Tuner) {
        ui.horizontal_wrapped(|ui| {
            let label = ui.label("snapshot");
            let name = TextEdit::singleline(&mut self.name).desired_width(120.0);
            ui.add(name.hint_text("its name")).labelled_by(label.id);
            let name = self.name.trim();
            if ui.add_enabled(!name.is_empty(), Button::new("Keep")).clicked() {
                tuner.kept.named.insert(name.to_owned(), tuner.snapshot());
            }
        });
        let (mut recalled, mut removed) = (None, None);
        for name in tuner.kept.named.keys() {
            ui.horizontal_wrapped(|ui| {
                if ui.button(format!("Recall {name}")).clicked() {
                    recalled = Some(name.clone());
                }
                if ui.small_button(format!("Forget {name}")).clicked() {
                    removed = Some(name.clone());
                }
            });
        }
        if let Some(name) = recalled
            && let Some(snapshot) = tuner.kept.named.get(&name).cloned()
        {
            tuner.recall(&snapshot, &name);
        }
        if let Some(name) = removed {
            tuner.kept.named.remove(&name);
        }
    }

    pub(super) fn file_ui(&mut self, ctx: &Context, state: &mut AppState) {
        file::file_ui(ctx, &mut self.file, state);
        offer::offer_ui(ctx, state);
    }
}
