//! The plots of a scope, from the top.

use eframe::egui::{Align2, FontId, Id, Pos2, Response, Stroke, TextStyle, Ui};
use egui_plot::{
    Corner, HoverPosition, Legend, Line, LineStyle, Plot, PlotBounds, PlotPoints, PlotTransform,
    Span, VLine,
};
use telemetry::event::Kind;

use super::data::{self, PlotTrace, Shade};
use super::{axis, cursors, mouse};
use crate::scope::Scope;
use crate::store::Store;
use crate::{number, theme, unit};

/// Height of the table of the cursors (points).
const TABLE: f32 = 108.0;

/// Dashes of compared keys (points); the scope's own key has solid lines.
const DASHES: [f32; 4] = [9.0, 4.0, 16.0, 2.5];

struct PlotLane {
    bounds: PlotBounds,
    traces: Vec<PlotTrace>,
    /// Times of strikes of the scope's own key (s).
    strikes: Vec<f64>,
}

/// Draws all plots, then the cursors over them; the first of `keys` is the scope's own.
pub(super) fn lanes_ui(ui: &mut Ui, scope: &mut Scope, store: &Store, keys: &[u8], now: f64) {
    let Some(key) = keys.first().copied() else { return };
    let lanes = scope.channels(store, key);
    let view = scope.view(now);
    let table = if scope.has_cursors { TABLE } else { 0.0 };
    let room = ui.available_height() - table - 14.0;
    let height = (room / number::f32(number::f64(lanes.len().max(1)))).max(50.0);
    let shades = data::shades(store, key, view);
    let link = ui.scope_id().with("time");
    let mut frames: Vec<PlotTransform> = Vec::new();
    for (i, channels) in lanes.iter().enumerate() {
        let is_last = i + 1 == lanes.len();
        let height = if is_last { height + 14.0 } else { height };
        let traces = data::traces(store, keys, channels, view, ui.available_width());
        let unit = traces.first().map_or("", |it| it.unit.as_str());
        let plot = plot(ui, (i, lanes.len()), link, height, unit);
        let bounds = data::bounds(&traces, view, scope.heights.of(i));
        let strikes = data::events(store, key, Kind::Strike, view);
        let shown = lane_ui(ui, plot, &shades, PlotLane { bounds, traces, strikes });
        mouse::handle(ui, scope, &shown.0, (i, &shown.1), now);
        axis::axis_ui(ui, scope, i, &shown.1);
        frames.push(shown.1);
    }
    names_ui(ui, store, key, &shades, frames.first());
    if scope.has_cursors {
        cursors::cursors_ui(ui, scope, &frames);
        cursors::table_ui(ui, scope, store, keys, &lanes);
    }
}

/// Returns a plot without contents, which does not move by itself.
fn plot<'a>(ui: &Ui, (lane, of): (usize, usize), link: Id, height: f32, unit: &str) -> Plot<'a> {
    let is_last = lane + 1 == of;
    Plot::new(("lane", lane))
        .height(height)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_axis_zoom_drag(false)
        .allow_double_click_reset(false)
        .link_cursor(link, [true, false])
        .show_axes([is_last, true])
        .y_axis_min_width(54.0)
        .grid_spacing(22.0..=220.0)
        .grid_color(theme::grid(ui))
        .x_grid_spacer(theme::spacer_across(ui.available_width()))
        .y_grid_spacer(theme::spacer_up(height))
        .y_axis_label(unit::bracketed(unit))
        .y_axis_formatter(|mark, _| unit::digits(mark.value))
        .x_axis_formatter(|mark, _| format!("{} s", unit::digits(mark.value)))
        .legend(
            Legend::default()
                .text_style(TextStyle::Small)
                .position(Corner::RightTop)
                .background_alpha(0.6)
                .follow_insertion_order(true),
        )
        .label_formatter(|hover| Some(label(hover)))
}

fn label(hover: &HoverPosition<'_>) -> String {
    match hover {
        HoverPosition::NearDataPoint { plot_name, position, index: _ } => {
            format!("{plot_name}\n{}\n{:.5} s", unit::digits(position.y), position.x)
        }
        HoverPosition::Elsewhere { position } => format!("{:.5} s", position.x),
    }
}

fn lane_ui(
    ui: &mut Ui,
    plot: Plot<'_>,
    shades: &[Shade],
    lane: PlotLane,
) -> (Response, PlotTransform) {
    let PlotLane { bounds, traces, strikes } = lane;
    let line = theme::faint(ui.visuals().strong_text_color(), 0.55);
    let lines = lines(ui, traces);
    let shown = plot.show(ui, move |plot| {
        plot.set_plot_bounds(bounds);
        for (i, shade) in shades.iter().enumerate() {
            let fill = theme::faint(theme::mode(shade.mode), 0.16);
            plot.span(Span::new("", shade.from..=shade.to).fill(fill));
            if 0 < i {
                plot.vline(VLine::new("", shade.from).stroke(Stroke::new(1.2, line)));
            }
        }
        for at in strikes {
            let stroke = Stroke::new(1.4, theme::VERMILLION);
            let style = LineStyle::dashed_dense();
            plot.vline(VLine::new("", at).stroke(stroke).style(style));
        }
        for line in lines {
            plot.line(line);
        }
    });
    (shown.response, shown.transform)
}

/// Returns each trace as a line of its own colour, dashed by its key.
fn lines(ui: &Ui, traces: Vec<PlotTrace>) -> Vec<Line<'static>> {
    let has_others = traces.iter().any(|trace| 0 < trace.place);
    let line = |(i, trace): (usize, PlotTrace)| {
        let name = if has_others { trace.title_with_key() } else { trace.title() };
        let dash = trace.place.checked_sub(1).map(|other| DASHES[other % DASHES.len()]);
        let style = dash.map_or(LineStyle::Solid, |length| LineStyle::Dashed { length });
        Line::new(name, PlotPoints::new(trace.points))
            .color(theme::line(i, ui))
            .style(style)
            .width(1.5)
            .allow_band(false)
    };
    traces.into_iter().enumerate().map(line).collect()
}

/// Draws names of the modes in the first plot, if there is room.
fn names_ui(ui: &Ui, store: &Store, key: u8, shades: &[Shade], frame: Option<&PlotTransform>) {
    let Some(frame) = frame else { return };
    let painter = ui.painter_at(*frame.frame());
    for shade in shades {
        let left = frame.position_from_point_x(shade.from);
        let room = frame.position_from_point_x(shade.to) - left;
        let name = store.mode_name(key, shade.mode);
        let name = name.split(' ').next().unwrap_or_default().to_owned();
        if room < 8.0 * number::f32(number::f64(name.chars().count())) + 6.0 {
            continue;
        }
        let font = FontId::proportional(11.0);
        let color = theme::blend(theme::mode(shade.mode), ui.visuals().strong_text_color(), 0.35);
        let at = Pos2::new(left + 4.0, frame.frame().top() + 3.0);
        painter.text(at, Align2::LEFT_TOP, name, font, color);
    }
}
