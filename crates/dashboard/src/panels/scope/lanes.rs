//! The plots of a scope, from the top.

use eframe::egui::{
    Align, Align2, Button, FontId, Id, Label, Layout, Pos2, Rect, Response, RichText, Stroke, Ui,
    Vec2, vec2,
};
use egui_plot::{
    HoverPosition, Line, LineStyle, Plot, PlotBounds, PlotPoints, PlotTransform, Span, VLine,
};
use telemetry::event::Kind;

use super::data::{self, PlotTrace, Shade};
use super::{axis, cursors, mouse};
use crate::{grid, number, scope::Scope, store::Store, theme, unit};

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

/// Height of the names of the modes above the first plot (points).
const NAMES: f32 = 14.0;

/// Width of a value in a legend (points): fixed, so that nothing moves while values change.
const VALUE: f32 = 66.0;

/// Draws all plots, then the cursors over them; the first of `keys` is the scope's own.
pub(super) fn lanes_ui(ui: &mut Ui, scope: &mut Scope, store: &Store, keys: &[u8], now: f64) {
    let Some(key) = keys.first().copied() else { return };
    let channels = scope.channels(store, key);
    let view = scope.view(now);
    let table = if scope.has_cursors { TABLE } else { 0.0 };
    let room = ui.available_height() - table - 14.0 - NAMES;
    let height = (room / number::f32(number::f64(channels.len().max(1)))).max(50.0);
    let shades = data::shades(store, key, view);
    let link = ui.scope_id().with("time");
    let mut lanes = Vec::new();
    for (i, channels) in channels.iter().enumerate() {
        let width = ui.available_width();
        let traces = data::traces(store, keys, (i, channels), scope, (view, width));
        let bounds = data::bounds(&traces, view, &mut scope.heights, i);
        let strikes = data::events(store, key, Kind::Strike, view);
        lanes.push(PlotLane { bounds, traces, strikes });
    }
    // One width for all axes, so that a time has one place in all plots.
    let axes = lanes.iter().map(|lane| (values(&lane.bounds), grid::lines_up(height)));
    let gutter = grid::gutter(ui, axes);
    let of = lanes.len();
    let mut frames: Vec<PlotTransform> = Vec::new();
    for (i, lane) in lanes.into_iter().enumerate() {
        let top = ui.cursor().top();
        legend_ui(ui, scope, store, &lane.traces, view.1.min(now));
        if i == 0 {
            ui.add_space(NAMES);
        }
        let above = ui.cursor().top() - top;
        let extra = if i == 0 { NAMES } else { 0.0 } + if i + 1 == of { 14.0 } else { 0.0 };
        let size = vec2(gutter, (height + extra - above - ui.spacing().item_spacing.y).max(40.0));
        let plot = plot(ui, (i, of), link, size, &lane);
        let shown = lane_ui(ui, plot, &shades, lane);
        mouse::handle(ui, scope, &shown.0, (i, &shown.1), now);
        axis::axis_ui(ui, scope, i, &shown.1);
        frames.push(shown.1);
    }
    names_ui(ui, store, key, &shades, frames.first());
    if scope.has_cursors {
        cursors::cursors_ui(ui, scope, &frames);
        cursors::table_ui(ui, scope, store, keys, &channels);
    }
}

fn values(bounds: &PlotBounds) -> (f64, f64) {
    (bounds.min()[1], bounds.max()[1])
}

