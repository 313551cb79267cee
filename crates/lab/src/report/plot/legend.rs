//! Which curve is what.

use super::canvas::{Anchor, Canvas, DrawError};
use super::curve::Curve;
use super::{marker, place};

/// Size of the text (pixels).
const TEXT: f64 = 11.5;
/// From one line to the next (pixels).
const ROW: f64 = 20.0;
/// Length of a sample of a curve (pixels).
const SAMPLE: f64 = 30.0;
/// Longest name (characters); the end of a longer one is left out.
const LONGEST: usize = 44;

/// Draws the legend beside the panels.
pub(super) fn draw(canvas: &Canvas<'_>, curves: &[Curve]) -> Result<(), DrawError> {
    let left = place::LEGEND;
    for (row, curve) in curves.iter().enumerate() {
        let (y, style) = (height(row), &curve.style);
        let ends = [(left, y), (left + SAMPLE, y)];
        if style.is_peer {
            canvas.dashes(ends, style.color, style.width)?;
        } else {
            canvas.line(&ends, style.color, style.width)?;
        }
        marker::draw(canvas, (left + 0.5 * SAMPLE, y), style)?;
        canvas.text(&short(&curve.name), (left + SAMPLE + 8.0, y), TEXT, Anchor::Start)?;
    }
    let y = height(curves.len());
    let color = super::canvas::INK;
    marker::draw_failure(canvas, (left + 0.5 * SAMPLE, y), color)?;
    canvas.text("wrong events, or no end", (left + SAMPLE + 8.0, y), TEXT, Anchor::Start)
}

/// Where the legend ends (pixels).
pub(super) fn bottom(curves: &[Curve]) -> f64 {
    height(curves.len() + 1)
}

fn height(row: usize) -> f64 {
    ROW * row as f64 + place::TOP + 8.0
}

fn short(name: &str) -> String {
    if name.chars().count() <= LONGEST {
        return name.to_owned();
    }
    name.chars().take(LONGEST - 1).chain(['…']).collect()
}
