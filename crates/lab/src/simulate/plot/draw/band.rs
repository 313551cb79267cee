//! What stands above the panels: the band of modes, and the events with their names.

use super::super::epoch::Epoch;
use super::super::picture::Picture;
use super::{place, shade, time};
use crate::plot::canvas::{Anchor, Canvas};
use crate::plot::color::{Color, INK, Stroke};

/// Size of the text (pixels).
const TEXT: f64 = 12.0;
/// Size of the events' names (pixels).
const SMALL: f64 = 11.0;
/// Between two names of events (pixels).
const APART: f64 = 14.0;
/// How far a name may be from its event (pixels).
const ASTRAY: f64 = 42.0;
/// Events' lines.
const EVENT: Stroke = Stroke::new(Color(90, 90, 90), 1.0);
/// From the name of an event to its line.
const LEADER: Stroke = Stroke::new(INK, 0.5);
/// More events than this become fainter, so that the curves are seen through them.
const CROWD: f64 = 60.0;
/// The faintest that lines of events become.
const FAINTEST: f64 = 0.12;

/// Draws the band of modes, and the events over everything but the modes' names.
pub(super) fn draw(canvas: &mut Canvas, picture: &Picture) {
    let (top, bottom) = place::BAND;
    for epoch in &picture.epochs.all {
        let [start, end] = span(picture, epoch);
        canvas.fill([(start, top), (end, bottom)], shade(epoch.mode));
    }
    draw_events(canvas, picture);
    picture.epochs.all.iter().for_each(|epoch| draw_name(canvas, picture, epoch));
    draw_modes(canvas, picture);
}

/// Writes a mode's name into its epoch, where it fits.
fn draw_name(canvas: &mut Canvas, picture: &Picture, epoch: &Epoch) {
    let ([start, end], (top, bottom)) = (span(picture, epoch), place::BAND);
    let name = picture.modes[epoch.mode];
    let half = 0.5 * width(name);
    let (x, y) = (f64::midpoint(start, end), f64::midpoint(top, bottom));
    if start <= x - half {
        canvas.fill([(x - half, top), (x + half, bottom)], shade(epoch.mode));
        canvas.text(name, (x, y), TEXT, Anchor::Middle);
    }
}

/// Draws what the shades mean.
fn draw_modes(canvas: &mut Canvas, picture: &Picture) {
    let seen = |mode: &usize| picture.epochs.all.iter().any(|epoch| epoch.mode == *mode);
    for (row, mode) in (0..picture.modes.len()).filter(seen).enumerate() {
        let y = 18.0 * row as f64 + 100.0;
        let left = place::LEGEND;
        canvas.fill([(left, y - 7.0), (left + 28.0, y + 7.0)], shade(mode));
        let text = format!("mode {}", picture.modes[mode]);
        canvas.text(&text, (left + 36.0, y), TEXT, Anchor::Start);
    }
}

/// Draws the events' lines and names.
fn draw_events(canvas: &mut Canvas, picture: &Picture) {
    let (top, bottom) = (place::BAND.0, place::PANELS[2].1);
    let (marks, time) = (&picture.marks.all, time(picture));
    let stroke = EVENT.faint((CROWD / marks.len() as f64).clamp(FAINTEST, 1.0));
    for mark in marks {
        let x = time.place(mark.t);
        canvas.line(&[(x, top), (x, bottom)], stroke);
    }
    for label in picture.marks.labels(APART, ASTRAY) {
        let (x, aside) = (time.place(label.t), place::LEFT + label.place);
        canvas.line(&[(x, top), (aside, place::NAMES + 2.0)], LEADER);
        canvas.text(&label.text, (aside, place::NAMES), SMALL, Anchor::Rising);
    }
}

/// Where an epoch begins and ends (pixels).
fn span(picture: &Picture, epoch: &Epoch) -> [f64; 2] {
    let time = time(picture);
    [epoch.span.0, epoch.span.1].map(|t| time.place(t))
}

/// About the width of a text, with room at both ends (pixels).
fn width(text: &str) -> f64 {
    text.chars().count() as f64 * 0.62 * TEXT + 6.0
}
