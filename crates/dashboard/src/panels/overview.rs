//! All keys at once: depth, force, mode and fault.

use eframe::egui::{
    Align2, Color32, FontId, Label, Painter, Pos2, Rect, Response, RichText, Sense, Shape, Stroke,
    StrokeKind, Ui, WidgetInfo, accesskit::Role, pos2, vec2,
};
use serde::{Deserialize, Serialize};
use telemetry::Severity;

use crate::names::{self, LAST};
use crate::store::{condition::KeyCondition, key_summary::KeySummary};
use crate::{app_state::AppState, fault_text, number, theme};

/// Travel drawn as a full stroke (m).
const TRAVEL: f32 = 10e-3;

/// Bit of `KeyBlock.flags` for a key whose model is not run.
const NOT_RUN: u8 = 8;

#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(super) struct View;

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        overview_ui(ui, state);
    }
}

fn overview_ui(ui: &mut Ui, state: &mut AppState) {
    legend_ui(ui, state);
    conditions_ui(ui, state);
    let size = vec2(ui.available_width(), ui.available_height().max(60.0));
    let (area, _) = ui.allocate_exact_size(size, Sense::hover());
    let (white, black) = (0..=LAST).partition::<Vec<u8>, _>(|key| !names::is_black(*key));
    // Black keys lie over white ones, for the eye and for the mouse.
    for key in white.into_iter().chain(black) {
        key_ui(ui, state, key, rect(area, key));
    }
    range_ui(ui, state, area);
}

fn legend_ui(ui: &mut Ui, state: &AppState) {
    ui.horizontal(|ui| {
        let key = state.view.selected;
        ui.strong(state.title(key));
        ui.label(words(state, key));
        ui.separator();
        let modes = state.store.model_of(key).map_or(0, |model| model.modes.len());
        for mode in (0..=u8::MAX).take(modes) {
            let (rect, _) = ui.allocate_exact_size(vec2(10.0, 10.0), Sense::hover());
            ui.painter().rect_filled(rect, 2.0, theme::mode(mode));
            ui.label(state.store.mode_name(key, mode));
        }
    });
}

/// Draws keys and boards without a force in one line, which is always there.
fn conditions_ui(ui: &mut Ui, state: &AppState) {
    let conditions = &state.store.conditions;
    let faulty: Vec<String> = state.store.faulty().into_iter().map(names::name).collect();
    let faults = (!faulty.is_empty()).then(|| format!("fault: {}", faulty.join(", ")));
    let lost: Vec<_> = conditions.boards.iter().cloned().chain(faults).collect();
    let severity = if !lost.is_empty() {
        Severity::Lost
    } else if conditions.others.is_empty() {
        Severity::Well
    } else {
        Severity::Degraded
    };
    let troubles: Vec<_> = lost.iter().chain(&conditions.others).map(String::as_str).collect();
    let (color, text) = if severity != Severity::Well {
        (theme::severity(severity, ui), troubles.join("; "))
    } else if let Some(why) = state.source_state().why_empty() {
        (ui.visuals().weak_text_color(), why)
    } else {
        let n = state.store.voices().count();
        (theme::severity(severity, ui), format!("All {n} keys are well."))
    };
    ui.add(Label::new(RichText::new(text).color(color)).truncate());
}

fn words(state: &AppState, key: u8) -> String {
    let summary = state.store.summaries.key(key);
    let mode =
        summary.mode.map_or_else(|| "no model".to_owned(), |it| state.store.mode_name(key, it));
    let fault = fault_text::fault(summary.fault).map_or("", |it| it.name);
    let sep = if fault.is_empty() { "" } else { ", " };
    // The sum avoids a negative zero.
    let position = (f64::from(summary.position) * 1e4).round() / 10.0 + 0.0;
    format!("{:.1} mm, {:.2} N, {mode}{sep}{fault}", position, summary.force)
}

fn rect(area: Rect, key: u8) -> Rect {
    let white = area.width() / 52.0;
    let place = number::f32(number::f64(names::whites_below(key)));
    let left = area.left() + place * white;
    let height = area.height() - 14.0;
    if names::is_black(key) {
        let width = white * 0.62;
        let top = pos2(left - width / 2.0, area.top());
        Rect::from_min_size(top, vec2(width, height * 0.62))
    } else {
        Rect::from_min_size(pos2(left, area.top()), vec2(white - 1.0, height))
    }
}

fn key_ui(ui: &mut Ui, state: &mut AppState, key: u8, rect: Rect) {
    let response = ui.interact(rect, ui.scope_id().with(("key", key)), Sense::click());
    let selected = state.view.selected == key;
    let mut name = format!("key {}", names::name(key));
    let condition = state.store.conditions.key(key).words();
    if !condition.is_empty() {
        name = format!("{name}, {condition}");
    }
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, selected, &name));
    if ui.is_rect_visible(rect) {
        paint_key(ui, state, key, rect, &response);
    }
    if response.clicked() {
        if ui.input(|input| input.modifiers.shift) {
            state.select_up_to(key);
        } else {
            state.select(key);
        }
    }
    response.on_hover_ui(|ui| {
        ui.strong(state.title(key));
        ui.label(words(state, key));
        if !condition.is_empty() {
            ui.colored_label(theme::fault(ui), condition);
        }
    });
}

