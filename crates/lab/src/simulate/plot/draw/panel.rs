//! The curves of one panel: which axis each belongs to, its colour, and its name.

use std::ops::Range;

use super::super::curve::{PanelKind, SignalCurve};
use super::super::picture::Picture;
use super::super::source::CurveSource;
use super::super::track::TrackPoint;
use super::super::unit::quantity;
use super::level;
use crate::plot::color::{CURVES, Color, INK, Stroke};

/// The input, a broad line under the others.
const INPUT: Stroke = Stroke::new(Color(170, 170, 170), 5.0);
/// Width of the other curves (pixels).
const WIDTH: f64 = 1.75;
/// Width of a curve that another axis' curve may cover (pixels).
const BROAD: f64 = 2.75;

/// A curve as it is drawn.
#[derive(Debug)]
pub(super) struct PanelCurve {
    pub(super) stretches: Vec<Vec<TrackPoint>>,
    /// 0 left, 1 right.
    pub(super) axis: usize,
    pub(super) stroke: Stroke,
    pub(super) text: String,
}

/// A panel's curves and its axes.
#[derive(Debug)]
pub(super) struct SignalPanel<'a> {
    pub(super) picture: &'a Picture,
    pub(super) kind: PanelKind,
    /// The axes' units, left and right.
    pub(super) units: Vec<&'static str>,
    pub(super) ranges: [Range<f64>; 2],
    pub(super) lines: Vec<PanelCurve>,
}

impl<'a> SignalPanel<'a> {
    pub(super) fn new(picture: &'a Picture, kind: PanelKind) -> Self {
        let curves: Vec<_> = picture.curves.iter().filter(|curve| curve.panel == kind).collect();
        let mut units = Vec::new();
        for curve in &curves {
            let unit = axis_unit(curve);
            if !units.contains(&unit) {
                units.push(unit);
            }
        }
        let axis = |curve: &SignalCurve| units.iter().position(|unit| *unit == axis_unit(curve));
        let mut colors = CURVES.into_iter().cycle();
        let mut stroke = |source| match source {
            CurveSource::Input => INPUT,
            CurveSource::State(_) | CurveSource::Output(_) | CurveSource::Guard(_) => {
                Stroke::new(colors.next().unwrap_or(INK), WIDTH)
            }
        };
        let line = |curve: &&SignalCurve| {
            let axis = axis(curve).unwrap_or(0);
            PanelCurve::new(curve, (axis, units.len()), stroke(curve.source))
        };
        let lines = curves.iter().map(line).filter(|line| !line.stretches.is_empty());
        let lines: Vec<_> = lines.collect();
        let ranges = level::level([0, 1].map(|axis| extent(&lines, axis)));
        Self { picture, kind, units, ranges, lines }
    }

    /// What an axis measures: `force [N]`.
    pub(super) fn title(&self, axis: usize) -> String {
        match (self.kind, self.units.get(axis)) {
            (_, None) => String::new(),
            (PanelKind::Guards, Some(_)) => "guard / its peak [1]".to_owned(),
            (PanelKind::Forces | PanelKind::Coordinates, Some(unit)) => {
                format!("{} [{unit}]", quantity(unit))
            }
        }
    }
}

impl PanelCurve {
    fn new(curve: &SignalCurve, (axis, n_axes): (usize, usize), stroke: Stroke) -> Self {
        let SignalCurve { name, unit, panel, track, .. } = curve;
        let mut stretches = track.stretches();
        // Curves of two axes may coincide: the lower one is seen beside the upper one.
        let is_covered = n_axes > 1 && axis == 0;
        let width = if is_covered { stroke.width.max(BROAD) } else { stroke.width };
        let text = if *panel == PanelKind::Guards {
            let peak = track.peak();
            stretches.iter_mut().flatten().for_each(|point| point.1 /= peak);
            format!("{name} / {} {unit}", level::short(peak))
        } else {
            let side = match axis {
                _ if n_axes == 1 => "",
                0 => ", left",
                _ => ", right",
            };
            format!("{name} [{unit}]{side}")
        };
        Self { stretches, axis, stroke: Stroke { width, ..stroke }, text }
    }
}

/// The unit of the axis that a curve is drawn to: guards of all units share one.
fn axis_unit(curve: &SignalCurve) -> &'static str {
    if curve.panel == PanelKind::Guards { "1" } else { curve.unit }
}

/// Lowest and highest value drawn to an axis.
fn extent(lines: &[PanelCurve], axis: usize) -> Option<(f64, f64)> {
    let lines = lines.iter().filter(|line| line.axis == axis);
    let values = lines.flat_map(|line| line.stretches.iter().flatten()).map(|point| point.1);
    let ends = values.map(|value| (value, value));
    ends.reduce(|(low, high), (value, _)| (low.min(value), high.max(value)))
}
