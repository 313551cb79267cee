//! What stands above the panels: the band of modes, and the events with their names.

use plotters::style::{Color as _, RGBColor};

use super::super::Picture;
use super::super::epoch::Epoch;
use super::canvas::{Anchor, Canvas, DrawError, INK, fill, line, write};
use super::{across, place, shade};

/// Size of the text (pixels).
const TEXT: f64 = 12.0;
/// Size of the events' names (pixels).
const SMALL: f64 = 11.0;
/// Between two names of events (pixels).
const APART: f64 = 14.0;
/// How far a name may be from its event (pixels).
const ASTRAY: f64 = 42.0;
/// Events' lines.
const EVENT: RGBColor = RGBColor(90, 90, 90);
/// More events than this become fainter, so that the curves are seen through them.
const CROWD: f64 = 60.0;
/// The faintest that lines of events become.
const FAINTEST: f64 = 0.12;

/// Draws the band of modes, and the events over everything but the modes' names.
pub(super) fn draw(canvas: &Canvas<'_>, picture: &Picture) -> Result<(), DrawError> {
    let (top, bottom) = place::BAND;
    for epoch in &picture.epochs.all {
        let [start, end] = span(picture, epoch);
        fill(canvas, [(start, top), (end, bottom)], shade(epoch.mode))?;
    }
    draw_events(canvas, picture)?;
    picture.epochs.all.iter().try_for_each(|epoch| draw_name(canvas, picture, epoch))?;
    draw_modes(canvas, picture)
}

/// Writes a mode's name into its epoch, where it fits.
fn draw_name(canvas: &Canvas<'_>, picture: &Picture, epoch: &Epoch) -> Result<(), DrawError> {
    let ([start, end], (top, bottom)) = (span(picture, epoch), place::BAND);
    let name = picture.modes[epoch.mode];
    let half = 0.5 * width(name);
    let (x, y) = (f64::midpoint(start, end), f64::midpoint(top, bottom));
    if start > x - half {
        return Ok(());
    }
    fill(canvas, [(x - half, top), (x + half, bottom)], shade(epoch.mode))?;
    write(canvas, name, (x, y), TEXT, Anchor::Middle)
}

/// Draws what the shades mean.
fn draw_modes(canvas: &Canvas<'_>, picture: &Picture) -> Result<(), DrawError> {
    let seen = |mode: &usize| picture.epochs.all.iter().any(|epoch| epoch.mode == *mode);
    for (row, mode) in (0..picture.modes.len()).filter(seen).enumerate() {
        let y = 18.0 * row as f64 + 100.0;
        let left = place::LEGEND;
        fill(canvas, [(left, y - 7.0), (left + 24.0, y + 7.0)], shade(mode))?;
        let text = format!("mode {}", picture.modes[mode]);
        write(canvas, &text, (left + 32.0, y), TEXT, Anchor::Start)?;
    }
    Ok(())
}

/// Draws the events' lines and names.
fn draw_events(canvas: &Canvas<'_>, picture: &Picture) -> Result<(), DrawError> {
    let (top, bottom) = (place::BAND.0, place::PANELS[2].1);
    let marks = &picture.marks.all;
    let color = EVENT.mix((CROWD / marks.len() as f64).clamp(FAINTEST, 1.0));
    for mark in marks {
        let x = across(picture, mark.t);
        line(canvas, &[(x, top), (x, bottom)], color, 1.0)?;
    }
    for label in picture.marks.labels(APART, ASTRAY) {
        let (x, aside) = (across(picture, label.t), place::LEFT + label.place);
        line(canvas, &[(x, top), (aside, place::NAMES + 2.0)], INK, 0.5)?;
        write(canvas, &label.text, (aside, place::NAMES), SMALL, Anchor::Rising)?;
    }
    Ok(())
}

/// Where an epoch begins and ends (pixels).
fn span(picture: &Picture, epoch: &Epoch) -> [f64; 2] {
    [epoch.span.0, epoch.span.1].map(|t| across(picture, t))
}

/// About the width of a text, with room at both ends (pixels).
fn width(text: &str) -> f64 {
    text.chars().count() as f64 * 0.62 * TEXT + 6.0
}
