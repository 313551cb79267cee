//! Lines, areas and text at places in pixels.

use std::io;

use plotters::coord::Shift;
use plotters::prelude::{
    DrawingArea, DrawingAreaErrorKind, FontTransform, IntoFont as _, PathElement, RGBColor,
    Rectangle, SVGBackend, Text, TextStyle,
};
use plotters::style::Color;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Where is drawn.
pub(super) type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// Why something could not be drawn.
pub(super) type DrawError = DrawingAreaErrorKind<io::Error>;

/// Drawing units per pixel: units are whole numbers, and curves are finer than pixels.
pub(super) const FINE: u32 = 4;

pub(super) const INK: RGBColor = RGBColor(40, 40, 40);

/// Pixels in drawing units.
#[expect(clippy::cast_possible_truncation, reason = "a place in the picture")]
pub(super) fn fine(pixels: f64) -> i32 {
    (pixels * f64::from(FINE)).round() as i32
}

/// Not negative pixels in drawing units.
pub(super) fn fine_size(pixels: f64) -> u32 {
    fine(pixels).unsigned_abs()
}

/// Text of `size` pixels.
pub(super) fn font(size: f64) -> TextStyle<'static> {
    /// The library draws text smaller than it is told.
    const SHRINKS: f64 = 1.24;
    TextStyle::from(("sans-serif", fine_size(size * SHRINKS)).into_font()).color(&INK)
}

/// How text stands to its place.
#[derive(Clone, Copy, Debug)]
pub(super) enum Anchor {
    Start,
    /// Has its middle there.
    Middle,
    Rising,
    /// Rises, with its middle there.
    Upright,
}

/// Writes `text` of `size` at a height centred on `place` (all in pixels).
pub(super) fn write(
    canvas: &Canvas<'_>,
    text: &str,
    place: (f64, f64),
    size: f64,
    anchor: Anchor,
) -> Result<(), DrawError> {
    let (along, turn) = match anchor {
        Anchor::Start => (HPos::Left, FontTransform::None),
        Anchor::Middle => (HPos::Center, FontTransform::None),
        Anchor::Rising => (HPos::Left, FontTransform::Rotate270),
        Anchor::Upright => (HPos::Center, FontTransform::Rotate270),
    };
    let style = font(size).pos(Pos::new(along, VPos::Center)).transform(turn);
    canvas.draw(&Text::new(text, (fine(place.0), fine(place.1)), style))
}

/// Draws a line of `width` through `places` (pixels).
pub(super) fn line(
    canvas: &Canvas<'_>,
    places: &[(f64, f64)],
    color: impl Color,
    width: f64,
) -> Result<(), DrawError> {
    let places: Vec<_> = places.iter().map(|(x, y)| (fine(*x), fine(*y))).collect();
    canvas.draw(&PathElement::new(places, color.stroke_width(fine_size(width))))
}

/// Fills the rectangle between two corners (pixels).
pub(super) fn fill(
    canvas: &Canvas<'_>,
    corners: [(f64, f64); 2],
    color: RGBColor,
) -> Result<(), DrawError> {
    let corners = corners.map(|(x, y)| (fine(x), fine(y)));
    canvas.draw(&Rectangle::new(corners, color.filled()))
}
