//! A key's mechanism, to scale and in motion, as its model describes it.

use std::f32::consts::TAU;

use eframe::egui::{
    Align2, Color32, FontId, Label, Mesh, Painter, Pos2, Rect, RichText, Sense, Shape, Stroke, Ui,
    WidgetInfo, accesskit::Role, pos2, vec2,
};
use serde::{Deserialize, Serialize};
use telemetry::{Body, Coil, Drawing, Follower, Outline, outline};

use super::nothing_ui;
use crate::triangulate::{self, ScreenPoint};
use crate::{app_state::AppState, names, number, theme, unit};

/// The map from the drawing (m) to the screen.
struct Scale {
    origin: Pos2,
    left: f64,
    bottom: f64,
    points_per_metre: f64,
}

impl Scale {
    /// Fits all of `drawing` in `rect`, as large as both directions allow.
    fn new(drawing: &Drawing, rect: Rect) -> Option<Self> {
        let width = drawing.right - drawing.left;
        let height = drawing.top - drawing.bottom;
        let is_finite = width.is_finite() && height.is_finite();
        if !(is_finite && 0.0 < width && 0.0 < height) {
            return None;
        }
        let room = rect.shrink(8.0);
        let across = f64::from(room.width()) / width;
        let points_per_metre = across.min(f64::from(room.height()) / height);
        let used = vec2(number::f32(width), number::f32(height)) * number::f32(points_per_metre);
        let free = room.size() - used;
        let origin = room.left_bottom() + vec2(free.x / 2.0, -free.y / 2.0);
        Some(Self { origin, left: drawing.left, bottom: drawing.bottom, points_per_metre })
    }

    fn place(&self, [x, y]: [f64; 2]) -> Pos2 {
        let across = number::f32((x - self.left) * self.points_per_metre);
        let up = number::f32((y - self.bottom) * self.points_per_metre);
        pos2(self.origin.x + across, self.origin.y - up)
    }
}

struct BodyPose {
    x: f64,
    y: f64,
    sin: f64,
    cos: f64,
}

impl BodyPose {
    fn of(body: &Body, value: &impl Fn(&str) -> f64) -> Self {
        let at =
            |follower: &Option<Follower>| follower.as_ref().map_or(0.0, |it| follow(it, value));
        let (sin, cos) = at(&body.angle).sin_cos();
        Self { x: at(&body.x), y: at(&body.y), sin, cos }
    }

    const fn is_known(&self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.sin.is_finite()
    }

    fn point(&self, x: f64, y: f64) -> [f64; 2] {
        [self.x + self.cos * x - self.sin * y, self.y + self.sin * x + self.cos * y]
    }
}

fn follow(follower: &Follower, value: &impl Fn(&str) -> f64) -> f64 {
    if follower.signal.is_empty() {
        return follower.offset;
    }
    follower.offset + follower.scale * value(&follower.signal)
}

#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(super) struct View;

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        mechanism_ui(ui, state);
    }
}

fn mechanism_ui(ui: &mut Ui, state: &mut AppState) {
    let key = state.view.selected;
    state.want(key);
    let now = state.now();
    let mode = mode(state, key, now);
    ui.horizontal_wrapped(|ui| {
        ui.strong(state.title(key));
        if let Some(mode) = mode {
            ui.colored_label(theme::mode(mode), state.store.mode_name(key, mode));
        }
        for (channel, of) in [("position", "m"), ("sent", "N")] {
            if let Some(value) = value(state, key, channel, now) {
                ui.label(unit::text(value, of));
            }
        }
    });
    let Some(drawing) = state.store.voice(key).and_then(|voice| voice.drawing.as_ref()) else {
        nothing_ui(ui, state, "This model says nothing of how it looks.");
        return;
    };
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
    let name = format!("mechanism of {}", names::name(key));
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 3.0, ui.visuals().extreme_bg_color);
    if let Some(scale) = Scale::new(drawing, rect) {
        // Unknown values are not drawn: a posture of zeros would be a false one.
        let value = |name: &str| value(state, key, name, now).unwrap_or(f64::NAN);
        if is_posed(drawing, mode, &value) {
            paint(&painter, drawing, &scale, mode, &value);
            paint_ruler(ui, &painter, &scale, rect);
        } else {
            ui.put(rect, Label::new(RichText::new(WAITS).weak()));
        }
    }
}

const WAITS: &str = "Waiting for this key's first row: how it stands is not known yet.";

/// Returns `true` if the pose of every body that this mode shows is known.
fn is_posed(drawing: &Drawing, mode: Option<u8>, value: &impl Fn(&str) -> f64) -> bool {
    let seen = drawing.bodies.iter().filter(|body| is_shown(&body.modes, mode));
    seen.map(|body| BodyPose::of(body, value)).all(|pose| pose.is_known())
}

fn is_shown(modes: &[u32], mode: Option<u8>) -> bool {
    modes.is_empty() || mode.is_none_or(|it| modes.contains(&it.into()))
}

/// Returns the mode at the time shown; without rows that of the overview.
fn mode(state: &AppState, key: u8, now: f64) -> Option<u8> {
    let trace = state.store.trace(key);
    let row = trace.and_then(|trace| trace.row_at(state.store.tick(now)));
    let known = trace.zip(row).and_then(|(trace, row)| trace.modes().get(row).copied());
    known.or_else(|| state.store.summaries.key(key).mode)
}

