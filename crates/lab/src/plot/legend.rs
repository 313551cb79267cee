//! Which curve is what: a sample of each with its name.

use super::canvas::{Anchor, Canvas, Pixel};
use super::color::Stroke;

/// Size of the text (pixels).
const TEXT: f64 = 12.0;
/// From one row to the next (pixels).
pub const ROW: f64 = 19.0;
/// Length of a sample (pixels).
const SAMPLE: f64 = 28.0;
/// From a sample to its name (pixels).
const GAP: f64 = 8.0;
/// Longest name (characters); the end of a longer one is left out.
const LONGEST: usize = 44;

/// Draws a sample of a curve that begins at `at`, and its name; returns the sample's middle.
pub fn draw_row(canvas: &mut Canvas, at: Pixel, stroke: Stroke, name: &str) -> Pixel {
    canvas.line(&[at, (at.0 + SAMPLE, at.1)], stroke);
    draw_name(canvas, at, name)
}

/// Draws the name beside a sample that begins at `at`; returns the sample's middle.
pub fn draw_name(canvas: &mut Canvas, at: Pixel, name: &str) -> Pixel {
    canvas.text(&short(name), (at.0 + SAMPLE + GAP, at.1), TEXT, Anchor::Start);
    (at.0 + 0.5 * SAMPLE, at.1)
}

fn short(name: &str) -> String {
    if name.chars().count() <= LONGEST {
        return name.to_owned();
    }
    name.chars().take(LONGEST - 1).chain(['…']).collect()
}
