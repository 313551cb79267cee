//! The y axis of a plot, as a handle.

use eframe::egui::{CursorIcon, Rect, Sense, Ui, WidgetInfo, accesskit::Role};
use egui_plot::PlotTransform;

use super::mouse;
use crate::scope::Scope;

/// Drag (points) by which a plot shows 1/e as much.
const DRAG: f64 = 100.0;

/// Handles the axis: a drag and the wheel zoom, a double click shows all values again.
pub(super) fn axis_ui(ui: &Ui, scope: &mut Scope, lane: usize, frame: &PlotTransform) {
    let inside = frame.frame();
    let rect = Rect::from_x_y_ranges(ui.max_rect().left()..=inside.left(), inside.y_range());
    let id = ui.scope_id().with(("y axis", lane));
    let axis = ui.interact(rect, id, Sense::click_and_drag());
    let (low, high) = mouse::values(frame);
    let label = format!("y axis of plot {}", lane + 1);
    axis.widget_info(|| WidgetInfo {
        value: Some(high - low),
        ..WidgetInfo::labeled(Role::ScrollBar, true, &label)
    });
    if axis.dragged() {
        let factor = (f64::from(axis.drag_delta().y) / DRAG).exp();
        scope.heights.zoom(lane, (low, high), factor, f64::midpoint(low, high));
    }
    if let Some((at, turned)) = axis.hover_pos().zip(mouse::wheel(ui)) {
        let about = frame.value_from_position(at).y;
        scope.heights.zoom(lane, (low, high), mouse::factor(turned), about);
    }
    if axis.double_clicked() {
        scope.heights.fit(lane);
    }
    axis.on_hover_cursor(CursorIcon::ResizeVertical)
        .on_hover_text("A drag or the wheel zooms, a double click shows all values.");
}
