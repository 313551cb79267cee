//! A map as SVG: a colour for each verdict, the measured boundary, and the lines of theory.

use super::axis::MapAxis;
use super::judge::LoopVerdict;
use super::map::{StabilityMap, StabilityStudy};
use crate::plot::axis::Axis;
use crate::plot::canvas::{Anchor, Canvas, Pixel};
use crate::plot::color::{Color, INK, Stroke};
use crate::plot::edge::{PanelEdge, PanelSide};
use crate::plot::legend;

/// Size of the picture (pixels).
const SIZE: Pixel = (980.0, 536.0);
/// Upper left and lower right corner of the map (pixels).
const PANEL: [Pixel; 2] = [(84.0, 92.0), (600.0, 478.0)];
/// Where the legend begins (pixels).
const LEGEND: Pixel = (626.0, 106.0);
/// Size of the titles' text, of the line below them, and of names along an axis (pixels).
const TITLE: f64 = 15.0;
const TEXT: f64 = 12.0;
/// Radius of a mark of the measured boundary (pixels).
const MARK: f64 = 2.4;
/// About how many numbers an axis has.
const NUMBERS: f64 = 8.0;
/// Width and height of a sample of a colour (pixels).
const SAMPLE: Pixel = (28.0, 12.0);

/// Colours of the lines of theory, which differ from those of the verdicts.
const LINES: [Color; 4] =
    [Color(0, 60, 140), Color(140, 30, 120), Color(90, 90, 90), Color(20, 20, 20)];

const fn color(verdict: LoopVerdict) -> Color {
    match verdict {
        LoopVerdict::Rests => Color(178, 221, 204),
        LoopVerdict::Rings => Color(250, 224, 158),
        LoopVerdict::MakesEnergy => Color(240, 176, 148),
        LoopVerdict::Fails => Color(206, 206, 206),
    }
}

/// Draws a map of a study, with lines of what is no axis.
pub(super) fn svg(study: &StabilityStudy<'_>, map: &StabilityMap, settings: &[String]) -> String {
    let mut canvas = Canvas::new(SIZE);
    let [(left, top), (right, bottom)] = PANEL;
    draw_cells(&mut canvas, map);
    for (axis, side) in study.axes.iter().zip([PanelSide::Below, PanelSide::Left]) {
        draw_axis(&mut canvas, axis, side);
    }
    draw_boundary(&mut canvas, study, map);
    for (line, color) in map.theories.iter().zip(LINES) {
        for places in &line.lines {
            let places: Vec<_> = places.iter().map(|it| pixel(*it)).collect();
            canvas.line(&places, theory_stroke(color));
        }
    }
    let title = format!("{}, velocity by {}", study.name, map.estimator.name());
    canvas.text(&title, (left, 20.0), TITLE, Anchor::Start);
    for (row, line) in settings.iter().enumerate() {
        canvas.text(line, (left, 38.0 + 15.0 * row as f64), 11.0, Anchor::Start);
    }
    let [across, up] = [0, 1].map(|axis| axis_title(&study.axes[axis]));
    canvas.text(&up, (left, top - 14.0), TEXT, Anchor::Start);
    canvas.text(&across, (0.5 * (left + right), bottom + 34.0), TEXT, Anchor::Middle);
    draw_legend(&mut canvas, map);
    canvas.into_svg()
}

const fn theory_stroke(color: Color) -> Stroke {
    Stroke { is_dashed: true, ..Stroke::new(color, 1.8) }
}

/// Title of an axis with its unit.
pub(super) fn axis_title(axis: &MapAxis) -> String {
    match axis.shown.0.as_str() {
        "" | "1" => axis.title.clone(),
        unit => format!("{} [{unit}]", axis.title),
    }
}

/// Where a part of both axes is.
fn pixel((x, y): (f64, f64)) -> Pixel {
    let [(left, top), (right, bottom)] = PANEL;
    (left + x * (right - left), bottom - y * (bottom - top))
}

/// The nearest whole pixel: no seam is seen between cells that begin and end on one.
fn snapped((x, y): Pixel) -> Pixel {
    (x.round(), y.round())
}

/// Fills each run of cells of one verdict in a column.
fn draw_cells(canvas: &mut Canvas, map: &StabilityMap) {
    let across = map.columns.len() as f64;
    for (x, column) in map.columns.iter().enumerate() {
        let up = column.len() as f64;
        let mut from = 0;
        for run in column.chunk_by(|a, b| a == b) {
            let to = from + run.len();
            let low = pixel((x as f64 / across, from as f64 / up));
            let high = pixel(((x as f64 + 1.0) / across, to as f64 / up));
            canvas.fill([low, high].map(snapped), color(run[0]));
            from = to;
        }
    }
}

fn draw_axis(canvas: &mut Canvas, axis: &MapAxis, side: PanelSide) {
    let [(left, top), (right, bottom)] = PANEL;
    let is_below = side == PanelSide::Below;
    let places = if is_below { (left, right) } else { (bottom, top) };
    if let Some(names) = axis.names() {
        for (number, name) in names.iter().enumerate() {
            let part = axis.part(number as f64);
            let place = if is_below { pixel((part, 0.0)) } else { pixel((0.0, part)) };
            let (at, anchor) = if is_below {
                ((place.0, place.1 + 13.0), Anchor::Middle)
            } else {
                ((place.0 - 7.0, place.1), Anchor::End)
            };
            canvas.text(name, at, TEXT, anchor);
        }
        return;
    }
    let per = axis.shown.1;
    let range = axis.ends.0 * per..axis.ends.1 * per;
    let drawn = if axis.is_logarithmic() {
        Axis::decades(&range, places)
    } else {
        Axis::linear(&range, places)
    };
    let edge = PanelEdge { axis: &drawn, side, panel: PANEL, wanted: NUMBERS };
    edge.draw_grid(canvas);
    edge.draw_axis(canvas);
}

/// Marks each place at which a column goes from stable to unstable.
fn draw_boundary(canvas: &mut Canvas, study: &StabilityStudy<'_>, map: &StabilityMap) {
    for (x, crossings) in map.crossings.iter().enumerate() {
        for crossing in crossings {
            let place = pixel((study.middle(0, x), study.axes[1].part(*crossing)));
            canvas.circle(place, MARK, INK, Stroke::new(INK, 0.5));
        }
    }
}

fn draw_legend(canvas: &mut Canvas, map: &StabilityMap) {
    let counts = map.counts();
    let counts = [counts.rests, counts.rings, counts.makes_energy, counts.fails];
    let mut at = LEGEND;
    for (verdict, count) in LoopVerdict::ALL.into_iter().zip(counts) {
        if count == 0 && verdict == LoopVerdict::Fails {
            continue;
        }
        let corner = (at.0, at.1 - 0.5 * SAMPLE.1);
        canvas.fill([corner, (corner.0 + SAMPLE.0, corner.1 + SAMPLE.1)], color(verdict));
        legend::draw_name(canvas, at, &format!("{} ({count} cells)", verdict.title()));
        at.1 += legend::ROW;
    }
    at.1 += 0.5 * legend::ROW;
    let middle = legend::draw_name(canvas, at, "boundary, by bisection");
    canvas.circle(middle, MARK, INK, Stroke::new(INK, 0.5));
    at.1 += legend::ROW;
    let drawn = map.theories.iter().zip(LINES).filter(|it| !it.0.lines.is_empty());
    for (line, color) in drawn {
        legend::draw_row(canvas, at, theory_stroke(color), line.theory.title);
        at.1 += legend::ROW;
    }
}
