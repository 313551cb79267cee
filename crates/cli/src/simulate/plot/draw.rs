//! The picture: events above, modes as shades, three panels over one time axis.

use super::curve::{PanelKind, SignalCurve};
use super::run_picture::RunPicture;
use super::source::CurveSource;
use super::unit::quantity;
use figures::plot::color::{CURVES, Color, INK, MODES, Stroke};
use figures::plot::level::level;
use figures::plot::picture::{
    CurveLook, Picture, PictureArea, PictureAxis, PictureCurve, PicturePanel, PictureRule,
};

/// Width of the time axis (pixels).
pub(super) const COLUMNS: usize = 890;
/// Height of a panel (pixels).
const HEIGHT: f64 = 200.0;
/// Least distance of two names of events, and largest distance of a name from its event (pixels).
const APART: f64 = 14.0;
const ASTRAY: f64 = 42.0;
const EVENT: Stroke = Stroke::new(Color(90, 90, 90), 1.0);
/// Number of events from which their lines become fainter, so that curves stay visible.
const CROWD: f64 = 60.0;
/// Least opacity of events' lines.
const FAINTEST: f64 = 0.12;
const INPUT: Stroke = Stroke::new(Color(170, 170, 170), 5.0);
/// Width of the other curves (pixels).
const WIDTH: f64 = 1.75;
/// Width of a curve that another axis' curve may cover (pixels).
const BROAD: f64 = 2.75;

pub(super) fn svg(run: &RunPicture) -> String {
    let kinds = [PanelKind::Forces, PanelKind::Guards, PanelKind::Coordinates];
    let stroke = EVENT.faint((CROWD / run.marks.all.len() as f64).clamp(FAINTEST, 1.0));
    let rule = |at: f64| PictureRule { at, stroke };
    let [model, about @ ..] = &run.title;
    let picture = Picture {
        title: model.clone(),
        notes: about.to_vec(),
        columns: 1,
        size: (COLUMNS as f64, HEIGHT),
        panels: kinds.map(|kind| panel(run, kind)).into(),
        rules: run.marks.all.iter().map(|mark| rule(mark.t)).collect(),
        labels: run.marks.labels(APART, ASTRAY),
    };
    picture.svg()
}

/// Returns the curves of one panel, with an axis for each of their units.
fn panel(run: &RunPicture, kind: PanelKind) -> PicturePanel {
    let of_kind = || run.curves.iter().filter(|curve| curve.panel == kind);
    let mut units: Vec<&str> = Vec::new();
    for curve in of_kind() {
        if !units.contains(&axis_unit(curve)) {
            units.push(axis_unit(curve));
        }
    }
    units.truncate(2);
    let mut colors = CURVES.into_iter().cycle();
    let mut curves = Vec::new();
    for curve in of_kind() {
        let stroke = if curve.source == CurveSource::Input {
            INPUT
        } else {
            Stroke::new(colors.next().unwrap_or(INK), WIDTH)
        };
        curves.push(drawn(curve, &units, stroke));
    }
    curves.retain(|curve| !curve.stretches.is_empty());
    let ends = level([0, 1].map(|axis| extent(&curves, axis)));
    let axis = |(unit, ends): (&&str, (f64, f64))| {
        let title = match kind {
            PanelKind::Guards => "guard / its peak [1]".to_owned(),
            PanelKind::Forces | PanelKind::Coordinates => format!("{} [{unit}]", quantity(unit)),
        };
        PictureAxis::linear(title).between(ends)
    };
    let mut y: Vec<_> = units.iter().zip(ends).map(axis).collect();
    if y.is_empty() {
        y.push(PictureAxis::default());
    }
    let x = PictureAxis::linear("time t [s]").between((0.0, run.axis.until));
    PicturePanel { x, y, areas: areas(run), curves, ..PicturePanel::default() }
}

fn drawn(curve: &SignalCurve, units: &[&str], stroke: Stroke) -> PictureCurve {
    let SignalCurve { name, unit, panel, track, .. } = curve;
    let axis = units.iter().position(|unit| *unit == axis_unit(curve)).unwrap_or(0);
    let mut stretches = track.stretches();
    // Curves of two axes may coincide: the lower one stays visible beside the upper one.
    let is_covered = units.len() > 1 && axis == 0;
    let width = if is_covered { stroke.width.max(BROAD) } else { stroke.width };
    let text = if *panel == PanelKind::Guards {
        let peak = track.peak();
        stretches.iter_mut().flatten().for_each(|point| point.1 /= peak);
        format!("{name} / {} {unit}", short(peak))
    } else {
        let side = match axis {
            _ if units.len() == 1 => "",
            0 => ", left",
            _ => ", right",
        };
        format!("{name} [{unit}]{side}")
    };
    let curve = PictureCurve::new(text, Stroke { width, ..stroke }, CurveLook::Line, Vec::new());
    PictureCurve { axis, stretches, ..curve }
}

fn areas(run: &RunPicture) -> Vec<PictureArea> {
    let area = |epoch: &super::epoch::Epoch| PictureArea {
        x: epoch.span,
        y: None,
        color: MODES[epoch.mode % MODES.len()],
        name: format!("mode {}", run.modes[epoch.mode]),
        text: run.modes[epoch.mode].to_owned(),
    };
    run.epochs.all.iter().map(area).collect()
}

/// Returns the unit of a curve's axis: guards of all units share one.
fn axis_unit(curve: &SignalCurve) -> &'static str {
    if curve.panel == PanelKind::Guards { "1" } else { curve.unit }
}

fn extent(curves: &[PictureCurve], axis: usize) -> Option<(f64, f64)> {
    let curves = curves.iter().filter(|it| it.axis == axis);
    let values = curves.flat_map(|it| it.stretches.iter().flatten()).map(|point| point.1);
    let ends = values.map(|value| (value, value));
    ends.reduce(|(low, high), (value, _)| (low.min(value), high.max(value)))
}

fn short(value: f64) -> String {
    let decimals = match value.abs() {
        ..1e-3 => return format!("{value:.2e}"),
        ..1e-2 => 5,
        ..1e-1 => 4,
        ..1.0 => 3,
        ..10.0 => 2,
        ..100.0 => 1,
        ..1e5 => 0,
        _ => return format!("{value:.2e}"),
    };
    format!("{value:.decimals$}")
}
