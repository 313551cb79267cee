//! Lines, areas and text at places in pixels.

use std::io;

use plotters::coord::Shift;
use plotters::prelude::{
    Circle, DrawingArea, DrawingAreaErrorKind, FontTransform, IntoDrawingArea as _, IntoFont as _,
    PathElement, Polygon, RGBColor, Rectangle, SVGBackend, Text, TextStyle, WHITE,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color as _, ShapeStyle};

/// A place in pixels, from the upper left corner.
pub(super) type Pixel = (f64, f64);
/// Why something could not be drawn.
pub(in crate::report) type DrawError = DrawingAreaErrorKind<io::Error>;

pub(super) const INK: RGBColor = RGBColor(40, 40, 40);
pub(super) const GRID: RGBColor = RGBColor(222, 222, 222);
pub(super) const PAPER: RGBColor = WHITE;

/// The library's units are whole; this many are a pixel.
const UNITS: f64 = 4.0;

/// How text stands to its place; its height is always centred there.
#[derive(Clone, Copy, Debug)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// What is drawn on.
pub(super) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

/// A picture of `size` (pixels) as SVG text.
pub(super) fn svg(
    size: (f64, f64),
    draw: impl FnOnce(&Canvas<'_>) -> Result<(), DrawError>,
) -> Result<String, DrawError> {
    let mut text = String::new();
    let [width, height] = [size.0, size.1].map(units).map(i32::unsigned_abs);
    let canvas =
        Canvas { area: SVGBackend::with_string(&mut text, (width, height)).into_drawing_area() };
    canvas.area.fill(&PAPER)?;
    draw(&canvas)?;
    canvas.area.present()?;
    drop(canvas);
    // Drawn in units, shown in pixels and never wider than the page.
    let drawn = format!("width=\"{width}\" height=\"{height}\"");
    let shown = format!(
        "width=\"{:.0}\" height=\"{:.0}\" style=\"max-width:100%;height:auto\"",
        size.0, size.1
    );
    Ok(text.replacen(&drawn, &shown, 1))
}

impl Canvas<'_> {
    /// A line of `width` through `places`.
    pub(super) fn line(
        &self,
        places: &[Pixel],
        color: RGBColor,
        width: f64,
    ) -> Result<(), DrawError> {
        let places: Vec<_> = places.iter().copied().map(point).collect();
        self.area.draw(&PathElement::new(places, stroke(color, width)))
    }

    /// A line from `a` to `b` in dashes.
    pub(super) fn dashes(
        &self,
        [a, b]: [Pixel; 2],
        color: RGBColor,
        width: f64,
    ) -> Result<(), DrawError> {
        /// A dash and a gap.
        const PERIOD: f64 = 7.0;
        const DASH: f64 = 0.6;
        let along = |part: f64| (a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1));
        let n = ((b.0 - a.0).hypot(b.1 - a.1) / PERIOD).max(1.0).floor();
        let starts = (0_u32..).map(f64::from).take_while(|dash| *dash < n);
        for dash in starts {
            self.line(&[along(dash / n), along((dash + DASH) / n)], color, width)?;
        }
        Ok(())
    }

    /// A filled rectangle between two corners.
    pub(super) fn fill(&self, corners: [Pixel; 2], color: RGBColor) -> Result<(), DrawError> {
        self.area.draw(&Rectangle::new(corners.map(point), color.filled()))
    }

    /// A disc or a ring.
    pub(super) fn circle(
        &self,
        at: Pixel,
        radius: f64,
        fill: RGBColor,
        edge: RGBColor,
    ) -> Result<(), DrawError> {
        let size = units(radius).unsigned_abs();
        self.area.draw(&Circle::new(point(at), size, fill.filled()))?;
        self.area.draw(&Circle::new(point(at), size, stroke(edge, 1.2)))
    }

    /// A polygon with an edge.
    pub(super) fn polygon(
        &self,
        corners: &[Pixel],
        fill: RGBColor,
        edge: RGBColor,
    ) -> Result<(), DrawError> {
        let mut places: Vec<_> = corners.iter().copied().map(point).collect();
        self.area.draw(&Polygon::new(places.clone(), fill.filled()))?;
        places.extend(places.first().copied());
        self.area.draw(&PathElement::new(places, stroke(edge, 1.2)))
    }

    /// Writes `text` of `size`.
    pub(super) fn text(
        &self,
        text: &str,
        at: Pixel,
        size: f64,
        anchor: Anchor,
    ) -> Result<(), DrawError> {
        /// The library's letters are smaller than they are asked to be.
        const SHRINKS: f64 = 1.24;
        let along = match anchor {
            Anchor::Start => HPos::Left,
            Anchor::Middle => HPos::Center,
            Anchor::End => HPos::Right,
        };
        let font = ("sans-serif", units(size * SHRINKS)).into_font().transform(FontTransform::None);
        let style = TextStyle::from(font).color(&INK).pos(Pos::new(along, VPos::Center));
        self.area.draw(&Text::new(text.to_owned(), point(at), style))
    }
}

fn stroke(color: RGBColor, width: f64) -> ShapeStyle {
    color.stroke_width(units(width).unsigned_abs())
}

fn point((x, y): Pixel) -> (i32, i32) {
    (units(x), units(y))
}

#[expect(clippy::cast_possible_truncation, reason = "a place in the picture")]
fn units(pixels: f64) -> i32 {
    (pixels * UNITS).round() as i32
}
