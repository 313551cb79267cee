//! The legend beside the panels: each curve, and what a cross means.

use super::curve::CostErrorCurve;
use super::{marker, place};
use crate::plot::canvas::{Canvas, Pixel};
use crate::plot::color::INK;
use crate::plot::legend::{ROW, draw_name, draw_row};

/// Draws one entry for each method.
pub(super) fn draw(canvas: &mut Canvas, curves: &[CostErrorCurve]) {
    for (row, curve) in curves.iter().enumerate() {
        let middle = draw_row(canvas, corner(row), curve.style.stroke, &curve.name);
        marker::draw(canvas, middle, &curve.style);
    }
    let middle = draw_name(canvas, corner(curves.len()), "wrong events, or no end");
    marker::draw_failure(canvas, middle, INK);
}

/// Where the legend ends (pixels).
pub(super) fn bottom(curves: &[CostErrorCurve]) -> f64 {
    corner(curves.len() + 1).1
}

/// Where a row begins.
fn corner(row: usize) -> Pixel {
    (place::LEGEND, ROW * row as f64 + place::TOP + 8.0)
}