fn paint_key(ui: &Ui, state: &AppState, key: u8, rect: Rect, response: &Response) {
    let summary = state.store.summaries.key(key);
    let painter = ui.painter_at(rect.expand(1.0));
    let depth = (summary.position / TRAVEL).clamp(0.0, 1.0);
    let sunk = rect.with_min_y(rect.top() + depth * rect.height() * 0.12);
    let condition = state.store.conditions.key(key);
    let mut fill = fill(ui, summary, key, response);
    if *condition == KeyCondition::Absent {
        fill = theme::blend(fill, ui.visuals().panel_fill, 0.85);
    }
    // The part below the surface lies in the shadow of the neighbours.
    painter.rect_filled(rect, 2.0, theme::blend(fill, Color32::BLACK, 0.45));
    painter.rect_filled(sunk, 2.0, fill);
    paint_mode(&painter, summary, sunk);
    paint_force(&painter, state, summary, sunk);
    paint_condition(&painter.with_clip_rect(rect), condition, rect);
    let is_selected = state.view.selected == key;
    let stroke = if is_selected {
        Stroke::new(2.5, theme::selected(ui.visuals()))
    } else {
        Stroke::new(1.0, theme::faint(ui.visuals().text_color(), 0.35))
    };
    painter.rect_stroke(rect, 2.0, stroke, StrokeKind::Inside);
    if summary.fault != 0 {
        badge(&painter, pos2(rect.center().x, rect.bottom() - 16.0));
    }
}

fn fill(ui: &Ui, summary: KeySummary, key: u8, response: &Response) -> Color32 {
    let plain = match (names::is_black(key), ui.visuals().dark_mode) {
        (true, _) => Color32::from_rgb(0x2A, 0x2E, 0x35),
        (false, true) => Color32::from_rgb(0xC9, 0xCC, 0xCF),
        (false, false) => Color32::from_rgb(0xFB, 0xFA, 0xF6),
    };
    let plain = if summary.flags & NOT_RUN != 0 || summary.mode.is_none() {
        theme::blend(plain, Color32::GRAY, 0.5)
    } else {
        plain
    };
    if response.hovered() { theme::blend(plain, theme::SKY, 0.35) } else { plain }
}

/// Hatches a key whose board renders no force, and crosses a muted one.
fn paint_condition(painter: &Painter, condition: &KeyCondition, rect: Rect) {
    /// Distance of the hatches (points).
    const HATCH: f32 = 7.0;
    let stroke = Stroke::new(1.8, theme::VERMILLION);
    match condition {
        KeyCondition::Well | KeyCondition::Absent => {}
        KeyCondition::Muted => {
            painter.line_segment([rect.left_top(), rect.right_bottom()], stroke);
            painter.line_segment([rect.right_top(), rect.left_bottom()], stroke);
        }
        KeyCondition::Silent(_) => {
            let mut y = rect.top();
            while y < rect.bottom() + rect.width() {
                let ends = [pos2(rect.left(), y), pos2(rect.right(), y - rect.width())];
                painter.line_segment(ends, stroke);
                y += HATCH;
            }
        }
    }
}

fn paint_mode(painter: &Painter, summary: KeySummary, rect: Rect) {
    if let Some(mode) = summary.mode {
        let front = rect.shrink2(vec2(1.5, 0.0)).with_min_y(rect.bottom() - 7.0);
        let front = front.with_max_y(rect.bottom() - 2.0);
        painter.rect_filled(front, 1.0, theme::mode(mode));
    }
}

fn paint_force(painter: &Painter, state: &AppState, summary: KeySummary, rect: Rect) {
    let limit = state.store.catalogue.as_ref().map_or(20.0, |it| number::f32(it.force_limit));
    let share = (summary.force.abs() / limit.max(1.0)).clamp(0.0, 1.0).sqrt();
    let room = rect.height() - 22.0;
    if room < 4.0 || share < 0.02 {
        return;
    }
    let bottom = rect.bottom() - 9.0;
    let middle = rect.center().x;
    let half = (rect.width() * 0.18).max(1.5);
    let bar =
        Rect::from_min_max(pos2(middle - half, bottom - share * room), pos2(middle + half, bottom));
    let color = if summary.force < 0.0 { theme::PURPLE } else { theme::BLUE };
    painter.rect_filled(bar, 1.0, theme::blend(color, theme::VERMILLION, share * share));
}

fn badge(painter: &Painter, center: Pos2) {
    let points = vec![center + vec2(0.0, -7.0), center + vec2(6.5, 5.0), center + vec2(-6.5, 5.0)];
    let edge = Stroke::new(1.0, Color32::WHITE);
    painter.add(Shape::convex_polygon(points, theme::VERMILLION, edge));
    let font = FontId::proportional(9.0);
    painter.text(center + vec2(0.0, 0.5), Align2::CENTER_CENTER, "!", font, Color32::WHITE);
}

fn range_ui(ui: &Ui, state: &AppState, area: Rect) {
    let painter = ui.painter();
    let y = area.bottom() - 7.0;
    for key in (3..=LAST).step_by(12) {
        let x = rect(area, key).left() + 1.0;
        let font = FontId::proportional(10.0);
        painter.text(pos2(x, y), Align2::LEFT_CENTER, names::name(key), font, weak(ui));
    }
    let (low, high) = state.view.range;
    if low < high {
        let (left, right) = (rect(area, low).left(), rect(area, high).right());
        let y = area.bottom() - 13.5;
        painter.hline(left..=right, y, Stroke::new(2.5, theme::selected(ui.visuals())));
        let x = rect(area, low).left() + 26.0;
        let text = names::range_name(&state.range());
        let font = FontId::proportional(10.0);
        painter.text(
            pos2(x, area.bottom() - 6.0),
            Align2::LEFT_CENTER,
            text,
            font,
            theme::selected(ui.visuals()),
        );
    }
}

fn weak(ui: &Ui) -> Color32 {
    ui.visuals().weak_text_color()
}
