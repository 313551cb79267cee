//! The figure: force and guards above, the three angles below, epochs shaded, switches as lines.
//!
//! ```text
//!   title                                t₁   t₂     t₃ ...   above the lines of the switches
//!   F [N]        | B1 |  B2  | B1 |  B2   ...  | gap [mm]
//!   angle [rad]  |    |      |    |            |
//!                        model time [s]
//! ```

use std::ops::Range;

use super::model_run::{ModelRun, RunEvent, RunRow};
use super::outcome::STRING;
use crate::plot::axis::Axis;
use crate::plot::canvas::{Anchor, Canvas, Pixel};
use crate::plot::color::{CURVES, Color, INK, Stroke};
use crate::plot::edge::{PanelEdge, PanelSide};
use crate::plot::legend;

/// Size of the picture (pixels).
const SIZE: Pixel = (980.0, 700.0);
/// Where the time axis begins and ends.
const SPAN: (f64, f64) = (78.0, 906.0);
/// Where each panel begins and ends.
const UPPER: (f64, f64) = (92.0, 366.0);
const LOWER: (f64, f64) = (400.0, 640.0);
/// Where the axes' titles stand.
const TITLES: [f64; 2] = [22.0, 962.0];
/// Where the names of switches stand.
const NAMES: f64 = 80.0;
/// Where the legend of each panel stands.
const LEGENDS: [f64; 2] = [54.0, 384.0];
/// Sizes of text (pixels).
const TITLE: f64 = 15.0;
const TEXT: f64 = 12.5;
/// From one entry of a legend to the next (pixels).
const ENTRY: f64 = 212.0;
/// Nearest names of switches (pixels).
const APART: f64 = 17.0;
/// Narrowest epoch that has its name (pixels).
const NARROWEST: f64 = 26.0;

/// Shades of B1 and B2, as pictures of `letoff simulate` have them.
const SHADES: [Color; 2] = [Color(253, 236, 205), Color(222, 235, 247)];
/// A switch of the model.
const SWITCH: Stroke = Stroke::new(INK, 1.6);
/// Where values are zero.
const ZERO: Stroke = Stroke::new(INK, 0.75).faint(0.6);
/// Width of the curves (pixels).
const WIDTH: f64 = 1.9;
/// The mode in which hammer and key are together.
const TOGETHER: &str = "B1";

/// A line that is no curve of the run.
const fn dashed(stroke: Stroke) -> Stroke {
    Stroke { is_dashed: true, ..stroke }
}

/// A curve of a panel: its name, its stroke, its axis, and its value where it has one.
struct Curve {
    name: &'static str,
    stroke: Stroke,
    /// 0 left, 1 right.
    axis: usize,
    value: fn(&RunRow) -> Option<f64>,
}

const fn curve(
    name: &'static str,
    color: usize,
    axis: usize,
    value: fn(&RunRow) -> Option<f64>,
) -> Curve {
    Curve { name, stroke: Stroke::new(CURVES[color], WIDTH), axis, value }
}

/// Whether hammer and key are together.
fn is_together(row: &RunRow) -> bool {
    row.mode == TOGETHER
}

const FORCES: [Curve; 3] = [
    curve("force F_KU on the hand", 0, 0, |row| Some(row.f_ku)),
    curve("guard in B1: force F_KH", 1, 0, |row| is_together(row).then_some(row.f_kh)),
    curve("guard in B2: gap", 2, 1, |row| (!is_together(row)).then_some(1e3 * row.gap)),
];

const ANGLES: [Curve; 3] = [
    curve("manipulandum s", 5, 0, |row| Some(row.s)),
    curve("key θk", 1, 0, |row| Some(row.key)),
    curve("hammer θh", 2, 0, |row| Some(row.hammer)),
];

