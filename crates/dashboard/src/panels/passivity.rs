//! Energy that a key takes and returns, and the settings between the key and its model.
//!
//! It is computed from the sent forces, each held until the next: as an observer at the key counts,
//! but without its leak.

use std::collections::BTreeMap;

use eframe::egui::{Button, DragValue, Grid, ScrollArea, TextEdit, TextStyle, Ui};
use egui_plot::{Corner, HLine, Legend, Line, Plot, PlotPoints};
use serde::{Deserialize, Serialize};
use telemetry::{Request, request::RenderSetting};

use super::nothing_ui;
use crate::{app_state::AppState, store::Store, theme, unit};

/// Travel of a key from rest to bottom (m), over which its largest force may return energy.
const DIP: f64 = 10e-3;

/// Faults of a key that generates energy, and of a muted one, as in `KeyBlock.fault`.
const MADE: std::ops::RangeInclusive<u8> = 6..=7;

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct View {
    /// Length of the time shown (s).
    window: f64,
    #[serde(skip)]
    typed: BTreeMap<String, String>,
}

impl Default for View {
    fn default() -> Self {
        Self { window: 4.0, typed: BTreeMap::new() }
    }
}

/// Energies of a key over the time shown, each with the times (s).
#[derive(Clone, PartialEq, Debug, Default)]
struct KeyEnergy {
    /// Energy from the finger (mJ).
    taken: Vec<[f64; 2]>,
    /// Energy returned to the finger (mJ).
    given: Vec<[f64; 2]>,
    /// Largest fall of the difference below its highest value (mJ).
    returned: f64,
}

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        let key = state.view.selected;
        state.want(key);
        let now = state.now();
        let energy = gather(&state.store, key, (now - self.window, now));
        let limit = state.store.catalogue.as_ref().map_or(0.0, |it| it.force_limit);
        let bound = limit * DIP * 1e3;
        let fault = state.store.summaries.key(key).fault;
        ui.horizontal_wrapped(|ui| {
            ui.strong(state.title(key));
            let drag = DragValue::new(&mut self.window).speed(0.05).range(0.1..=120.0);
            ui.add(drag.suffix(" s"))
                .on_hover_text("How much time is seen.")
                .accessible_name("seconds of energy");
            lamp_ui(ui, fault, &energy, bound);
            if ui
                .button("Margin")
                .on_hover_text("Tries how many times its force this key may have, beside the run.")
                .clicked()
            {
                state.ask(Request::Margin { key });
            }
        });
        ui.columns(2, |columns| {
            let [left, right] = columns else { return };
            self.settings_ui(left, state);
            if energy.taken.is_empty() {
                nothing_ui(right, state, "Press the key: what it takes and gives back is drawn.");
            } else {
                plot_ui(right, energy, bound);
            }
        });
    }
}

impl View {
    fn settings_ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        let scene = state.store.catalogue.as_ref().map_or("", |it| it.scene_text.as_str());
        let settings = settings(scene);
        self.typed.retain(|name, value| {
            settings.iter().any(|(known, now)| known == name && now != value)
        });
        let is_typed = !self.typed.is_empty();
        if ui
            .add_enabled(is_typed, Button::new("Change for all keys"))
            .on_hover_text("All of them or none: what is wrong or not stable is refused.")
            .clicked()
        {
            let typed = std::mem::take(&mut self.typed).into_iter();
            let setting = |(name, value)| RenderSetting { name: format!("render.{name}"), value };
            state.ask(Request::Render { settings: typed.map(setting).collect() });
        }
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            Grid::new("settings").num_columns(2).striped(true).show(ui, |ui| {
                for (name, now) in settings {
                    self.setting_ui(ui, name, now);
                }
            });
        });
    }

    fn setting_ui(&mut self, ui: &mut Ui, name: String, now: String) {
        let mut text = self.typed.get(&name).cloned().unwrap_or(now);
        let label = ui.label(&name);
        let edit = TextEdit::singleline(&mut text).desired_width(130.0);
        if ui.add(edit).labelled_by(label.id).changed() {
            self.typed.insert(name, text);
        }
        ui.end_row();
    }
}

/// Returns the settings in the table `render` of `scene`, as written.
fn settings(scene: &str) -> Vec<(String, String)> {
    let lines = scene.lines().skip_while(|line| line.trim() != "[render]").skip(1);
    let lines = lines.take_while(|line| !line.starts_with('['));
    lines
        .filter_map(|line| line.split_once('='))
        .map(|(name, value)| (name.trim(), value.trim().trim_matches('"')))
        .filter(|(name, _)| !matches!(*name, "force_limit" | "slew_limit"))
        .map(|(name, value)| (name.to_owned(), short(value)))
        .collect()
}

/// Writes a number with many zeros by its exponent, so that a field shows all of its digits.
fn short(value: &str) -> String {
    let small = value.parse::<f64>().ok().filter(|it| 0.0 < it.abs() && it.abs() < 1e-3);
    small.map_or_else(|| value.to_owned(), |it| format!("{it:e}"))
}

