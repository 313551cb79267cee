//! One pair of axes: curves of error against cost, and above them the runs that failed.

use super::curve::CostErrorCurve;
use super::marker;
use super::place;
use super::quantity::{CostErrorPoint, Quantities};
use crate::plot::axis::Axis;
use crate::plot::canvas::{Anchor, Canvas, Pixel};
use crate::plot::color::Color;
use crate::plot::edge::{PanelEdge, PanelSide};

/// Size of the text (pixels).
const TEXT: f64 = 11.5;
/// Height of the strip above the axes in which failures are marked (pixels).
const STRIP: f64 = 18.0;
/// Room between the strip and the highest place of a curve (pixels).
const BELOW_STRIP: f64 = 5.0;
/// The strip's colour.
const WRONG: Color = Color(251, 232, 228);
/// About how many numbers an axis has.
const NUMBERS: f64 = 8.0;

/// Axes, and what is drawn between them.
#[derive(Debug)]
pub(super) struct CostErrorPanel<'a> {
    quantities: &'a Quantities,
    curves: &'a [CostErrorCurve],
    /// Upper left corner, strip included.
    corner: Pixel,
    x: Axis,
    y: Axis,
}

impl<'a> CostErrorPanel<'a> {
    pub(super) fn new(
        quantities: &'a Quantities,
        curves: &'a [CostErrorCurve],
        corner: Pixel,
    ) -> Self {
        let points = || curves.iter().flat_map(|curve| &curve.points);
        let (width, height) = place::PANEL;
        // Failures have a cost too: they count for the scale of x.
        let across = (corner.0, corner.0 + width);
        let x = Axis::logarithmic(points().filter_map(quantities.x), across);
        let up = (corner.1 + height, corner.1 + STRIP + BELOW_STRIP);
        let y = Axis::logarithmic(points().filter_map(quantities.y), up);
        Self { quantities, curves, corner, x, y }
    }

    pub(super) fn draw(&self, canvas: &mut Canvas) {
        self.draw_axes(canvas);
        self.draw_titles(canvas);
        for curve in self.curves {
            self.draw_curve(canvas, curve);
        }
    }

    fn draw_axes(&self, canvas: &mut Canvas) {
        let (left, top) = self.corner;
        let (right, bottom) = (left + place::PANEL.0, top + place::PANEL.1);
        let axes_top = top + STRIP;
        canvas.fill([(left, top), (right, axes_top)], WRONG);
        canvas.text("wrong", (left - 6.0, top + 0.5 * STRIP), TEXT, Anchor::End);
        let panel = [(left, axes_top), (right, bottom)];
        for (axis, side) in [(&self.x, PanelSide::Below), (&self.y, PanelSide::Left)] {
            let edge = PanelEdge { axis, side, panel, wanted: NUMBERS };
            edge.draw_grid(canvas);
            edge.draw_axis(canvas);
        }
    }

    fn draw_titles(&self, canvas: &mut Canvas) {
        let (left, top) = self.corner;
        let (width, height) = place::PANEL;
        let below = (left + 0.5 * width, top + height + 30.0);
        canvas.text(self.quantities.x_title, below, TEXT, Anchor::Middle);
        canvas.text(self.quantities.y_title, (left, top - 11.0), TEXT, Anchor::Start);
    }

    fn draw_curve(&self, canvas: &mut Canvas, curve: &CostErrorCurve) {
        let style = &curve.style;
        for pair in curve.points.windows(2) {
            if let (Some(a), Some(b)) = (self.place(&pair[0]), self.place(&pair[1])) {
                canvas.line(&[a, b], style.stroke);
            }
        }
        for point in &curve.points {
            if let Some(at) = self.place(point) {
                marker::draw(canvas, at, style);
            } else if let (false, Some(x)) = (point.is_right, (self.quantities.x)(point)) {
                let at = (self.x.place(x), self.corner.1 + 0.5 * STRIP);
                marker::draw_failure(canvas, at, style.stroke.color);
            }
        }
    }

    /// Where a run is that was right and has both figures.
    fn place(&self, point: &CostErrorPoint) -> Option<Pixel> {
        let (x, y) = ((self.quantities.x)(point)?, (self.quantities.y)(point)?);
        point.is_right.then(|| (self.x.place(x), self.y.place(y)))
    }
}