/// Draws a run under a title as SVG text; the string is at the angle `string` (rad).
pub(super) fn svg(title: &str, run: &ModelRun, string: f64) -> String {
    let mut canvas = Canvas::new(SIZE);
    let time = Axis::linear(&(0.0..run.end()), SPAN);
    let figure = Figure { run, time };
    let forces = figure.force_axes();
    let mut angles = extent(run, &ANGLES, 0);
    angles = (angles.0, angles.1.max(string));
    let angles = [Axis::linear(&roomy(angles), (LOWER.1, LOWER.0)); 2];
    for span in [UPPER, LOWER] {
        figure.draw_shades(&mut canvas, span);
    }
    figure.draw_curves(&mut canvas, UPPER, &forces, &FORCES);
    figure.draw_curves(&mut canvas, LOWER, &angles, &ANGLES);
    for (curves, y) in [&FORCES, &ANGLES].into_iter().zip(LEGENDS) {
        for (row, curve) in curves.iter().enumerate() {
            let at = (SPAN.0 + ENTRY * row as f64, y);
            legend::draw_row(&mut canvas, at, curve.stroke, curve.name);
        }
    }
    let level = angles[0].place(string);
    canvas.line(&[(SPAN.0, level), (SPAN.1, level)], dashed(Stroke::new(INK, 1.0)));
    canvas.text("the string's angle", (SPAN.0 + 6.0, level + 10.0), TEXT, Anchor::Start);
    figure.draw_switches(&mut canvas);
    figure.draw_frame(&mut canvas, [&forces, &angles]);
    canvas.text(title, (SPAN.0, 20.0), TITLE, Anchor::Start);
    canvas.into_svg()
}

/// A run over its axis of time.
struct Figure<'a> {
    run: &'a ModelRun,
    time: Axis,
}

impl Figure<'_> {
    /// Axes of forces (N) and of the gap (mm), which begins at zero and at the forces' zero.
    fn force_axes(&self) -> [Axis; 2] {
        /// Highest gap, as a part of the room above zero.
        const GAP: f64 = 0.85;
        let forces = roomy(extent(self.run, &FORCES, 0));
        let (_, gap) = extent(self.run, &FORCES, 1);
        let per_newton = gap.max(1.0) / (GAP * forces.end.max(1.0));
        let gaps = 0.0..per_newton * forces.end;
        let forces = Axis::linear(&forces, (UPPER.1, UPPER.0));
        [forces, Axis::linear(&gaps, (forces.place(0.0), UPPER.0))]
    }

    /// Epochs as (start, end, mode), with their times (s).
    fn epochs(&self) -> Vec<(f64, f64, &'static str)> {
        let mut epochs = Vec::new();
        let first = self.run.rows.first().map_or("", |row| row.mode);
        let mut now = (0.0, first);
        for RunEvent { t, to, .. } in self.switches() {
            epochs.push((now.0, *t, now.1));
            now = (*t, *to);
        }
        epochs.push((now.0, self.run.end(), now.1));
        epochs
    }

    fn switches(&self) -> impl Iterator<Item = &RunEvent> {
        self.run.events.iter().filter(|event| event.from != event.to)
    }

    fn draw_shades(&self, canvas: &mut Canvas, (top, bottom): (f64, f64)) {
        for (start, end, mode) in self.epochs() {
            let [left, right] = [start, end].map(|t| self.time.place(t));
            let shade = SHADES[usize::from(mode != TOGETHER)];
            canvas.fill([(left, top), (right, bottom)], shade);
            if right - left >= NARROWEST {
                canvas.text(mode, (left + 5.0, bottom - 11.0), TEXT, Anchor::Start);
            }
        }
    }

    /// Draws grid and curves of a panel.
    fn draw_curves(
        &self,
        canvas: &mut Canvas,
        (top, bottom): (f64, f64),
        axes: &[Axis; 2],
        curves: &[Curve],
    ) {
        let panel = [(SPAN.0, top), (SPAN.1, bottom)];
        for (axis, side) in [(&self.time, PanelSide::Below), (&axes[0], PanelSide::Left)] {
            PanelEdge { axis, side, panel, wanted: NUMBERS }.draw_grid(canvas);
        }
        let zero = axes[0].place(0.0);
        canvas.line(&[(SPAN.0, zero), (SPAN.1, zero)], ZERO);
        for curve in curves {
            for stretch in stretches(self.run, curve) {
                let place =
                    |(t, value): &(f64, f64)| (self.time.place(*t), axes[curve.axis].place(*value));
                canvas.line(&stretch.iter().map(place).collect::<Vec<_>>(), curve.stroke);
            }
        }
    }

    /// Draws the switches over both panels with their names, and strikes of the string.
    fn draw_switches(&self, canvas: &mut Canvas) {
        let (top, bottom) = (UPPER.0, LOWER.1);
        let mut free = f64::NEG_INFINITY;
        let mut number = 0;
        for event in &self.run.events {
            let x = self.time.place(event.t);
            let is_switch = event.from != event.to;
            number += usize::from(is_switch);
            let stroke = if is_switch { SWITCH } else { dashed(SWITCH) };
            let spans = [(top, UPPER.1), (LOWER.0, bottom)];
            for (top, bottom) in spans {
                canvas.line(&[(x, top), (x, bottom)], stroke);
            }
            let (name, half) =
                if is_switch { (indexed(number), 0.5 * APART) } else { (STRING.to_owned(), APART) };
            if free <= x - half {
                free = x + half;
                canvas.text(&name, (x, NAMES), TEXT, Anchor::Middle);
            }
        }
    }

    /// Draws the axes with their numbers and titles, over all else.
    fn draw_frame(&self, canvas: &mut Canvas, [forces, angles]: [&[Axis; 2]; 2]) {
        for ((top, bottom), axes) in [(UPPER, forces), (LOWER, angles)] {
            let panel = [(SPAN.0, top), (SPAN.1, bottom)];
            let edge = |axis, side| PanelEdge { axis, side, panel, wanted: NUMBERS };
            edge(&axes[0], PanelSide::Left).draw_axis(canvas);
            let [a, b, c, d] = [(SPAN.0, bottom), (SPAN.0, top), (SPAN.1, top), (SPAN.1, bottom)];
            canvas.line(&[a, b, c, d, a], Stroke::new(INK, 0.75));
            // Both panels have one axis of time, and only forces have a second axis.
            if top < LOWER.0 {
                let panel = [panel[0], (SPAN.1, axes[1].place(0.0))];
                let right = edge(&axes[1], PanelSide::Right);
                PanelEdge { panel, wanted: 0.5 * NUMBERS, ..right }.draw_axis(canvas);
            } else {
                edge(&self.time, PanelSide::Below).draw_axis(canvas);
            }
        }
        let middle = |(top, bottom)| f64::midpoint(top, bottom);
        canvas.text("force [N]", (TITLES[0], middle(UPPER)), TEXT, Anchor::Upright);
        let gaps = (UPPER.0, forces[1].place(0.0));
        canvas.text("gap [mm]", (TITLES[1], middle(gaps)), TEXT, Anchor::Upright);
        canvas.text("angle [rad]", (TITLES[0], middle(LOWER)), TEXT, Anchor::Upright);
        let below = (f64::midpoint(SPAN.0, SPAN.1), LOWER.1 + 38.0);
        canvas.text("model time t [s]", below, TEXT, Anchor::Middle);
    }
}