/// Draws the curves' names with their values at the time `at` (s); a click hides a curve.
fn legend_ui(ui: &mut Ui, scope: &mut Scope, store: &Store, traces: &[PlotTrace], at: f64) {
    let has_others = traces.iter().any(|trace| 0 < trace.place);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(4.0, 0.0);
        ui.spacing_mut().button_padding = vec2(3.0, 0.0);
        ui.spacing_mut().interact_size.y = 14.0;
        for (i, trace) in traces.iter().enumerate() {
            let title = if has_others { trace.title_with_key() } else { trace.title() };
            let color = theme::line(i, ui);
            let color = if trace.is_hidden { theme::faint(color, 0.4) } else { color };
            let text = RichText::new(title).small().color(color);
            let text = if trace.is_hidden { text.strikethrough() } else { text };
            let button = ui.add(Button::new(text).frame(false));
            let is_clicked = button.on_hover_text("A click hides or shows the curve.").clicked();
            let curve = (trace.key, trace.name.clone());
            if is_clicked && !scope.hidden.remove(&curve) {
                scope.hidden.insert(curve);
            }
            let unit = store.channel(trace.key, &trace.name).map_or("", |(_, unit)| unit);
            let value = store.value(trace.key, &trace.name, at).filter(|it| it.is_finite());
            let value = value.map_or_else(|| "–".to_owned(), |it| unit::text(it, unit));
            let layout = Layout::left_to_right(Align::Center);
            ui.allocate_ui_with_layout(vec2(VALUE, 14.0), layout, |ui| {
                ui.set_min_width(VALUE);
                ui.add(Label::new(RichText::new(value).small()).truncate());
            });
        }
    });
}

fn plot<'a>(
    ui: &Ui,
    (lane, of): (usize, usize),
    link: Id,
    Vec2 { x: gutter, y: height }: Vec2,
    shown: &PlotLane,
) -> Plot<'a> {
    let is_last = lane + 1 == of;
    let unit = shown.traces.first().map_or("", |it| it.unit.as_str());
    let (low, high) = values(&shown.bounds);
    let (across, up) = (grid::lines_across(ui.available_width()), grid::lines_up(height));
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
        .y_axis_min_width(gutter)
        .grid_spacing(22.0..=220.0)
        .grid_color(theme::grid(ui))
        .x_grid_spacer(theme::spacer_across(ui.available_width()))
        .y_grid_spacer(theme::spacer_up(height))
        .y_axis_label(unit::bracketed(unit))
        .y_axis_formatter(move |mark, _| grid::label(mark.value, (low, high), up))
        .x_axis_formatter(move |mark, range| {
            format!("{} s", grid::label(mark.value, (*range.start(), *range.end()), across))
        })
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
        for shade in shades {
            let fill = theme::faint(theme::mode(shade.mode), 0.16);
            plot.span(Span::new("", shade.from..=shade.to).fill(fill));
            if shade.is_switch {
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

/// Returns each trace as lines of its own colour, dashed by its key: one for each segment.
fn lines(ui: &Ui, traces: Vec<PlotTrace>) -> Vec<Line<'static>> {
    let has_others = traces.iter().any(|trace| 0 < trace.place);
    let mut lines = Vec::new();
    for (i, trace) in traces.into_iter().enumerate().filter(|(_, trace)| !trace.is_hidden) {
        let name = if has_others { trace.title_with_key() } else { trace.title() };
        let dash = trace.place.checked_sub(1).map(|other| DASHES[other % DASHES.len()]);
        let style = dash.map_or(LineStyle::Solid, |length| LineStyle::Dashed { length });
        let color = theme::line(i, ui);
        lines.extend(trace.segments.into_iter().enumerate().map(|(segment, points)| {
            Line::new(name.clone(), PlotPoints::new(points))
                .id((i, segment))
                .color(color)
                .style(style)
                .width(1.5)
                .allow_band(false)
        }));
    }
    lines
}

fn names_ui(ui: &Ui, store: &Store, key: u8, shades: &[Shade], frame: Option<&PlotTransform>) {
    let Some(frame) = frame else { return };
    let strip = Rect::from_x_y_ranges(
        frame.frame().x_range(),
        frame.frame().top() - NAMES..=frame.frame().top(),
    );
    let painter = ui.painter_at(strip);
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
        let at = Pos2::new(left + 4.0, strip.top());
        painter.text(at, Align2::LEFT_TOP, name, font, color);
    }
}
