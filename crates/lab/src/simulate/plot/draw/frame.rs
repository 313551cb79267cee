//! A panel as it is drawn: shades of modes, a grid, one or two axes, curves.

use super::super::curve::PanelKind;
use super::panel::{PanelCurve, SignalPanel};
use super::{place, shade, time};
use crate::plot::axis::Axis;
use crate::plot::canvas::{Anchor, Canvas, Pixel};
use crate::plot::color::{INK, Stroke};
use crate::plot::edge::{PanelEdge, PanelSide};

/// Size of the titles (pixels).
const TEXT: f64 = 12.0;
/// Most numbers of an axis across a panel.
const NUMBERS: f64 = 6.0;
/// Where all values are zero.
const ZERO: Stroke = Stroke::new(INK, 0.75).faint(0.6);

/// A panel between its axes.
#[derive(Debug)]
pub(super) struct Frame<'a> {
    panel: &'a SignalPanel<'a>,
    /// Upper left and lower right corner.
    corners: [Pixel; 2],
    time: Axis,
    /// The axes of values, left and right.
    values: [Axis; 2],
}

impl<'a> Frame<'a> {
    /// Returns the frame between two heights (pixels).
    pub(super) fn new(panel: &'a SignalPanel<'a>, (top, bottom): (f64, f64)) -> Self {
        let values = [0, 1].map(|axis| Axis::linear(&panel.ranges[axis], (bottom, top)));
        let corners = [(place::LEFT, top), (place::RIGHT, bottom)];
        Self { panel, corners, time: time(panel.picture), values }
    }

    pub(super) fn draw(&self, canvas: &mut Canvas) {
        self.draw_shades(canvas);
        self.draw_axes(canvas);
        self.draw_titles(canvas);
        for line in &self.panel.lines {
            self.draw_curve(canvas, line);
        }
    }

    fn draw_shades(&self, canvas: &mut Canvas) {
        let [(_, top), (_, bottom)] = self.corners;
        for epoch in &self.panel.picture.epochs.all {
            let (start, end) = epoch.span;
            let corners = [(self.time.place(start), top), (self.time.place(end), bottom)];
            canvas.fill(corners, shade(epoch.mode));
        }
    }

    fn draw_axes(&self, canvas: &mut Canvas) {
        let [left, right] = &self.values;
        let edge = |axis, side, wanted| PanelEdge { axis, side, panel: self.corners, wanted };
        let time = edge(&self.time, PanelSide::Below, 2.0 * NUMBERS);
        let left = edge(left, PanelSide::Left, NUMBERS);
        time.draw_grid(canvas);
        left.draw_grid(canvas);
        left.draw_axis(canvas);
        if self.panel.units.len() > 1 {
            edge(right, PanelSide::Right, NUMBERS).draw_axis(canvas);
        }
        if self.panel.kind == PanelKind::Coordinates {
            time.draw_axis(canvas);
        }
        let zero = self.values[0].place(0.0);
        canvas.line(&[(place::LEFT, zero), (place::RIGHT, zero)], ZERO);
    }

    /// Writes beside the axes what they measure.
    fn draw_titles(&self, canvas: &mut Canvas) {
        let [(left, top), (right, bottom)] = self.corners;
        for (axis, x) in place::TITLES.into_iter().enumerate() {
            let at = (x, f64::midpoint(top, bottom));
            canvas.text(&self.panel.title(axis), at, TEXT, Anchor::Upright);
        }
        if self.panel.kind == PanelKind::Coordinates {
            let at = (f64::midpoint(left, right), place::BELOW);
            canvas.text("time t [s]", at, TEXT, Anchor::Middle);
        }
    }

    fn draw_curve(&self, canvas: &mut Canvas, curve: &PanelCurve) {
        let values = &self.values[curve.axis];
        for stretch in &curve.stretches {
            let place = |(t, value): &(f64, f64)| (self.time.place(*t), values.place(*value));
            canvas.line(&stretch.iter().map(place).collect::<Vec<_>>(), curve.stroke);
        }
    }
}
