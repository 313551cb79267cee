use eframe::egui::{ComboBox, DragValue, Grid, Ui};

use super::compare;
use crate::app_state::AppState;
use crate::scope::Scope;
use crate::scope::trigger::{Edge, On, Sweep, Trigger};
use crate::store::Store;
use crate::{names, unit};

pub(super) fn controls_ui(ui: &mut Ui, scope: &mut Scope, state: &mut AppState, key: u8, now: f64) {
    ui.horizontal_wrapped(|ui| {
        let mut stays = scope.key.is_some();
        if ui.checkbox(&mut stays, names::name(key)).on_hover_text("Stays with this key.").clicked()
        {
            scope.key = stays.then_some(key);
        }
        let window =
            DragValue::new(&mut scope.window).speed(0.01).range(0.002..=600.0).suffix(" s");
        ui.add(window).on_hover_text("How much time is seen.").accessible_name("window");
        let mut follows = scope.follows() && state.view.frozen.is_none();
        if ui.toggle_value(&mut follows, "Follow").clicked() {
            scope.pinned = if follows { None } else { Some(now) };
            state.view.frozen = state.view.frozen.filter(|_| !follows);
        }
        ComboBox::from_id_salt("trigger")
            .width(92.0)
            .selected_text(scope.trigger.on.text())
            .show_ui(ui, |ui| {
                for on in On::ALL {
                    ui.selectable_value(&mut scope.trigger.on, on, on.text());
                }
            })
            .response
            .accessible_name("trigger");
        if ui.toggle_value(&mut scope.has_cursors, "Cursors").clicked() {
            scope.place_cursors(now);
        }
        ui.menu_button("Channels", |ui| channels_ui(ui, scope, &state.store, key));
        compare::compare_ui(ui, scope, state);
        fit_ui(ui, scope);
        if ui.button("Pop out").clicked() {
            scope.is_popped = true;
        }
    });
}

/// Draws the button that shows all values again, if there was a zoom.
fn fit_ui(ui: &mut Ui, scope: &mut Scope) {
    let is_wanted = scope.heights.is_chosen();
    let text = "All plots show all values again.";
    if is_wanted && ui.button("Fit y").on_hover_text(text).clicked() {
        scope.heights.fit_all();
    }
}

fn channels_ui(ui: &mut Ui, scope: &mut Scope, store: &Store, key: u8) {
    let shown = scope.channels(store, key);
    Grid::new("channels").striped(true).show(ui, |ui| {
        for (name, unit) in store.channels(key) {
            ui.label(unit::named(&name, &unit));
            let clicked = (0..=shown.len()).filter(|lane| channel_ui(ui, *lane, &name, &shown));
            for lane in clicked.collect::<Vec<_>>() {
                scope.toggle(store, key, lane, &name);
            }
            ui.end_row();
        }
    });
    if ui.button("As usual").clicked() {
        scope.lanes.clear();
        scope.heights.fit_all();
    }
}

/// Draws the channel's box in a plot; returns `true` if it was toggled.
fn channel_ui(ui: &mut Ui, lane: usize, name: &str, shown: &[Vec<String>]) -> bool {
    let mut is_shown = shown.get(lane).is_some_and(|it| it.iter().any(|it| it == name));
    let check = ui.checkbox(&mut is_shown, "");
    check.accessible_name(format!("{name} in plot {}", lane + 1)).clicked()
}

pub(super) fn trigger_ui(ui: &mut Ui, scope: &mut Scope, store: &Store, key: u8) {
    ui.horizontal_wrapped(|ui| {
        let trigger = &mut scope.trigger;
        for sweep in Sweep::ALL {
            ui.selectable_value(&mut trigger.sweep, sweep, sweep.text());
        }
        if trigger.on == On::Level {
            level_ui(ui, trigger, store, key);
        }
        let hold_off = DragValue::new(&mut trigger.hold_off).speed(0.01).range(0.0..=60.0);
        ui.add(hold_off.prefix("hold-off ").suffix(" s")).accessible_name("hold-off");
        let before = DragValue::new(&mut trigger.before).speed(0.01).range(0.0..=1.0);
        ui.add(before.prefix("before ")).accessible_name("share before the trigger");
        if ui.button("Arm").clicked() {
            scope.armed.rearm();
        }
        let fired = scope.armed.fired();
        ui.weak(fired.map_or("waiting".to_owned(), |at| format!("at {at:.4} s")));
    });
}

fn level_ui(ui: &mut Ui, trigger: &mut Trigger, store: &Store, key: u8) {
    let combo = ComboBox::from_id_salt("channel").width(80.0).selected_text(&trigger.channel);
    let combo = combo.show_ui(ui, |ui| {
        for (name, _) in store.channels(key) {
            let text = name.clone();
            ui.selectable_value(&mut trigger.channel, name, text);
        }
    });
    combo.response.accessible_name("trigger channel");
    let unit = store.channel(key, &trigger.channel).map_or("", |(_, unit)| unit);
    let (factor, unit) = unit::shown(unit).map_or((1.0, unit), |it| (it.factor, it.unit));
    let mut level = trigger.level * factor;
    let drag = DragValue::new(&mut level).speed(0.02).suffix(unit::suffix(unit));
    if ui.add(drag).accessible_name("level").changed() {
        trigger.level = level / factor;
    }
    ui.selectable_value(&mut trigger.edge, Edge::Rising, "rising");
    ui.selectable_value(&mut trigger.edge, Edge::Falling, "falling");
}