/// Returns a signal at the time shown; the position also without rows.
fn value(state: &AppState, key: u8, name: &str, now: f64) -> Option<f64> {
    let known = state.store.value(key, name, now).filter(|value| value.is_finite());
    let summary = state.store.summaries.is_known.then(|| state.store.summaries.key(key));
    known.or_else(|| match name {
        "position" => Some(f64::from(summary?.position)),
        "sent" => Some(f64::from(summary?.force)),
        _ => None,
    })
}

fn paint(
    painter: &Painter,
    drawing: &Drawing,
    scale: &Scale,
    mode: Option<u8>,
    value: &impl Fn(&str) -> f64,
) {
    let poses: Vec<BodyPose> =
        drawing.bodies.iter().map(|body| BodyPose::of(body, value)).collect();
    for (body, pose) in drawing.bodies.iter().zip(&poses) {
        if is_shown(&body.modes, mode) {
            body.outlines.iter().for_each(|it| paint_outline(painter, it, pose, scale));
        }
    }
    for coil in drawing.coils.iter().filter(|coil| is_shown(&coil.modes, mode)) {
        paint_coil(painter, coil, &poses, scale);
    }
}

fn paint_outline(painter: &Painter, outline: &Outline, pose: &BodyPose, scale: &Scale) {
    let pairs = outline.x.iter().zip(&outline.y);
    let corners: Vec<ScreenPoint> = pairs.map(|(x, y)| [*x, *y]).collect();
    let place = |[x, y]: &ScreenPoint| scale.place(pose.point(*x, *y));
    let points: Vec<Pos2> = corners.iter().map(place).collect();
    if !points.iter().all(|point| point.is_finite()) {
        return;
    }
    let color = color(outline.kind());
    let stroke = Stroke::new(1.2, theme::blend(color, Color32::BLACK, 0.35));
    if !outline.closed {
        painter.add(Shape::line(points, Stroke::new(1.8, color)));
    } else if triangulate::is_convex(&corners) {
        painter.add(Shape::convex_polygon(points, color, stroke));
    } else {
        painter.add(filled(&corners, &points, color));
        painter.add(Shape::closed_line(points, stroke));
    }
}

/// Fills an outline that is not convex, cut in the body's own axes, so that nothing flickers.
fn filled(corners: &[ScreenPoint], points: &[Pos2], color: Color32) -> Shape {
    let mut mesh = Mesh::default();
    for point in points {
        mesh.colored_vertex(*point, color);
    }
    for triangle in triangulate::triangles(corners) {
        // There are few: `triangulate` accepts no larger outline.
        let [a, b, c] = triangle.map(|corner| u32::try_from(corner).unwrap_or(0));
        mesh.add_triangle(a, b, c);
    }
    Shape::mesh(mesh)
}

const fn color(kind: outline::Kind) -> Color32 {
    match kind {
        outline::Kind::Wood => Color32::from_rgb(0xC8, 0x9B, 0x6A),
        outline::Kind::Felt => Color32::from_rgb(0xB9, 0x3E, 0x4A),
        outline::Kind::Metal => Color32::from_rgb(0x9A, 0xA4, 0xAE),
        outline::Kind::String => Color32::from_rgb(0xE6, 0xC8, 0x5A),
        outline::Kind::Ground => Color32::from_rgb(0x6B, 0x74, 0x7E),
        outline::Kind::Finger => Color32::from_rgb(0xE0, 0xA9, 0x8C),
    }
}

/// Draws a spring: a wave between two bodies' points, tighter the shorter the spring.
fn paint_coil(painter: &Painter, coil: &Coil, poses: &[BodyPose], scale: &Scale) {
    let end = |body: u32, x: f64, y: f64| {
        let pose = usize::try_from(body).ok().and_then(|body| poses.get(body));
        pose.map(|pose| scale.place(pose.point(x, y)))
    };
    let from = end(coil.from, coil.from_x, coil.from_y);
    let to = end(coil.to, coil.to_x, coil.to_y);
    let ends = from.zip(to).filter(|(from, to)| from.is_finite() && to.is_finite());
    let Some((from, to)) = ends else { return };
    let along = to - from;
    let across = along.rot90().normalized() * 4.5;
    let wave = |i: u8| {
        let share = f32::from(i) / 48.0;
        from + along * share + across * (share * 6.0 * TAU).sin()
    };
    painter.add(Shape::line((0..=48).map(wave).collect(), Stroke::new(1.4, theme::GREEN)));
}

fn paint_ruler(ui: &Ui, painter: &Painter, scale: &Scale, rect: Rect) {
    let length = number::round(f64::from(rect.width()) * 0.25 / scale.points_per_metre);
    let width = number::f32(length * scale.points_per_metre);
    let right = rect.right_bottom() + vec2(-10.0, -10.0);
    let stroke = Stroke::new(1.5, ui.visuals().weak_text_color());
    painter.hline(right.x - width..=right.x, right.y, stroke);
    for x in [right.x - width, right.x] {
        painter.vline(x, right.y - 4.0..=right.y, stroke);
    }
    let place = right + vec2(-width / 2.0, -5.0);
    let font = FontId::proportional(11.0);
    let text = unit::text(length, "m");
    painter.text(place, Align2::CENTER_BOTTOM, text, font, ui.visuals().weak_text_color());
}