fn lamp_ui(ui: &mut Ui, fault: u8, energy: &KeyEnergy, bound: f64) {
    let (color, text, hint) = if MADE.contains(&fault) {
        (theme::fault(ui), "muted", "It gave back more than any action stores.")
    } else if 0.5 * bound < energy.returned {
        (theme::VERMILLION, "gives back", "It gave back more than half of what mutes it.")
    } else {
        (theme::mode(2), "passive", "It gave back less than any action stores.")
    };
    ui.colored_label(color, text).on_hover_text(hint);
    ui.label(format!("gave back {} of {} mJ", unit::digits(energy.returned), unit::digits(bound)))
        .on_hover_text("The most that it gave back beyond what was put in, and what mutes it.");
}

fn plot_ui(ui: &mut Ui, energy: KeyEnergy, bound: f64) {
    let plot = Plot::new("passivity")
        .grid_color(theme::grid(ui))
        .x_grid_spacer(theme::spacer_across(ui.available_width()))
        .y_grid_spacer(theme::spacer_up(ui.available_height()))
        .legend(Legend::default().text_style(TextStyle::Small).position(Corner::LeftTop))
        .x_axis_label("time [s]")
        .y_axis_label("energy [mJ]")
        .y_axis_formatter(|mark, _| unit::digits(mark.value))
        .x_axis_formatter(|mark, _| unit::digits(mark.value))
        .include_y(0.0);
    let colors = [theme::line(0, ui), theme::line(1, ui)];
    let highest = energy.given.last().map_or(0.0, |[_, given]| *given);
    plot.show(ui, move |plot| {
        for ((name, points), color) in
            [("put in", energy.taken), ("given back", energy.given)].into_iter().zip(colors)
        {
            plot.line(Line::new(name, PlotPoints::new(points)).color(color).width(1.4));
        }
        // A distant bound would make the lines flat.
        if 0.2 * bound < highest {
            plot.hline(HLine::new("muted at", bound).color(theme::VERMILLION));
        }
    });
}

fn gather(store: &Store, key: u8, view: (f64, f64)) -> KeyEnergy {
    let mut energy = KeyEnergy::default();
    let Some(trace) = store.trace(key) else { return energy };
    let first = trace.row_at(store.tick(view.0.max(0.0))).unwrap_or(0);
    let last = trace.row_at(store.tick(view.1)).map_or(0, |row| row + 1);
    let rows = |column: usize| trace.values(column).get(first..last).unwrap_or(&[]);
    let ticks = trace.ticks().get(first..last).unwrap_or(&[]);
    let (positions, forces) = (rows(0), rows(3));
    let (mut sums, mut highest) = ([0.0_f64; 2], 0.0_f64);
    for (row, tick) in ticks.iter().enumerate().skip(1) {
        let way = f64::from(positions[row]) - f64::from(positions[row - 1]);
        // Up is positive for forces, down for positions: work on the voice.
        let supplied = f64::from(forces[row - 1]) * way * 1e3;
        if supplied.is_finite() {
            sums[usize::from(supplied < 0.0)] += supplied.abs();
        }
        highest = highest.max(sums[0] - sums[1]);
        energy.returned = energy.returned.max(highest - (sums[0] - sums[1]));
        let at = store.seconds(*tick);
        energy.taken.push([at, sums[0]]);
        energy.given.push([at, sums[1]]);
    }
    energy
}

#[cfg(test)]
mod tests {
    use telemetry::{KeyBlock, Update};

    use super::*;

    #[test]
    fn a_spring_gives_back_what_it_took_and_what_it_takes_late() {
        // 1000 N/m over 5 mm, 100 ticks down and 100 up, each force held for a tick.
        let position = |tick: u32| 5e-5 * (100.0 - (f64::from(tick) - 100.0).abs());
        let positions: Vec<f64> = (0..=200).map(position).collect();
        let forces: Vec<f64> = positions.iter().map(|x| 1e3 * x).collect();
        let block = KeyBlock {
            key: 39,
            after: (0..=200).collect(),
            sent: forces.clone(),
            force: forces,
            mode: vec![0; 201],
            flags: vec![0; 201],
            fault: vec![0; 201],
            revision: vec![1; 201],
            position: positions,
            ..KeyBlock::default()
        };
        let mut store = Store::default();
        store.take(0, Update::Block(block));
        let energy = gather(&store, 39, (0.0, 10.0));
        let last = |points: &[[f64; 2]]| points.last().map_or(f64::NAN, |it| it[1]);
        // K A^2 / 2 (1 -+ 1 / n), of positions that are known to seven digits.
        assert!((last(&energy.taken) - 12.375).abs() < 1e-3, "{:?}", last(&energy.taken));
        assert!((last(&energy.given) - 12.625).abs() < 1e-3, "{:?}", last(&energy.given));
        assert!((energy.returned - 12.625).abs() < 1e-3, "{}", energy.returned);
    }

    #[test]
    fn settings_are_those_of_the_scene_that_change() {
        let scene = "tick_hz = 1000\n\n[render]\nlead = 0.0\npassivity = \"observe\"\n\
                     event_tolerance = 0.000000000000909\n\
                     slew_limit = 2e4\n\n[rig]\nkind = \"x\"\n";
        let wanted = [("lead", "0.0"), ("passivity", "observe"), ("event_tolerance", "9.09e-13")];
        assert_eq!(settings(scene), wanted.map(|(name, now)| (name.to_owned(), now.to_owned())));
        assert!(settings("title = 1\n").is_empty());
    }
}
