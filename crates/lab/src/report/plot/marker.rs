//! How a curve and its marks look: the same in every panel.

use crate::plot::canvas::{Canvas, Pixel};
use crate::plot::color::{Color, PAPER, Stroke};

/// How a curve is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct CurveStyle {
    pub(super) shape: MarkerShape,
    pub(super) stroke: Stroke,
}

impl CurveStyle {
    /// Whether the curve is another code's: dashed, with hollow marks.
    pub(super) const fn is_peer(&self) -> bool {
        self.stroke.is_dashed
    }
}

/// The shape of a mark.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum MarkerShape {
    Circle,
    Square,
    Up,
    Diamond,
    Down,
    Left,
    Right,
    Tall,
}

impl MarkerShape {
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

/// Width of a mark's edge (pixels).
const EDGE: f64 = 1.2;

/// Draws the mark of a curve.
pub(super) fn draw(canvas: &mut Canvas, at: Pixel, style: &CurveStyle) {
    let color = style.stroke.color;
    let (fill, edge) = (if style.is_peer() { PAPER } else { color }, Stroke::new(color, EDGE));
    let corners = style.shape.corners();
    if corners.is_empty() {
        canvas.circle(at, SIZE, fill, edge);
    } else {
        let corner = |(x, y): &Pixel| (at.0 + SIZE * x, at.1 + SIZE * y);
        canvas.polygon(&corners.iter().map(corner).collect::<Vec<_>>(), fill, edge);
    }
}

/// Draws the mark of a run whose events were wrong.
pub(super) fn draw_failure(canvas: &mut Canvas, (x, y): Pixel, color: Color) {
    let (r, stroke) = (SIZE, Stroke::new(color, 1.6));
    canvas.line(&[(x - r, y - r), (x + r, y + r)], stroke);
    canvas.line(&[(x - r, y + r), (x + r, y - r)], stroke);
}
