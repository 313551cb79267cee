//! The curves over frequency: |Z|, its phase and Re Z, each band that is not passive shaded.

use std::ops::Range;

use lab::plot::axis::Axis;
use lab::plot::canvas::{Anchor, Canvas, Pixel};
use lab::plot::color::{CURVES, Color, INK, Stroke};
use lab::plot::edge::{PanelEdge, PanelSide};
use lab::plot::legend;

use crate::curve::{ImpedanceCurve, ImpedancePoint};

/// Width of the picture, and what is below the legend (pixels).
const WIDTH: f64 = 900.0;
const BELOW: f64 = 640.0;
/// Where the frequency axis begins and ends.
const SPAN: (f64, f64) = (92.0, 876.0);
/// Where the panels begin and end, from the legend's end.
const PANELS: [(f64, f64); 3] = [(8.0, 224.0), (244.0, 390.0), (410.0, 584.0)];
/// Titles of the panels, and where they stand.
const TITLES: [&str; 3] = ["|Z| [N·s/m]", "phase [°]", "Re Z [N·s/m]"];
const TITLE_PLACE: f64 = 20.0;
/// Size of text (pixels).
const TEXT: f64 = 12.5;
/// Where the legend begins.
const LEGEND: f64 = 50.0;
/// Strokes of curves, and where Re Z is zero.
const CURVE: f64 = 1.9;
const ZERO: Stroke = Stroke::new(INK, 0.75).faint(0.6);
/// How much farther Re Z is shown above zero than below, where it is below.
const HIGHEST: f64 = 6.0;
/// How much of a curve's colour its shade has.
const SHADE: f64 = 0.2;

/// Draws `curves` under a title as SVG text.
pub(crate) fn svg(title: &str, curves: &[ImpedanceCurve]) -> String {
    let head = LEGEND + legend::ROW * curves.len() as f64;
    let mut canvas = Canvas::new((WIDTH, head + BELOW));
    canvas.text(title, (SPAN.0, 20.0), 15.0, Anchor::Start);
    if curves.iter().any(|it| !it.active_bands().is_empty()) {
        canvas.text("shaded: Re Z < 0, not passive", (SPAN.1, 20.0), TEXT, Anchor::End);
    }
    for (row, curve) in curves.iter().enumerate() {
        let at = (SPAN.0, LEGEND + legend::ROW * row as f64 - 6.0);
        legend::draw_row(&mut canvas, at, stroke(row), &curve.name);
    }
    let across = frequency_axis(curves);
    let values: [fn(&ImpedancePoint) -> f64; 3] =
        [ImpedancePoint::magnitude, ImpedancePoint::phase, |it| it.real];
    for (number, (top, bottom)) in PANELS.into_iter().enumerate() {
        let panel = [(SPAN.0, head + top), (SPAN.1, head + bottom)];
        let up = value_axis(number, curves, (head + bottom, head + top));
        draw_shades(&mut canvas, &across, panel, curves);
        draw_curves(&mut canvas, ([&across, &up], panel), curves, values[number]);
        draw_frame(&mut canvas, [&across, &up], panel, number);
    }
    canvas.into_svg()
}

fn stroke(number: usize) -> Stroke {
    Stroke::new(color(number), CURVE)
}

const fn color(number: usize) -> Color {
    CURVES[number % CURVES.len()]
}

/// The colour of a shade: its curve's, thinned with white.
fn shade(number: usize) -> Color {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    let thin = |part: u8| (255.0 - SHADE * (255.0 - f64::from(part))).round() as u8;
    let Color(red, green, blue) = color(number);
    Color(thin(red), thin(green), thin(blue))
}

fn points(curves: &[ImpedanceCurve]) -> impl Iterator<Item = &ImpedancePoint> {
    curves.iter().flat_map(|it| &it.points)
}

fn frequency_axis(curves: &[ImpedanceCurve]) -> Axis {
    let range = extent(points(curves).map(|it| it.frequency));
    if range.is_empty() { Axis::decades(&(1.0..10.0), SPAN) } else { Axis::decades(&range, SPAN) }
}

fn value_axis(number: usize, curves: &[ImpedanceCurve], places: (f64, f64)) -> Axis {
    match number {
        0 => Axis::logarithmic(points(curves).map(ImpedancePoint::magnitude), places),
        1 => Axis::linear(&(-190.0..190.0), places),
        _ => {
            let range = extent(points(curves).map(|it| it.real).chain([0.0]));
            // A resonance would hide what is below zero.
            let high = if range.start < 0.0 { HIGHEST * -range.start } else { f64::INFINITY };
            let high = range.end.min(high);
            let room = (0.08 * (high - range.start)).max(1e-9);
            Axis::linear(&(range.start - room..high + room), places)
        }
    }
}

/// The least and the greatest of `values`.
fn extent(values: impl Iterator<Item = f64>) -> Range<f64> {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = values.fold(ends, |(low, high), it| (low.min(it), high.max(it)));
    low..high
}

/// Shades the bands of each curve that has some, one curve below the other.
fn draw_shades(canvas: &mut Canvas, across: &Axis, panel: [Pixel; 2], curves: &[ImpedanceCurve]) {
    let bands = curves.iter().map(ImpedanceCurve::active_bands).enumerate();
    let shaded: Vec<_> = bands.filter(|it| !it.1.is_empty()).collect();
    let [(_, top), (_, bottom)] = panel;
    let height = (bottom - top) / shaded.len().max(1) as f64;
    for (row, (number, bands)) in shaded.iter().enumerate() {
        let top = top + row as f64 * height;
        for band in bands {
            // A band of one frequency can be seen, too.
            let [left, right] = [band.from, band.to].map(|it| across.place(it));
            let right = right.max(left + 1.0);
            canvas.fill([(left, top), (right, top + height)], shade(*number));
        }
    }
}

fn draw_curves(
    canvas: &mut Canvas,
    ([across, up], [(_, top), (_, bottom)]): ([&Axis; 2], [Pixel; 2]),
    curves: &[ImpedanceCurve],
    value: fn(&ImpedancePoint) -> f64,
) {
    for (number, curve) in curves.iter().enumerate() {
        let place = |it: &ImpedancePoint| {
            // What is beyond the panel is cut at its edge.
            (across.place(it.frequency), up.place(value(it)).clamp(top, bottom))
        };
        let places: Vec<_> = curve.points.iter().map(place).collect();
        canvas.line(&places, stroke(number));
    }
}

fn draw_frame(canvas: &mut Canvas, [across, up]: [&Axis; 2], panel: [Pixel; 2], number: usize) {
    let [(left, top), (right, bottom)] = panel;
    let edge = |axis, side, wanted| PanelEdge { axis, side, panel, wanted };
    for edge in [edge(across, PanelSide::Below, 8.0), edge(up, PanelSide::Left, 5.0)] {
        edge.draw_grid(canvas);
    }
    edge(up, PanelSide::Left, 5.0).draw_axis(canvas);
    if number > 0 {
        let zero = up.place(0.0);
        canvas.line(&[(left, zero), (right, zero)], ZERO);
    }
    let middle = f64::midpoint(top, bottom);
    canvas.text(TITLES[number], (TITLE_PLACE, middle), TEXT, Anchor::Upright);
    if number + 1 == PANELS.len() {
        edge(across, PanelSide::Below, 8.0).draw_axis(canvas);
        let below = (f64::midpoint(left, right), bottom + 36.0);
        canvas.text("frequency [Hz]", below, TEXT, Anchor::Middle);
    }
}
