//! Actions of the mouse in a plot.

use eframe::egui::{PointerButton, Pos2, Rect, Response, Ui};
use egui_plot::PlotTransform;

use crate::{scope::Scope, theme};

/// Turn of the wheel (points) by which a plot shows 1/e as much.
const WHEEL: f64 = 200.0;

/// Handles a plot: a drag moves, the wheel zooms in time, with Shift in values, the right button
/// zooms to a stretch, a double click follows.
pub(super) fn handle(
    ui: &Ui,
    scope: &mut Scope,
    response: &Response,
    (lane, frame): (usize, &PlotTransform),
    now: f64,
) {
    let (start, end) = scope.view(now);
    let per_point = (end - start) / f64::from(frame.frame().width().max(1.0));
    let time = |at: Pos2| start + f64::from(at.x - frame.frame().left()) * per_point;
    if response.dragged_by(PointerButton::Primary) {
        scope.pan(-f64::from(response.drag_delta().x) * per_point, now);
        let high = f64::from(frame.frame().height().max(1.0));
        let by = f64::from(response.drag_delta().y) * frame.bounds().height() / high;
        scope.heights.pan(lane, by);
    }
    if let Some((at, turned)) = response.hover_pos().zip(wheel(ui)) {
        if ui.input(|input| input.modifiers.shift) {
            let about = frame.value_from_position(at).y;
            scope.heights.zoom(lane, values(frame), factor(turned), about);
        } else {
            scope.zoom(factor(turned), time(at), now);
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

/// Returns the turn of the wheel (points), if any.
pub(super) fn wheel(ui: &Ui) -> Option<f64> {
    let turned = ui.input(|input| {
        let scrolled = input.smooth_scroll_delta();
        // With Shift it scrolls across, and with Control it zooms.
        let across = if input.modifiers.shift { scrolled.x } else { 0.0 };
        f64::from(scrolled.y + across) + WHEEL * f64::from(input.zoom_delta()).ln()
    });
    (0.5 < turned.abs()).then_some(turned)
}

/// Returns the zoom factor of a turn of the wheel (points).
pub(super) fn factor(turned: f64) -> f64 {
    (-turned / WHEEL).exp()
}

pub(super) fn values(frame: &PlotTransform) -> (f64, f64) {
    (frame.bounds().min()[1], frame.bounds().max()[1])
}

fn select(
    ui: &Ui,
    scope: &mut Scope,
    response: &Response,
    frame: &PlotTransform,
    (from, to): (f64, f64),
) {
    let [left, right] = [from.min(to), from.max(to)].map(|at| frame.position_from_point_x(at));
    let rect = Rect::from_x_y_ranges(left..=right, frame.frame().y_range());
    ui.painter().rect_filled(rect.intersect(*frame.frame()), 0.0, theme::faint(theme::SKY, 0.25));
    if response.drag_stopped_by(PointerButton::Secondary) {
        scope.selects = None;
        if 4.0 < right - left {
            scope.show(from, to);
        }
    }
}
