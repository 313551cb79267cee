//! One pair of axes: curves of error against cost, and above them the runs that failed.

use super::axis::Axis;
use super::canvas::{Anchor, Canvas, DrawError, GRID, INK, Pixel};
use super::curve::Curve;
use super::marker;
use super::place;
use super::quantity::{CostErrorPoint, Quantities};

/// Size of the text (pixels).
const TEXT: f64 = 11.0;
/// Height of the strip above the axes in which failures are marked (pixels).
const STRIP: f64 = 18.0;
/// The strip's colour.
const WRONG: plotters::style::RGBColor = plotters::style::RGBColor(251, 232, 228);

/// Axes, and what is drawn between them.
#[derive(Debug)]
pub(super) struct Panel<'a> {
    quantities: &'a Quantities,
    curves: &'a [Curve],
    /// Upper left corner, strip included.
    corner: Pixel,
    x: Axis,
    y: Axis,
}

impl<'a> Panel<'a> {
    pub(super) fn new(quantities: &'a Quantities, curves: &'a [Curve], corner: Pixel) -> Self {
        let points = || curves.iter().flat_map(|curve| &curve.points);
        let (width, height) = place::PANEL;
        // Failures have a cost too: they count for the scale of x.
        let x = Axis::new(points().filter_map(quantities.x), (corner.0, corner.0 + width));
        let ends = (corner.1 + height, corner.1 + STRIP);
        let y = Axis::new(points().filter_map(quantities.y), ends);
        Self { quantities, curves, corner, x, y }
    }

    pub(super) fn draw(&self, canvas: &Canvas<'_>) -> Result<(), DrawError> {
        self.draw_grid(canvas)?;
        self.draw_titles(canvas)?;
        for curve in self.curves {
            self.draw_curve(canvas, curve)?;
        }
        Ok(())
    }

    fn draw_grid(&self, canvas: &Canvas<'_>) -> Result<(), DrawError> {
        let (left, top) = self.corner;
        let (right, bottom) = (left + place::PANEL.0, top + place::PANEL.1);
        let axes_top = top + STRIP;
        canvas.fill([(left, top), (right, axes_top)], WRONG)?;
        canvas.text("wrong", (left - 6.0, top + 0.5 * STRIP), TEXT, Anchor::End)?;
        for line in self.x.lines(8.0) {
            canvas.line(&[(line.place, axes_top), (line.place, bottom)], GRID, 0.75)?;
            if let Some(label) = line.label {
                canvas.text(&label, (line.place, bottom + 11.0), TEXT, Anchor::Middle)?;
            }
        }
        for line in self.y.lines(8.0) {
            canvas.line(&[(left, line.place), (right, line.place)], GRID, 0.75)?;
            // Not where it would run into the strip's name.
            if let Some(label) = line.label.filter(|_| line.place > axes_top + 0.5 * TEXT) {
                canvas.text(&label, (left - 6.0, line.place), TEXT, Anchor::End)?;
            }
        }
        let frame = [(left, axes_top), (left, bottom), (right, bottom)];
        canvas.line(&frame, INK, 1.0)
    }

    fn draw_titles(&self, canvas: &Canvas<'_>) -> Result<(), DrawError> {
        let (left, top) = self.corner;
        let (width, height) = place::PANEL;
        let below = (left + 0.5 * width, top + height + 29.0);
        canvas.text(self.quantities.x_title, below, TEXT, Anchor::Middle)?;
        canvas.text(self.quantities.y_title, (left, top - 11.0), TEXT, Anchor::Start)
    }

    fn draw_curve(&self, canvas: &Canvas<'_>, curve: &Curve) -> Result<(), DrawError> {
        let style = &curve.style;
        for pair in curve.points.windows(2) {
            let places = (self.place(&pair[0]), self.place(&pair[1]));
            let (Some(a), Some(b)) = places else { continue };
            if style.is_peer {
                canvas.dashes([a, b], style.color, style.width)?;
            } else {
                canvas.line(&[a, b], style.color, style.width)?;
            }
        }
        for point in &curve.points {
            if let Some(at) = self.place(point) {
                marker::draw(canvas, at, style)?;
            } else if let (false, Some(x)) = (point.is_right, (self.quantities.x)(point)) {
                let at = (self.x.place(x), self.corner.1 + 0.5 * STRIP);
                marker::draw_failure(canvas, at, style.color)?;
            }
        }
        Ok(())
    }

    /// Where a run is that was right and has both figures.
    fn place(&self, point: &CostErrorPoint) -> Option<Pixel> {
        let (x, y) = ((self.quantities.x)(point)?, (self.quantities.y)(point)?);
        point.is_right.then(|| (self.x.place(x), self.y.place(y)))
    }
}
