//! Timeliness of ticks: their durations, and the causes of late ones.

use eframe::egui::{Color32, RichText, TextStyle, Ui};
use egui_plot::{Bar, BarChart, Corner, HLine, Legend, Line, Plot, PlotPoints, Points, VLine};
use serde::{Deserialize, Serialize};
use telemetry::{Deadlines, Spread};

use super::{nothing_ui, piece_ui};
use crate::store::timing::{TickOutcome, Timed};
use crate::{app_state::AppState, theme, unit};

/// Most ticks on the timeline.
const SHOWN: usize = 4000;

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
enum Which {
    #[default]
    Turnaround,
    Lateness,
    Work,
    Baseline,
}

impl Which {
    const ALL: [Self; 4] = [Self::Turnaround, Self::Lateness, Self::Work, Self::Baseline];

    const fn text(self) -> &'static str {
        match self {
            Self::Turnaround => "turnaround",
            Self::Lateness => "lateness",
            Self::Work => "work",
            Self::Baseline => "bare timer",
        }
    }

    const fn of(self, deadlines: &Deadlines) -> Option<&Spread> {
        match self {
            Self::Turnaround => deadlines.turnaround.as_ref(),
            Self::Lateness => deadlines.lateness.as_ref(),
            Self::Work => deadlines.work.as_ref(),
            Self::Baseline => deadlines.baseline.as_ref(),
        }
    }
}

#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct View {
    which: Which,
}

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        let Some(deadlines) = &state.store.deadlines else {
            nothing_ui(ui, state, "Deadlines are told once a second.");
            return;
        };
        counts_ui(ui, deadlines);
        ui.horizontal_wrapped(|ui| {
            for which in Which::ALL {
                ui.selectable_value(&mut self.which, which, which.text());
            }
            if let Some(spread) = self.which.of(deadlines) {
                quantiles_ui(ui, spread);
            }
        });
        let height = (ui.available_height() / 2.0 - 6.0).max(60.0);
        if let Some(spread) = self.which.of(deadlines) {
            histogram_ui(ui, spread, height);
        }
        timeline_ui(ui, state, height);
    }
}

fn counts_ui(ui: &mut Ui, deadlines: &Deadlines) {
    ui.horizontal_wrapped(|ui| {
        piece_ui(ui, RichText::new(format!("{} ticks", deadlines.ticks)).strong());
        let counts = [
            ("missed", deadlines.missed),
            ("own work", deadlines.own_work),
            ("woken late", deadlines.woken_late),
            ("preempted", deadlines.preempted),
            ("skipped", deadlines.skipped),
        ];
        for (name, count) in counts {
            let color = if count == 0 { ui.visuals().weak_text_color() } else { theme::fault(ui) };
            piece_ui(ui, RichText::new(format!("{count} {name}")).color(color));
        }
    });
}

fn quantiles_ui(ui: &mut Ui, spread: &Spread) {
    let quantiles =
        [("p50", spread.p50), ("p99", spread.p99), ("p99.9", spread.p999), ("most", spread.max)];
    for (name, time) in quantiles {
        piece_ui(ui, RichText::new(format!("{name} {time:.0} µs")).weak());
    }
}

/// Draws the numbers of ticks by duration on a logarithm, so that a single one is visible.
fn histogram_ui(ui: &mut Ui, spread: &Spread, height: f32) {
    let mut before = 0.0;
    let mut bars = Vec::with_capacity(spread.edge.len());
    let buckets = spread.edge.iter().zip(&spread.count);
    for (edge, count) in buckets.filter(|(edge, _)| edge.is_finite()) {
        let height = (*count as f64 + 1.0).log10();
        let middle = f64::midpoint(before, *edge);
        bars.push(Bar::new(middle, height).width((edge - before) * 0.92).name(format!("{count}")));
        before = *edge;
    }
    let marks = [("p99", spread.p99, theme::ORANGE), ("p99.9", spread.p999, theme::VERMILLION)];
    let color = theme::line(0, ui);
    Plot::new("histogram")
        .grid_spacing(22.0..=220.0)
        .grid_color(theme::grid(ui))
        .x_grid_spacer(theme::spacer_across(ui.available_width()))
        .height(height)
        .allow_scroll(false)
        .legend(legend())
        .x_axis_label("time [µs]")
        .y_axis_label("ticks")
        .y_axis_formatter(|mark, _| unit::digits(10_f64.powf(mark.value).round()))
        .include_x(0.0)
        .include_y(0.0)
        .show(ui, move |plot| {
            plot.bar_chart(BarChart::new("", bars).color(color));
            for (name, at, color) in marks.into_iter().filter(|mark| mark.1.is_finite()) {
                plot.vline(VLine::new(name, at).color(color).width(1.5));
            }
        });
}

/// Returns a half transparent legend, since in a narrow tile it covers much.
fn legend() -> Legend {
    Legend::default().text_style(TextStyle::Small).position(Corner::RightTop).background_alpha(0.5)
}

const fn color(cause: TickOutcome) -> Color32 {
    match cause {
        TickOutcome::InTime => theme::GREEN,
        TickOutcome::WokenLate => theme::ORANGE,
        TickOutcome::Preempted => theme::PURPLE,
        TickOutcome::OwnWork => theme::VERMILLION,
    }
}

fn timeline_ui(ui: &mut Ui, state: &AppState, height: f32) {
    let ticks = state.store.timing.ticks();
    let skipped = ticks.len().saturating_sub(SHOWN);
    let shown: Vec<Timed> = ticks.iter().skip(skipped).copied().collect();
    let period = state.store.period();
    let point = |it: &Timed| [state.store.seconds(it.tick), f64::from(it.lateness + it.turnaround)];
    let all: Vec<[f64; 2]> = shown.iter().map(point).collect();
    let line = theme::line(0, ui);
    let late: Vec<(TickOutcome, Vec<[f64; 2]>)> = TickOutcome::ALL
        .into_iter()
        .filter(|cause| *cause != TickOutcome::InTime)
        .map(|cause| (cause, shown.iter().filter(|it| it.cause == cause).map(point).collect()))
        .collect();
    let limit = period * 1e6;
    Plot::new("ticks")
        .grid_spacing(22.0..=220.0)
        .grid_color(theme::grid(ui))
        .x_grid_spacer(theme::spacer_across(ui.available_width()))
        .y_grid_spacer(theme::spacer_up(height))
        .height(height)
        .allow_scroll(false)
        .legend(legend().follow_insertion_order(true))
        .x_axis_formatter(|mark, _| format!("{} s", unit::digits(mark.value)))
        .y_axis_label("due to done [µs]")
        .y_axis_formatter(|mark, _| unit::digits(mark.value))
        .include_y(0.0)
        .show(ui, move |plot| {
            plot.line(Line::new("tick", PlotPoints::new(all)).color(line).width(1.0));
            plot.hline(HLine::new("deadline", limit).color(theme::YELLOW).width(1.2));
            for (cause, points) in late {
                let points = Points::new(cause.text(), points).radius(4.0).color(color(cause));
                plot.points(points);
            }
        });
}
