//! An axis at a side of its panel, with grid, ticks and numbers.

use super::axis::Axis;
use super::canvas::{Anchor, Canvas, Pixel};
use super::color::{INK, Stroke};

/// Size of the numbers (pixels).
const TEXT: f64 = 11.5;
/// Length of a tick (pixels).
const TICK: f64 = 4.0;
/// Distance from an axis to the middle of the numbers below it (pixels).
const BELOW: f64 = 13.0;
/// Distance from an axis to the numbers beside it (pixels).
const BESIDE: f64 = 7.0;
const LINE: Stroke = Stroke::new(INK, 0.75);
const GRID: Stroke = Stroke::new(INK, 0.75).faint(0.15);

/// Side of a panel with an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PanelSide {
    Left,
    Right,
    Below,
}

/// An axis at a side of a panel.
#[derive(Clone, Copy, Debug)]
pub struct PanelEdge<'a> {
    pub axis: &'a Axis,
    pub side: PanelSide,
    /// Upper left and lower right corner of the panel.
    pub panel: [Pixel; 2],
    pub wanted: f64,
}

impl PanelEdge<'_> {
    pub fn draw_grid(&self, canvas: &mut Canvas) {
        let [(left, top), (right, bottom)] = self.panel;
        for line in self.axis.lines(self.wanted) {
            let at = line.place;
            let ends = match self.side {
                PanelSide::Below => [(at, top), (at, bottom)],
                PanelSide::Left | PanelSide::Right => [(left, at), (right, at)],
            };
            canvas.line(&ends, GRID);
        }
    }

    pub fn draw_axis(&self, canvas: &mut Canvas) {
        let [(left, top), (right, bottom)] = self.panel;
        let ends = match self.side {
            PanelSide::Left => [(left, top), (left, bottom)],
            PanelSide::Right => [(right, top), (right, bottom)],
            PanelSide::Below => [(left, bottom), (right, bottom)],
        };
        canvas.line(&ends, LINE);
        for line in self.axis.lines(self.wanted) {
            if let Some(label) = line.label {
                self.draw_number(canvas, line.place, &label);
            }
        }
    }

    fn draw_number(&self, canvas: &mut Canvas, at: f64, number: &str) {
        let [(left, _), (right, bottom)] = self.panel;
        let (tick, text, anchor) = match self.side {
            PanelSide::Left => ([(left - TICK, at), (left, at)], (left - BESIDE, at), Anchor::End),
            PanelSide::Right => {
                ([(right, at), (right + TICK, at)], (right + BESIDE, at), Anchor::Start)
            }
            PanelSide::Below => {
                ([(at, bottom), (at, bottom + TICK)], (at, bottom + BELOW), Anchor::Middle)
            }
        };
        canvas.line(&tick, LINE);
        canvas.text(number, text, TEXT, anchor);
    }
}
