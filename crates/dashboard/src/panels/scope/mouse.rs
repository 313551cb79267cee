//! What the mouse does in a plot.

use eframe::egui::{PointerButton, Pos2, Rect, Response, Ui};
use egui_plot::PlotTransform;

use crate::look;
use crate::scope::Scope;

/// A drag moves, the wheel zooms, the right button zooms to what it covers, a double click
/// follows.
pub(super) fn handle(
    ui: &Ui,
    scope: &mut Scope,
    response: &Response,
    frame: &PlotTransform,
    now: f64,
) {
    let (start, end) = scope.view(now);
    let per_point = (end - start) / f64::from(frame.frame().width().max(1.0));
    let time = |at: Pos2| start + f64::from(at.x - frame.frame().left()) * per_point;
    if response.dragged_by(PointerButton::Primary) {
        scope.pan(-f64::from(response.drag_delta().x) * per_point, now);
    }
    if response.hovered() {
        let wheel =
            ui.input(|input| input.smooth_scroll_delta().y + 200.0 * input.zoom_delta().ln());
        if let Some(at) = response.hover_pos().filter(|_| 0.5 < wheel.abs()) {
            scope.zoom((-f64::from(wheel) / 200.0).exp(), time(at), now);
        }
    }
    let here = ui.input(|input| input.pointer.latest_pos());
    if response.drag_started_by(PointerButton::Secondary) {
        scope.selects = ui.input(|input| input.pointer.press_origin()).map(time);
    }
    if let Some((from, here)) = scope.selects.zip(here) {
        select(ui, scope, response, frame, (from, time(here)));
    }
    if response.double_clicked() {
        scope.pinned = None;
    }
}

/// The stretch that the right button covers: seen alone once it is let go.
fn select(
    ui: &Ui,
    scope: &mut Scope,
    response: &Response,
    frame: &PlotTransform,
    (from, to): (f64, f64),
) {
    let [left, right] = [from.min(to), from.max(to)].map(|at| frame.position_from_point_x(at));
    let rect = Rect::from_x_y_ranges(left..=right, frame.frame().y_range());
    ui.painter().rect_filled(rect.intersect(*frame.frame()), 0.0, look::faint(look::SKY, 0.25));
    if response.drag_stopped_by(PointerButton::Secondary) {
        scope.selects = None;
        if 4.0 < right - left {
            scope.show(from, to);
        }
    }
}
