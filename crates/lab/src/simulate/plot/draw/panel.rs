//! One panel: shades, a grid, one or two axes with their units, curves.

use std::ops::Range;

use plotters::chart::{ChartBuilder, DualCoordChartContext};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{
    Cartesian2d, LabelAreaPosition, PathElement, RGBColor, Rectangle, SVGBackend, TRANSPARENT,
};
use plotters::style::Color as _;

use super::super::Picture;
use super::super::curve::{CurveSource, PanelKind as Kind, SignalCurve};
use super::super::track::TrackPoint;
use super::super::unit::quantity;
use super::canvas::{Anchor, Canvas, DrawError, INK, fine, fine_size, font, write};
use super::{CURVES, place, scale, shade};

/// Size of the axes' text (pixels).
const TEXT: f64 = 12.0;
/// Room for the numbers of the time axis (pixels).
const BELOW: f64 = 46.0;
/// Lines of the grid across a panel.
const GRID: usize = 6;
/// The input, a broad line under the others.
const INPUT: (RGBColor, f64) = (RGBColor(170, 170, 170), 5.0);

type Plane = Cartesian2d<RangedCoordf64, RangedCoordf64>;
type Chart<'a, 'b> = DualCoordChartContext<'a, SVGBackend<'b>, Plane, Plane>;

/// A curve as it is drawn.
#[derive(Debug)]
pub(super) struct PanelCurve {
    stretches: Vec<Vec<TrackPoint>>,
    /// 0 left, 1 right.
    axis: usize,
    pub(super) color: RGBColor,
    /// (pixels)
    pub(super) width: f64,
    pub(super) text: String,
}

/// A panel's curves and its axes.
#[derive(Debug)]
pub(super) struct SignalPanel<'a> {
    picture: &'a Picture,
    kind: Kind,
    /// The axes' units, left and right.
    units: Vec<&'static str>,
    ranges: [Range<f64>; 2],
    pub(super) lines: Vec<PanelCurve>,
}

impl<'a> SignalPanel<'a> {
    pub(super) fn new(picture: &'a Picture, kind: Kind) -> Self {
        let curves: Vec<_> = picture.curves.iter().filter(|curve| curve.panel == kind).collect();
        let mut units = Vec::new();
        for curve in &curves {
            let unit = axis_unit(curve);
            if !units.contains(&unit) {
                units.push(unit);
            }
        }
        let axis = |curve: &SignalCurve| units.iter().position(|unit| *unit == axis_unit(curve));
        let mut colors = CURVES.iter().copied().cycle();
        let mut style = |source| match source {
            CurveSource::Input => INPUT,
            CurveSource::State(_) | CurveSource::Output(_) | CurveSource::Guard(_) => {
                (colors.next().unwrap_or(INK), 1.75)
            }
        };
        let line = |curve: &&SignalCurve| {
            let axis = axis(curve).unwrap_or(0);
            PanelCurve::new(curve, (axis, units.len()), style(curve.source))
        };
        let lines = curves.iter().map(line).filter(|line| !line.stretches.is_empty());
        let lines: Vec<_> = lines.collect();
        let ranges = scale::level([0, 1].map(|axis| extent(&lines, axis)));
        Self { picture, kind, units, ranges, lines }
    }

    /// Draws the panel between two heights (pixels).
    pub(super) fn draw(
        &self,
        canvas: &Canvas<'_>,
        (top, bottom): (f64, f64),
    ) -> Result<(), DrawError> {
        let below = if self.kind == Kind::Coordinates { BELOW } else { 0.0 };
        let right = place::LEGEND - place::GAP;
        let size = (fine(right), fine(bottom - top + below));
        let area = canvas.clone().shrink((0, fine(top)), size);
        let [left, across] = self.ranges.clone();
        let time = 0.0..self.picture.axis.until;
        let mut chart = ChartBuilder::on(&area)
            .set_label_area_size(LabelAreaPosition::Left, fine_size(place::LEFT))
            .set_label_area_size(LabelAreaPosition::Right, fine_size(right - place::RIGHT))
            .set_label_area_size(LabelAreaPosition::Bottom, fine_size(below))
            .build_cartesian_2d(time.clone(), left)?
            .set_secondary_coord(time, across);
        self.draw_titles(canvas, f64::midpoint(top, bottom))?;
        self.draw_shades(&mut chart)?;
        self.draw_axes(&mut chart)?;
        self.lines.iter().try_for_each(|line| line.draw(&mut chart))
    }

