//! Position in a recording: a line to scrub, its speed, and marked moments.

use std::collections::BTreeMap;

use eframe::egui::{
    Rect, RichText, ScrollArea, Sense, Slider, Stroke, TextStyle, TextWrapMode, Ui, WidgetInfo,
    accesskit::Role, vec2,
};
use serde::{Deserialize, Serialize};
use telemetry::{Timeline, source::Mark};

use super::{nothing_ui, piece_ui};
use crate::{app_state::AppState, number, theme};

const SPEEDS: [f64; 6] = [0.01, 0.1, 0.5, 1.0, 2.0, 8.0];

/// Distance to each side within which a mark is named under the pointer (points).
const REACH: f32 = 2.0;

const LINES: usize = 12;

#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(super) struct View;

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        timeline_ui(ui, state);
    }
}

fn timeline_ui(ui: &mut Ui, state: &mut AppState) {
    let Some(timeline) = state.source.timeline() else {
        nothing_ui(ui, state, "This is live: only a recording can be wound back.");
        return;
    };
    let (from, to) = timeline.span();
    let seconds = |at: u64| at.saturating_sub(from) as f64 * 1e-9;
    let stepped = play_ui(ui, timeline, seconds);
    let clicked = line_ui(ui, timeline);
    let mut at = seconds(timeline.at());
    let length = seconds(to);
    ui.spacing_mut().slider_width = (ui.available_width() - 170.0).max(80.0);
    let slider = Slider::new(&mut at, 0.0..=length).suffix(" s").text("place").fixed_decimals(3);
    let slid = ui.add(slider).changed().then(|| from + number::floor(at * 1e9));
    let found = marks_ui(ui, timeline.marks(), from);
    if let Some(at) = stepped.or(clicked).or(slid).or(found) {
        timeline.seek(at);
        // A scope that shows another time would be empty.
        state.follow();
    }
}

fn play_ui(ui: &mut Ui, timeline: &mut dyn Timeline, seconds: impl Fn(u64) -> f64) -> Option<u64> {
    let mut target = None;
    ui.horizontal_wrapped(|ui| {
        let (first, last) = timeline.span();
        let is_over = last <= timeline.at();
        let plays = 0.0 < timeline.speed() && !is_over;
        if ui.button(if plays { "Pause" } else { "Play" }).clicked() {
            timeline.set_speed(if plays { 0.0 } else { 1.0 });
            target = is_over.then_some(first);
        }
        for speed in SPEEDS {
            let is_it = (timeline.speed() - speed).abs() < 1e-9;
            if ui.selectable_label(is_it, format!("{speed}×")).clicked() {
                timeline.set_speed(speed);
            }
        }
        for (text, step) in [("- 1 s", -1.0), ("- 10 ms", -0.01), ("+ 10 ms", 0.01), ("+ 1 s", 1.0)]
        {
            if ui.small_button(text).clicked() {
                target = Some(stepped(timeline, step));
            }
        }
        let place = format!("{:.3} s of {:.1} s", seconds(timeline.at()), seconds(last));
        piece_ui(ui, RichText::new(place).weak());
    });
    target
}

fn stepped(timeline: &dyn Timeline, seconds: f64) -> u64 {
    let by = number::floor(seconds.abs() * 1e9);
    let at = timeline.at();
    let to = if seconds < 0.0 { at.saturating_sub(by) } else { at.saturating_add(by) };
    let (first, last) = timeline.span();
    to.clamp(first, last)
}

/// Draws the recording as a line; returns the position of a click or a drag.
fn line_ui(ui: &mut Ui, timeline: &dyn Timeline) -> Option<u64> {
    let size = vec2(ui.available_width(), 26.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::ScrollBar, true, "time line"));
    let (from, to) = timeline.span();
    let length = to.saturating_sub(from).max(1) as f64;
    let share = |at: u64| number::f32(at.saturating_sub(from) as f64 / length);
    let x = |at: u64| rect.left() + share(at) * rect.width();
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 3.0, ui.visuals().extreme_bg_color);
    let here = x(timeline.at());
    let gone = Rect::from_min_max(rect.min, eframe::egui::pos2(here, rect.bottom()));
    painter.rect_filled(gone, 3.0, theme::faint(theme::SKY, 0.25));
    // One line for each point of the width; a fault is never below another mark.
    let mut columns = BTreeMap::new();
    for mark in timeline.marks() {
        let is_fault = columns.entry(number::index((x(mark.at) - rect.left()).into())).or_default();
        *is_fault |= mark.is_fault;
    }
    for (column, is_fault) in columns {
        let x = rect.left() + number::f32(number::f64(column));
        let color = if is_fault { theme::VERMILLION } else { theme::GREEN };
        painter.vline(x, rect.y_range(), Stroke::new(1.5, color));
    }
    painter.vline(here, rect.y_range(), Stroke::new(2.0, ui.visuals().strong_text_color()));
    if let Some(at) = response.hover_pos() {
        let is_near = |mark: &&Mark| (x(mark.at) - at.x).abs() <= REACH;
        let near: Vec<_> = timeline.marks().iter().filter(is_near).collect();
        if !near.is_empty() {
            response.clone().on_hover_text_at_pointer(summary(&near));
        }
    }
    let is_moved = response.dragged() || response.clicked();
    response.interact_pointer_pos().filter(|_| is_moved).map(|at| {
        let share = f64::from(((at.x - rect.left()) / rect.width()).clamp(0.0, 1.0));
        from + number::floor(share * length)
    })
}

fn summary(marks: &[&Mark]) -> String {
    let mut counts: Vec<(&str, usize)> = Vec::new();
    let mut others = 0;
    for mark in marks {
        match counts.iter().position(|(text, _)| *text == mark.text) {
            Some(i) => counts[i].1 += 1,
            None if counts.len() < LINES => counts.push((&mark.text, 1)),
            None => others += 1,
        }
    }
    let lines = counts.into_iter().map(|(text, count)| match count {
        1 => text.to_owned(),
        _ => format!("{text} × {count}"),
    });
    lines.chain((0 < others).then(|| format!("and {others} more"))).collect::<Vec<_>>().join("\n")
}

fn marks_ui(ui: &mut Ui, marks: &[Mark], from: u64) -> Option<u64> {
    let mut clicked = None;
    let height = ui.text_style_height(&TextStyle::Monospace);
    let area = ScrollArea::vertical().auto_shrink(false);
    area.show_rows(ui, height, marks.len(), |ui, rows| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
        for mark in &marks[rows.start.min(marks.len())..rows.end.min(marks.len())] {
            let at = mark.at.saturating_sub(from) as f64 * 1e-9;
            let color = if mark.is_fault { theme::fault(ui) } else { ui.visuals().text_color() };
            let text = RichText::new(format!("{at:8.3} s  {}", mark.text)).monospace();
            if ui.link(text.color(color)).on_hover_text(&mark.text).clicked() {
                clicked = Some(mark.at);
            }
        }
    });
    clicked
}
