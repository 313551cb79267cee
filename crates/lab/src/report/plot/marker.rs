//! Marks of curves: the same curve has the same mark in every panel.

use plotters::style::RGBColor;

use super::canvas::{Canvas, DrawError, PAPER, Pixel};
use super::curve::Style;

/// The shape of a mark.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Shape {
    Circle,
    Square,
    Up,
    Diamond,
    Down,
    Left,
    Right,
    Tall,
}

impl Shape {
    /// Eight, beside seven colours: that makes 56 pairs.
    pub(super) const ALL: [Self; 8] = [
        Self::Circle,
        Self::Square,
        Self::Up,
        Self::Diamond,
        Self::Down,
        Self::Left,
        Self::Right,
        Self::Tall,
    ];

    /// Its corners around the origin, in half widths; none for a circle.
    const fn corners(self) -> &'static [Pixel] {
        match self {
            Self::Circle => &[],
            Self::Square => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
            Self::Up => &[(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)],
            Self::Diamond => &[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
            Self::Down => &[(0.0, 1.2), (1.1, -0.8), (-1.1, -0.8)],
            Self::Left => &[(-1.2, 0.0), (0.8, 1.1), (0.8, -1.1)],
            Self::Right => &[(1.2, 0.0), (-0.8, 1.1), (-0.8, -1.1)],
            Self::Tall => &[(-0.45, -1.3), (0.45, -1.3), (0.45, 1.3), (-0.45, 1.3)],
        }
    }
}

/// Half a mark's width (pixels).
const SIZE: f64 = 3.6;

/// Draws the mark of a curve.
pub(super) fn draw(canvas: &Canvas<'_>, at: Pixel, style: &Style) -> Result<(), DrawError> {
    let fill = if style.is_peer { PAPER } else { style.color };
    let corners = style.shape.corners();
    if corners.is_empty() {
        return canvas.circle(at, SIZE, fill, style.color);
    }
    let corners: Vec<_> = corners.iter().map(|(x, y)| (at.0 + SIZE * x, at.1 + SIZE * y)).collect();
    canvas.polygon(&corners, fill, style.color)
}

/// Draws the mark of a run whose events were wrong.
pub(super) fn draw_failure(
    canvas: &Canvas<'_>,
    at: Pixel,
    color: RGBColor,
) -> Result<(), DrawError> {
    let (x, y) = at;
    let r = SIZE;
    canvas.line(&[(x - r, y - r), (x + r, y + r)], color, 1.6)?;
    canvas.line(&[(x - r, y + r), (x + r, y - r)], color, 1.6)
}
