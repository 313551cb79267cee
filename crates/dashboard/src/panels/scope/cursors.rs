//! Two cursors through all plots, with a table of their values.

use eframe::egui::{
    Align2, CursorIcon, FontId, Grid, Pos2, Rect, ScrollArea, Sense, Stroke, Ui, WidgetInfo,
    accesskit::Role, vec2,
};
use egui_plot::PlotTransform;

use crate::{names, scope::Scope, store::Store, theme, unit};

/// Distance to each side within which a cursor is caught (points).
const REACH: f32 = 5.0;

/// Draws two lines through all plots that the mouse can drag.
pub(super) fn cursors_ui(ui: &Ui, scope: &mut Scope, frames: &[PlotTransform]) {
    for (i, frame) in frames.iter().enumerate() {
        for (cursor, name) in ["A", "B"].into_iter().enumerate() {
            let x = frame.position_from_point_x(scope.cursors[cursor]);
            let column = Rect::from_x_y_ranges(x - REACH..=x + REACH, frame.frame().y_range());
            if !frame.frame().x_range().contains(x) {
                continue;
            }
            let response =
                ui.interact(column, ui.scope_id().with(("cursor", i, cursor)), Sense::drag());
            let at = scope.cursors[cursor];
            let label = format!("cursor {name} in plot {}", i + 1);
            response.widget_info(|| WidgetInfo {
                value: Some(at),
                ..WidgetInfo::labeled(Role::Splitter, true, &label)
            });
            if response.dragged() {
                let width = f64::from(frame.frame().width().max(1.0));
                let per_point = frame.bounds().width() / width;
                scope.cursors[cursor] += f64::from(response.drag_delta().x) * per_point;
            }
            let color = [theme::selected(ui.visuals()), theme::PURPLE][cursor];
            let painter = ui.painter();
            painter.vline(x, frame.frame().y_range(), Stroke::new(1.5, color));
            let font = FontId::proportional(11.0);
            let at = Pos2::new(x + 3.0, frame.frame().bottom() - 2.0);
            painter.text(at, Align2::LEFT_BOTTOM, name, font, color);
            response.on_hover_cursor(CursorIcon::ResizeHorizontal);
        }
    }
}

pub(super) fn table_ui(
    ui: &mut Ui,
    scope: &Scope,
    store: &Store,
    keys: &[u8],
    lanes: &[Vec<String>],
) {
    let [a, b] = scope.cursors;
    let delta = b - a;
    let hertz = if delta.abs() < 1e-9 { "–".to_owned() } else { unit::digits(1.0 / delta.abs()) };
    ui.spacing_mut().item_spacing = vec2(14.0, 1.0);
    ui.label(format!("A {a:.5} s    B {b:.5} s    Δt {}    1/Δt {hertz} Hz", unit::seconds(delta)));
    let channels = |key: u8| lanes.iter().flatten().map(move |channel| (key, channel.as_str()));
    let columns: Vec<CursorColumn<'_>> = keys.iter().copied().flat_map(channels).collect();
    ScrollArea::horizontal().auto_shrink([false, true]).show(ui, |ui| {
        Grid::new("cursors").striped(true).show(ui, |ui| {
            header_ui(ui, keys, &columns);
            let at = |(key, channel): &CursorColumn<'_>, at: f64| store.value(*key, channel, at);
            row_ui(ui, "A", store, &columns, |column| at(column, a));
            row_ui(ui, "B", store, &columns, |column| at(column, b));
            row_ui(ui, "Δ", store, &columns, |column| Some(at(column, b)? - at(column, a)?));
        });
    });
}

type CursorColumn<'a> = (u8, &'a str);

fn header_ui(ui: &mut Ui, keys: &[u8], columns: &[CursorColumn<'_>]) {
    ui.weak("");
    for (key, channel) in columns {
        let of = if keys.len() == 1 { String::new() } else { names::name(*key) + " " };
        ui.weak(of + channel);
    }
    ui.end_row();
}

fn row_ui(
    ui: &mut Ui,
    name: &str,
    store: &Store,
    columns: &[CursorColumn<'_>],
    value: impl Fn(&CursorColumn<'_>) -> Option<f64>,
) {
    ui.weak(name);
    for column in columns {
        let unit = store.channel(column.0, column.1).map_or("", |(_, unit)| unit);
        ui.label(value(column).map_or_else(|| "–".to_owned(), |it| unit::text(it, unit)));
    }
    ui.end_row();
}