    fn draw_shades(&self, chart: &mut Chart<'_, '_>) -> Result<(), DrawError> {
        let Range { start: low, end: high } = self.ranges[0];
        let shades = self.picture.epochs.all.iter().map(|epoch| {
            let (start, end) = epoch.span;
            Rectangle::new([(start, low), (end, high)], shade(epoch.mode).filled())
        });
        chart.draw_series(shades)?;
        Ok(())
    }

    fn draw_axes(&self, chart: &mut Chart<'_, '_>) -> Result<(), DrawError> {
        let [left, right] = &self.ranges;
        let time = 0.0..self.picture.axis.until;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(INK.mix(0.15).stroke_width(fine_size(0.75)))
            .axis_style(INK.stroke_width(fine_size(0.75)))
            .label_style(font(TEXT))
            .axis_desc_style(font(TEXT))
            .set_all_tick_mark_size(fine_size(4.0))
            .x_labels(2 * GRID)
            .y_labels(GRID)
            .x_label_formatter(&|t| scale::tick(*t, &time))
            .y_label_formatter(&|value| scale::tick(*value, left))
            .x_desc("time t [s]")
            .draw()?;
        if self.units.len() > 1 {
            chart
                .configure_secondary_axes()
                .axis_style(INK.stroke_width(fine_size(0.75)))
                .label_style(font(TEXT))
                .set_all_tick_mark_size(fine_size(4.0))
                .y_labels(GRID)
                .y_label_formatter(&|value| scale::tick(*value, right))
                .draw()?;
        }
        let zero = [(0.0, 0.0), (self.picture.axis.until, 0.0)];
        let style = INK.mix(0.6).stroke_width(fine_size(0.75));
        chart.draw_series([PathElement::new(zero, style)])?;
        Ok(())
    }

    /// Writes beside the axes what they measure, around the height `middle` (pixels).
    fn draw_titles(&self, canvas: &Canvas<'_>, middle: f64) -> Result<(), DrawError> {
        for (axis, x) in place::TITLES.into_iter().enumerate() {
            write(canvas, &self.title(axis), (x, middle), TEXT, Anchor::Upright)?;
        }
        Ok(())
    }

    /// What an axis measures: `force [N]`.
    fn title(&self, axis: usize) -> String {
        match (self.kind, self.units.get(axis)) {
            (_, None) => String::new(),
            (Kind::Guards, Some(_)) => "guard / its peak [1]".to_owned(),
            (Kind::Forces | Kind::Coordinates, Some(unit)) => {
                format!("{} [{unit}]", quantity(unit))
            }
        }
    }
}

impl PanelCurve {
    fn new(
        curve: &SignalCurve,
        (axis, n_axes): (usize, usize),
        (color, width): (RGBColor, f64),
    ) -> Self {
        let SignalCurve { name, unit, panel, track, .. } = curve;
        let mut stretches = track.stretches();
        // Curves of two axes may coincide: the lower one is seen beside the upper one.
        let width = if n_axes > 1 && axis == 0 { width.max(2.75) } else { width };
        let text = if *panel == Kind::Guards {
            let peak = track.peak();
            stretches.iter_mut().flatten().for_each(|point| point.1 /= peak);
            format!("{name} / {} {unit}", scale::short(peak))
        } else {
            let side = match axis {
                _ if n_axes == 1 => "",
                0 => ", left",
                _ => ", right",
            };
            format!("{name} [{unit}]{side}")
        };
        Self { stretches, axis, color, width, text }
    }

    fn draw(&self, chart: &mut Chart<'_, '_>) -> Result<(), DrawError> {
        let style = self.color.stroke_width(fine_size(self.width));
        let paths = self.stretches.iter().map(|stretch| PathElement::new(stretch.clone(), style));
        if self.axis == 0 {
            chart.draw_series(paths)?;
        } else {
            chart.draw_secondary_series(paths)?;
        }
        Ok(())
    }
}

/// The unit of the axis that a curve is drawn to: guards of all units share one.
fn axis_unit(curve: &SignalCurve) -> &'static str {
    if curve.panel == Kind::Guards { "1" } else { curve.unit }
}

/// Lowest and highest value drawn to an axis.
fn extent(lines: &[PanelCurve], axis: usize) -> Option<(f64, f64)> {
    let lines = lines.iter().filter(|line| line.axis == axis);
    let values = lines.flat_map(|line| line.stretches.iter().flatten()).map(|point| point.1);
    let ends = values.map(|value| (value, value));
    ends.reduce(|(low, high), (value, _)| (low.min(value), high.max(value)))
}
