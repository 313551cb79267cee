//! Force against travel, the technician's view: the feel of a key going down and coming back.

use std::ops::RangeInclusive;

use eframe::egui::{DragValue, Ui};
use egui_plot::{Line, Plot, PlotPoints, Points};
use serde::{Deserialize, Serialize};

use super::nothing_ui;
use crate::{app_state::AppState, grid, number, store::Store, theme, unit};

/// Travel over which weights are means (m).
const MIDDLE: std::ops::Range<f64> = 2e-3..7e-3;

/// Speed below which a key moves neither down nor up (m/s).
const STILL: f64 = 2e-3;

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct View {
    /// Length of the time shown (s).
    window: f64,
}

impl Default for View {
    fn default() -> Self {
        Self { window: 4.0 }
    }
}

/// Travel (mm) and force (N), down and up.
#[derive(Default)]
struct HysteresisLoop {
    ways: Vec<(usize, Vec<[f64; 2]>)>,
    weights: [(f64, usize); 2],
    last: Option<[f64; 2]>,
    /// `true` if values are missing before the next point.
    is_torn: bool,
}

impl HysteresisLoop {
    fn is_down(&self) -> bool {
        self.ways.last().is_none_or(|(way, _)| *way == 0)
    }

    /// Adds a point of the path down (0) or up (1); lines end at a reversal or a gap.
    fn enter(&mut self, way: usize, point: [f64; 2]) {
        let is_torn = std::mem::take(&mut self.is_torn);
        if let Some((last, points)) = self.ways.last_mut().filter(|_| !is_torn) {
            points.push(point);
            if *last == way {
                return;
            }
        }
        self.ways.push((way, vec![point]));
    }
}

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        let key = state.view.selected;
        state.want(key);
        let now = state.now();
        let shown = gather(&state.store, key, (now - self.window, now));
        ui.horizontal_wrapped(|ui| {
            ui.strong(state.title(key));
            let drag = DragValue::new(&mut self.window).speed(0.05).range(0.1..=120.0);
            ui.add(drag.suffix(" s"))
                .on_hover_text("How much time is seen.")
                .accessible_name("seconds of travel");
            weights_ui(ui, &shown);
        });
        if shown.last.is_none() {
            nothing_ui(ui, state, "Press the key: its force is drawn over its travel.");
            return;
        }
        plot_ui(ui, shown);
    }
}

fn plot_ui(ui: &mut Ui, shown: HysteresisLoop) {
    let size = ui.available_size();
    let (across, up) = (grid::lines_across(size.x), grid::lines_up(size.y));
    let label = |value: f64, range: &RangeInclusive<f64>, lines: f64| {
        grid::label(value, (*range.start(), *range.end()), lines)
    };
    let plot = Plot::new("phase")
        .grid_spacing(22.0..=220.0)
        .grid_color(theme::grid(ui))
        .x_grid_spacer(theme::spacer_across(size.x))
        .y_grid_spacer(theme::spacer_up(size.y))
        .x_axis_label("travel [mm]")
        .y_axis_label("force [N]")
        .y_axis_min_width(grid::GUTTER)
        .y_axis_formatter(move |mark, range| label(mark.value, range, up))
        .x_axis_formatter(move |mark, range| label(mark.value, range, across))
        .include_x(0.0)
        .include_x(10.0)
        .include_y(0.0);
    let colors = [theme::line(0, ui), theme::line(1, ui)];
    plot.show(ui, move |plot| {
        for (i, (way, points)) in shown.ways.into_iter().enumerate() {
            let line = Line::new(["down", "up"][way], PlotPoints::new(points)).id(i);
            plot.line(line.color(colors[way]).width(1.4).allow_band(false));
        }
        if let Some(last) = shown.last {
            plot.points(Points::new("now", vec![last]).radius(4.0).color(theme::VERMILLION));
        }
    });
}

fn weights_ui(ui: &mut Ui, shown: &HysteresisLoop) {
    let [down, up] = shown.weights.map(|(sum, n)| (0 < n).then(|| sum / number::f64(n)));
    let text = |value: Option<f64>| value.map_or("–".to_owned(), |it| unit::text(it, "N"));
    // In the colours of the curves, whose legend these are.
    ui.colored_label(theme::line(0, ui), format!("down {}", text(down)))
        .on_hover_text("Mean force from 2 to 7 mm, going down.");
    ui.colored_label(theme::line(1, ui), format!("up {}", text(up)))
        .on_hover_text("Mean force from 7 to 2 mm, coming back.");
    if let Some((down, up)) = down.zip(up) {
        ui.label(format!("balance {}", unit::text(f64::midpoint(down, up), "N")));
        ui.label(format!("friction {}", unit::text((down - up) / 2.0, "N")));
    }
}

fn gather(store: &Store, key: u8, view: (f64, f64)) -> HysteresisLoop {
    let mut gathered = HysteresisLoop::default();
    let Some(trace) = store.trace(key) else { return gathered };
    let first = trace.row_at(store.tick(view.0.max(0.0))).unwrap_or(0);
    let last = trace.row_at(store.tick(view.1)).map_or(0, |row| row + 1);
    let (positions, speeds, forces) = (trace.values(0), trace.values(1), trace.values(3));
    for row in first..last {
        let [position, speed, force] =
            [positions, speeds, forces].map(|column| f64::from(column[row]));
        let point = [position * 1e3, force];
        let tick = trace.ticks()[row];
        gathered.is_torn |= !trace.gaps(tick.saturating_sub(1), tick).is_empty();
        if !(position.is_finite() && force.is_finite()) {
            gathered.is_torn = true;
            continue;
        }
        let way = usize::from(speed < if gathered.is_down() { -STILL } else { STILL });
        gathered.enter(way, point);
        if MIDDLE.contains(&position) && STILL < speed.abs() {
            gathered.weights[way].0 += force;
            gathered.weights[way].1 += 1;
        }
        gathered.last = Some(point);
    }
    gathered
}
