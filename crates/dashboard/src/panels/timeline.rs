//! Position in a recording: a line to scrub, its speed, and marked moments.

use eframe::egui::{
    Color32, Rect, RichText, ScrollArea, Sense, Slider, Stroke, Ui, WidgetInfo, accesskit::Role,
    vec2,
};
use serde::{Deserialize, Serialize};
use telemetry::Timeline;
use telemetry::source::Mark;

use super::{nothing_ui, piece_ui};
use crate::app_state::AppState;
use crate::{number, theme};

/// Speeds to choose from.
const SPEEDS: [f64; 6] = [0.01, 0.1, 0.5, 1.0, 2.0, 8.0];

#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(super) struct View;

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        timeline_ui(ui, state);
    }
}

fn timeline_ui(ui: &mut Ui, state: &mut AppState) {
    let Some(timeline) = state.source.timeline() else {
        nothing_ui(ui, "This is live: only a recording can be wound back.");
        return;
    };
    let (from, to) = timeline.span();
    let seconds = |at: u64| at.saturating_sub(from) as f64 * 1e-9;
    play_ui(ui, timeline, seconds);
    line_ui(ui, timeline);
    let mut at = seconds(timeline.at());
    let length = seconds(to);
    ui.spacing_mut().slider_width = (ui.available_width() - 170.0).max(80.0);
    let slider = Slider::new(&mut at, 0.0..=length).suffix(" s").text("place").fixed_decimals(3);
    if ui.add(slider).changed() {
        timeline.seek(from + number::floor(at * 1e9));
    }
    marks_ui(ui, timeline, from);
}

fn play_ui(ui: &mut Ui, timeline: &mut dyn Timeline, seconds: impl Fn(u64) -> f64) {
    ui.horizontal_wrapped(|ui| {
        let plays = 0.0 < timeline.speed();
        if ui.button(if plays { "Pause" } else { "Play" }).clicked() {
            timeline.set_speed(if plays { 0.0 } else { 1.0 });
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
                step_by(timeline, step);
            }
        }
        let (_, to) = timeline.span();
        let place = format!("{:.3} s of {:.1} s", seconds(timeline.at()), seconds(to));
        piece_ui(ui, RichText::new(place).weak());
    });
}

/// Moves by so many seconds, forward or back.
fn step_by(timeline: &mut dyn Timeline, seconds: f64) {
    let by = number::floor(seconds.abs() * 1e9);
    let at = timeline.at();
    let to = if seconds < 0.0 { at.saturating_sub(by) } else { at.saturating_add(by) };
    let (first, last) = timeline.span();
    timeline.seek(to.clamp(first, last));
}

/// Draws the whole recording as a line; a click or a drag moves there.
fn line_ui(ui: &mut Ui, timeline: &mut dyn Timeline) {
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
    for mark in timeline.marks() {
        painter.vline(x(mark.at), rect.y_range(), Stroke::new(2.0, color(mark)));
    }
    painter.vline(here, rect.y_range(), Stroke::new(2.0, ui.visuals().strong_text_color()));
    if (response.dragged() || response.clicked())
        && let Some(at) = response.interact_pointer_pos()
    {
        let share = f64::from(((at.x - rect.left()) / rect.width()).clamp(0.0, 1.0));
        timeline.seek(from + number::floor(share * length));
    }
}

const fn color(mark: &Mark) -> Color32 {
    if mark.is_fault { theme::VERMILLION } else { theme::GREEN }
}

fn marks_ui(ui: &mut Ui, timeline: &mut dyn Timeline, from: u64) {
    let mut clicked = None;
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for mark in timeline.marks() {
            let at = mark.at.saturating_sub(from) as f64 * 1e-9;
            let color = if mark.is_fault { theme::fault(ui) } else { ui.visuals().text_color() };
            let text = RichText::new(format!("{at:8.3} s  {}", mark.text));
            if ui.link(text.monospace().color(color)).clicked() {
                clicked = Some(mark.at);
            }
        }
    });
    if let Some(at) = clicked {
        timeline.seek(at);
    }
}