/// About how many numbers an axis has.
const NUMBERS: f64 = 8.0;

/// A curve in stretches over which it has values: time (s) and value.
fn stretches(run: &ModelRun, curve: &Curve) -> Vec<Vec<(f64, f64)>> {
    let mut stretches = vec![Vec::new()];
    for row in &run.rows {
        match ((curve.value)(row), stretches.last_mut()) {
            (Some(value), Some(stretch)) => stretch.push((row.t, value)),
            (None, Some(stretch)) if !stretch.is_empty() => stretches.push(Vec::new()),
            _ => {}
        }
    }
    stretches.retain(|stretch| stretch.len() > 1);
    stretches
}

/// Lowest and highest value of the curves on an axis.
fn extent(run: &ModelRun, curves: &[Curve], axis: usize) -> (f64, f64) {
    let curves = curves.iter().filter(|curve| curve.axis == axis);
    let values = curves.flat_map(|curve| run.rows.iter().filter_map(curve.value));
    values.fold((0.0, 0.0), |(low, high), value| (value.min(low), value.max(high)))
}

/// A range with room at both ends, below for the names of epochs.
fn roomy((low, high): (f64, f64)) -> Range<f64> {
    let size = (high - low).max(1e-3);
    low - 0.13 * size..high + 0.06 * size
}

/// `t` with a number below its line.
fn indexed(number: usize) -> String {
    let digit = |digit: char| digit.to_digit(10).and_then(|it| char::from_u32(0x2080 + it));
    ['t'].into_iter().chain(number.to_string().chars().filter_map(digit)).collect()
}
