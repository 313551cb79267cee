use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{ComboBox, DragValue, Grid, PopupCloseBehavior, Ui};
use telemetry::signal::Kind;

use super::compare;
use crate::scope::trigger::{Edge, On, Sweep, Trigger};
use crate::{
    app_state::AppState, names, panels::scrolled_ui, scope::Scope, store::Store, store::trace::OWN,
    unit,
};

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
        // The menu stays open, so that one can choose several channels in turn.
        let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        let menu = MenuButton::new("Channels").config(config);
        menu.ui(ui, |ui| channels_ui(ui, scope, &state.store, key));
        compare::compare_ui(ui, scope, state);
        fit_ui(ui, scope);
        if ui.button("Pop out").clicked() {
            scope.is_popped = true;
        }
    });
}

fn fit_ui(ui: &mut Ui, scope: &mut Scope) {
    let is_wanted = scope.heights.is_chosen();
    let text = "All plots show all values again.";
    if is_wanted && ui.button("Fit y").on_hover_text(text).clicked() {
        scope.heights.fit_all();
    }
}

fn channels_ui(ui: &mut Ui, scope: &mut Scope, store: &Store, key: u8) {
    let shown = scope.channels(store, key);
    if ui.button("As usual").on_hover_text("Force and guards above, travel below.").clicked() {
        scope.lanes.clear();
        scope.heights.fit_all();
    }
    let grid = Grid::new("channels").striped(true);
    scrolled_ui(ui, |ui| {
        grid.show(ui, |ui| {
            ui.weak("channel");
            for lane in 1..=shown.len() {
                ui.weak(format!("plot {lane}"));
            }
            ui.weak("new plot");
            ui.end_row();
            for (i, (name, unit)) in store.channels(key).into_iter().enumerate() {
                ui.label(unit::named(&name, &unit));
                let clicked = (0..=shown.len()).filter(|lane| channel_ui(ui, *lane, &name, &shown));
                let clicked: Vec<_> = clicked.collect();
                for lane in clicked {
                    scope.toggle(store, key, lane, &name);
                }
                ui.weak(meaning(store, key, i));
                ui.end_row();
            }
        });
    });
}

/// Returns words for the channel `i` of a key, counted from the first of [`OWN`].
fn meaning(store: &Store, key: u8, i: usize) -> String {
    let own = ["travel of the key's front", "its speed", "force of the model", "force sent"];
    let signal = i.checked_sub(OWN.len()).and_then(|i| store.signals(key).get(i));
    let Some(signal) = signal else { return own.get(i).copied().unwrap_or_default().to_owned() };
    let modes = signal.modes.iter().filter_map(|mode| u8::try_from(*mode).ok()).take(3);
    let modes: Vec<_> = modes.map(|mode| store.mode_name(key, mode)).collect();
    match signal.kind() {
        Kind::State => "state".to_owned(),
        Kind::Output => "output".to_owned(),
        Kind::Guard => format!("guard {}", modes.join(", ")),
    }
}

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
