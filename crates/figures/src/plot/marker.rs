//! Marks of points, which differ in shape as well as colour.

use super::canvas::{Canvas, Pixel};
use super::color::{Color, PAPER, Stroke};

/// Shape of a mark.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MarkerShape {
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
    /// All eight; with seven colours they make 56 pairs.
    pub const ALL: [Self; 8] = [
        Self::Circle,
        Self::Square,
        Self::Up,
        Self::Diamond,
        Self::Down,
        Self::Left,
        Self::Right,
        Self::Tall,
    ];

    /// Returns the corners around the origin, in half widths; none for a circle.
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
const SIZE: f64 = 3.2;

/// Width of a mark's edge (pixels).
const EDGE: f64 = 1.2;

pub(super) fn draw(canvas: &mut Canvas, at: Pixel, shape: MarkerShape, stroke: Stroke) {
    let Stroke { color, is_dashed, .. } = stroke;
    let (fill, edge) = (if is_dashed { PAPER } else { color }, Stroke::new(color, EDGE));
    let corners = shape.corners();
    if corners.is_empty() {
        canvas.circle(at, SIZE, fill, edge);
    } else {
        let corner = |(x, y): &Pixel| (at.0 + SIZE * x, at.1 + SIZE * y);
        canvas.polygon(&corners.iter().map(corner).collect::<Vec<_>>(), fill, edge);
    }
}

pub(super) fn draw_failure(canvas: &mut Canvas, (x, y): Pixel, color: Color) {
    let (r, stroke) = (SIZE, Stroke::new(color, 1.6));
    canvas.line(&[(x - r, y - r), (x + r, y + r)], stroke);
    canvas.line(&[(x - r, y + r), (x + r, y - r)], stroke);
}
