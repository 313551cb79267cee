//! A picture: panels of curves with their areas and rules, and a legend beside them.
//!
//! ```text
//!   title, notes                  labels of rules, upright
//!   y title | panel            |  names of what is in it
//!   y title | panel            |
//!              x title
//! ```
//!
//! Panels of one column share the x axis below the last.

use std::ops::Range;

use super::axis::{Axis, AxisScale};
use super::canvas::{Anchor, Canvas, Pixel};
use super::color::{Color, INK, Stroke};
use super::edge::{PanelEdge, PanelSide};
use super::marker::{self, MarkerShape};

/// Upper left corner of the first panel, without notes and labels (pixels).
const CORNER: Pixel = (92.0, 44.0);
/// Width of an axis beside a panel, and height of one below it (pixels).
const BESIDE: f64 = 76.0;
const BELOW: f64 = 58.0;
/// Gaps between panels of one column, and between rows of several (pixels).
const GAP: f64 = 12.0;
const ROW_GAP: f64 = 22.0;
/// Height of the strip with marks of failures (pixels).
const STRIP: f64 = 18.0;
const WRONG: Color = Color(251, 232, 228);
/// Width of the legend, and height of its rows (pixels).
const LEGEND: f64 = 316.0;
const ROW: f64 = 19.0;
/// Width of a sample in the legend (pixels).
const SAMPLE: f64 = 28.0;
/// Maximum length of a name in the legend (characters); the rest is cut.
const LONGEST: usize = 44;
/// Sizes of text (pixels).
const TITLE: f64 = 15.0;
const TEXT: f64 = 12.0;
const SMALL: f64 = 11.0;
/// Height of a letter of the labels above the panels, and their least distance (pixels).
const LETTER: f64 = 5.8;
const APART: f64 = 14.0;
/// Approximate distances of an axis's numbers, across and up (pixels).
const NUMBERS: [f64; 2] = [66.0, 36.0];
const LEADER: Stroke = Stroke::new(INK, 0.5);
const SLOPE: Stroke = Stroke::new(INK, 0.75).faint(0.7);
const ZERO: Stroke = Stroke::new(INK, 0.75).faint(0.6);

/// Panels row by row, with a title.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    pub title: String,
    pub notes: Vec<String>,
    /// Panels in a row; those of a single column share the x axis.
    pub columns: usize,
    /// Width and height of a panel (pixels).
    pub size: Pixel,
    pub panels: Vec<PicturePanel>,
    /// Lines across all panels of a single column.
    pub rules: Vec<PictureRule>,
    pub labels: Vec<(f64, String)>,
}

/// A pair of axes, with content in drawing order.
#[derive(Clone, Debug, Default)]
pub struct PicturePanel {
    pub x: PictureAxis,
    /// Left axis and optional right axis.
    pub y: Vec<PictureAxis>,
    pub areas: Vec<PictureArea>,
    pub curves: Vec<PictureCurve>,
    pub levels: Vec<(f64, String)>,
    /// Orders p with a triangle of the slope −p, where both axes are logarithmic.
    pub slopes: Vec<u32>,
}

/// An axis of a panel.
#[derive(Clone, Debug, Default)]
pub struct PictureAxis {
    pub title: String,
    pub scale: AxisScale,
    /// Values at its ends; if `None`, those of the curves with some room.
    pub ends: Option<(f64, f64)>,
    /// Names of the values 0, 1 and so on, instead of numbers.
    pub names: Vec<String>,
}

/// A coloured area of a panel.
#[derive(Clone, Debug)]
pub struct PictureArea {
    pub x: (f64, f64),
    /// Ends on the left axis; the whole height if `None`.
    pub y: Option<(f64, f64)>,
    pub color: Color,
    /// Name in the legend, and in the area itself if there is room.
    pub name: String,
    pub text: String,
}

/// A vertical line across the panels.
#[derive(Clone, Copy, Debug)]
pub struct PictureRule {
    pub at: f64,
    pub stroke: Stroke,
}

/// A curve of a panel.
#[derive(Clone, Debug)]
pub struct PictureCurve {
    pub name: String,
    pub stroke: Stroke,
    pub look: CurveLook,
    /// Number of its axis: 0 is left, 1 is right.
    pub axis: usize,
    pub stretches: Vec<Vec<Pixel>>,
    /// X positions of failed runs, marked above the panel.
    pub failures: Vec<f64>,
}

/// Style of a curve's points.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CurveLook {
    Line,
    Marked(MarkerShape),
    Marks(MarkerShape),
}

impl PictureAxis {
    pub fn linear(title: impl Into<String>) -> Self {
        Self { title: title.into(), ..Self::default() }
    }

    pub fn logarithmic(title: impl Into<String>) -> Self {
        Self { scale: AxisScale::Logarithmic, ..Self::linear(title) }
    }

    #[must_use]
    pub fn between(self, ends: (f64, f64)) -> Self {
        Self { ends: Some(ends), ..self }
    }

    fn axis(&self, values: impl Iterator<Item = f64>, places: Pixel) -> Axis {
        match (self.scale, self.ends) {
            (AxisScale::Linear, Some((low, high))) => Axis::linear(&(low..high), places),
            (AxisScale::Linear, None) => Axis::linear(&roomy(values), places),
            (AxisScale::Logarithmic, Some((low, high))) => Axis::decades(&(low..high), places),
            (AxisScale::Logarithmic, None) => Axis::logarithmic(values, places),
        }
    }
}

impl PictureCurve {
    pub fn new(
        name: impl Into<String>,
        stroke: Stroke,
        look: CurveLook,
        points: Vec<Pixel>,
    ) -> Self {
        let (name, failures) = (name.into(), Vec::new());
        Self { name, stroke, look, axis: 0, stretches: vec![points], failures }
    }

    fn points(&self) -> impl Iterator<Item = &Pixel> {
        self.stretches.iter().flatten()
    }

    const fn marker(&self) -> Option<MarkerShape> {
        match self.look {
            CurveLook::Line => None,
            CurveLook::Marked(shape) | CurveLook::Marks(shape) => Some(shape),
        }
    }

    fn draw(&self, canvas: &mut Canvas, drawn: &DrawnPanel<'_>) {
        let [(_, top), (_, bottom)] = drawn.corners;
        let y = &drawn.y[self.axis.min(drawn.y.len() - 1)];
        // Clip values beyond the panel at its edge.
        let place = |(x, value): &Pixel| (drawn.x.place(*x), y.place(*value).clamp(top, bottom));
        for stretch in &self.stretches {
            let places: Vec<_> = stretch.iter().map(place).collect();
            if !matches!(self.look, CurveLook::Marks(_)) {
                canvas.line(&places, self.stroke);
            }
            for (at, shape) in places.into_iter().zip(self.marker().into_iter().cycle()) {
                marker::draw(canvas, at, shape, self.stroke);
            }
        }
        for x in &self.failures {
            let at = (drawn.x.place(*x), top - 0.5 * STRIP);
            marker::draw_failure(canvas, at, self.stroke.color);
        }
    }
}

struct DrawnPanel<'a> {
    panel: &'a PicturePanel,
    corners: [Pixel; 2],
    x: Axis,
    y: Vec<Axis>,
    has_feet: bool,
    has_strip: bool,
}

enum LegendRow<'a> {
    Area(&'a PictureArea),
    Curve(&'a PictureCurve),
}

impl LegendRow<'_> {
    fn name(&self) -> &str {
        match self {
            Self::Area(area) => &area.name,
            Self::Curve(curve) => &curve.name,
        }
    }

    fn draw(&self, canvas: &mut Canvas, (left, y): Pixel) {
        let middle = (left + 0.5 * SAMPLE, y);
        match self {
            Self::Area(area) => {
                canvas.fill([(left, y - 6.0), (left + SAMPLE, y + 6.0)], area.color);
            }
            Self::Curve(curve) => {
                if !matches!(curve.look, CurveLook::Marks(_)) {
                    canvas.line(&[(left, y), (left + SAMPLE, y)], curve.stroke);
                }
                if let Some(shape) = curve.marker() {
                    marker::draw(canvas, middle, shape, curve.stroke);
                }
            }
        }
        canvas.text(&short(self.name()), (left + SAMPLE + 8.0, y), TEXT, Anchor::Start);
    }
}

impl Picture {
    pub fn of_panel(title: impl Into<String>, panel: PicturePanel) -> Self {
        let (title, panels) = (title.into(), vec![panel]);
        Self { title, columns: 1, size: (500.0, 284.0), panels, ..Self::default() }
    }

    pub fn has_points(&self) -> bool {
        self.panels.iter().flat_map(|it| &it.curves).any(|it| it.points().next().is_some())
    }

    pub fn svg(&self) -> String {
        let drawn: Vec<_> = (0..self.panels.len()).map(|number| self.place(number)).collect();
        let corner = drawn.last().map_or(CORNER, |it| it.corners[1]);
        let right = drawn.iter().map(|it| it.corners[1].0).fold(0.0, f64::max);
        let has_two = self.panels.iter().any(|it| it.y.len() > 1);
        let legend = self.legend(&drawn, right + if has_two { BESIDE } else { 24.0 });
        let lowest = legend.last().map_or(0.0, |(at, _)| at.1 + ROW);
        let width = right + LEGEND + if has_two { BESIDE } else { 24.0 };
        let mut canvas = Canvas::new((width, (corner.1 + BELOW).max(lowest)));
        canvas.text(&self.title, (CORNER.0, 18.0), TITLE, Anchor::Start);
        for (row, note) in self.notes.iter().enumerate() {
            canvas.text(note, (CORNER.0, 36.0 + 15.0 * row as f64), SMALL, Anchor::Start);
        }
        for it in &drawn {
            it.draw(&mut canvas);
        }
        if let [first, .., last] | [first @ last] = drawn.as_slice() {
            self.draw_rules(&mut canvas, first, last.corners[1].1);
        }
        for (at, row) in &legend {
            row.draw(&mut canvas, *at);
        }
        canvas.into_svg()
    }

    const fn is_stacked(&self) -> bool {
        self.columns == 1
    }

    fn has_failures(&self) -> bool {
        let mut curves = self.panels.iter().flat_map(|it| &it.curves);
        curves.any(|it| !it.failures.is_empty())
    }

    fn place(&self, number: usize) -> DrawnPanel<'_> {
        let panel = &self.panels[number];
        let (row, column) = (number / self.columns, number % self.columns);
        let strip = if self.has_failures() { STRIP } else { 0.0 };
        let letters = self.labels.iter().map(|(_, text)| text.chars().count()).max();
        let labels = letters.map_or(0.0, |it| LETTER * it as f64);
        let head = CORNER.1 + 15.0 * self.notes.len() as f64 + labels + strip;
        let gap = if self.is_stacked() { GAP } else { BELOW + ROW_GAP + strip };
        let left = CORNER.0 + column as f64 * (self.size.0 + CORNER.0);
        let top = head + row as f64 * (self.size.1 + gap);
        let (right, bottom) = (left + self.size.0, top + self.size.1);
        let shared = if self.is_stacked() { &self.panels[..] } else { std::slice::from_ref(panel) };
        let curves = shared.iter().flat_map(|it| &it.curves);
        let across = curves.flat_map(|it| it.points().map(|it| it.0).chain(it.failures.clone()));
        let up = |(axis, it): (usize, &PictureAxis)| {
            let curves = panel.curves.iter().filter(|it| it.axis == axis);
            it.axis(curves.flat_map(|it| it.points().map(|it| it.1)), (bottom, top))
        };
        let x = shared.first().unwrap_or(panel).x.axis(across, (left, right));
        let y = panel.y.iter().enumerate().map(up).collect();
        let has_feet = !self.is_stacked() || number + 1 == self.panels.len();
        let has_strip = self.has_failures();
        DrawnPanel { panel, corners: [(left, top), (right, bottom)], x, y, has_feet, has_strip }
    }

    fn legend<'a>(&self, drawn: &[DrawnPanel<'a>], left: f64) -> Vec<(Pixel, LegendRow<'a>)> {
        let first = drawn.first().map_or(0.0, |it| it.corners[0].1);
        let named = drawn.iter().flat_map(|it| {
            let areas = it.panel.areas.iter().map(LegendRow::Area);
            let rows = areas.chain(it.panel.curves.iter().map(LegendRow::Curve));
            let top = if self.is_stacked() { it.corners[0].1 } else { first };
            rows.map(move |row| (top + 8.0, row)).filter(|(_, row)| !row.name().is_empty())
        });
        let mut rows: Vec<(Pixel, LegendRow<'a>)> = Vec::new();
        for (top, row) in named {
            let below = rows.last().map_or(top, |(at, _)| top.max(at.1 + ROW));
            if !rows.iter().any(|it| it.1.name() == row.name()) {
                rows.push(((left, below), row));
            }
        }
        rows
    }

    fn draw_rules(&self, canvas: &mut Canvas, first: &DrawnPanel<'_>, bottom: f64) {
        let top = first.corners[0].1;
        for rule in &self.rules {
            let x = first.x.place(rule.at);
            canvas.line(&[(x, top), (x, bottom)], rule.stroke);
        }
        let mut free = f64::NEG_INFINITY;
        for (at, text) in &self.labels {
            let x = first.x.place(*at);
            let aside = x.max(free);
            free = aside + APART;
            canvas.line(&[(x, top), (aside, top - 10.0)], LEADER);
            canvas.text(text, (aside, top - 12.0), SMALL, Anchor::Rising);
        }
    }
}

impl DrawnPanel<'_> {
    fn draw(&self, canvas: &mut Canvas) {
        let [(left, top), (right, _)] = self.corners;
        self.panel.areas.iter().for_each(|area| self.draw_area(canvas, area));
        if self.has_strip {
            canvas.fill([(left, top - STRIP), (right, top)], WRONG);
            canvas.text("wrong", (left - 6.0, top - 0.5 * STRIP), SMALL, Anchor::End);
        }
        self.draw_axes(canvas);
        self.panel.curves.iter().for_each(|curve| curve.draw(canvas, self));
        self.draw_slopes(canvas);
        for (value, text) in &self.panel.levels {
            let y = self.y[0].place(*value);
            let stroke = Stroke { is_dashed: true, ..Stroke::new(INK, 1.0) };
            canvas.line(&[(left, y), (right, y)], stroke);
            canvas.text(text, (left + 6.0, y + 10.0), TEXT, Anchor::Start);
        }
    }

    /// Draws the triangles in the lower left corner, with their upright side in common.
    fn draw_slopes(&self, canvas: &mut Canvas) {
        let [(left, top), (right, bottom)] = self.corners;
        let decade = |axis: &Axis| (axis.place(10.0) - axis.place(1.0)).abs();
        // Width over height of the triangle of order 1.
        let first = decade(&self.x) / decade(&self.y[0]);
        let lowest = self.panel.slopes.iter().min().map_or(1.0, |order| f64::from(*order));
        let height = (0.4 * (bottom - top)).min(0.4 * (right - left) * lowest / first);
        let corner = (left + 8.0, bottom - 16.0);
        let mut free = f64::INFINITY;
        for order in &self.panel.slopes {
            let foot = (corner.0 + height * first / f64::from(*order), corner.1);
            canvas.line(&[corner, (corner.0, corner.1 - height), foot, corner], SLOPE);
            if foot.0 < free {
                canvas.text(&order.to_string(), (foot.0, corner.1 + 8.0), SMALL, Anchor::Middle);
                free = foot.0 - APART;
            }
        }
    }

    /// Fills an area between whole pixels, so that neighbours have no visible seam.
    fn draw_area(&self, canvas: &mut Canvas, area: &PictureArea) {
        let [(_, top), (_, bottom)] = self.corners;
        let [left, right] = [area.x.0, area.x.1].map(|x| self.x.place(x).round());
        let (top, bottom) = match area.y {
            Some((low, high)) => (self.y[0].place(high).round(), self.y[0].place(low).round()),
            None => (top, bottom),
        };
        // An area of one value must be visible.
        canvas.fill([(left, top), (right.max(left + 1.0), bottom)], area.color);
        let width = 0.62 * TEXT * area.text.chars().count() as f64;
        if width + 8.0 < right - left {
            canvas.text(&area.text, (left + 5.0, bottom - 11.0), TEXT, Anchor::Start);
        }
    }

    fn draw_axes(&self, canvas: &mut Canvas) {
        let [(left, top), (right, bottom)] = self.corners;
        let edge = |axis, side, length: f64, apart: f64| PanelEdge {
            axis,
            side,
            panel: self.corners,
            wanted: (length / apart).max(2.0),
        };
        let [across, up] = NUMBERS;
        let x = edge(&self.x, PanelSide::Below, right - left, across);
        let sides = [PanelSide::Left, PanelSide::Right];
        let y = self.y.iter().zip(sides).map(|(axis, side)| edge(axis, side, bottom - top, up));
        let y: Vec<_> = y.collect();
        for (edge, axis) in [(&x, &self.panel.x), (&y[0], &self.panel.y[0])] {
            if axis.names.is_empty() {
                edge.draw_grid(canvas);
            }
        }
        let zero = self.y[0].place(0.0);
        if self.panel.y[0].scale == AxisScale::Linear && (top..bottom).contains(&zero) {
            canvas.line(&[(left, zero), (right, zero)], ZERO);
        }
        let middle = (f64::midpoint(left, right), f64::midpoint(top, bottom));
        for (axis, edge) in self.panel.y.iter().zip(&y) {
            draw_numbers(canvas, axis, edge);
            let is_left = edge.side == PanelSide::Left;
            let at = if is_left { left - BESIDE } else { right + BESIDE - 14.0 };
            canvas.text(&axis.title, (at, middle.1), TEXT, Anchor::Upright);
        }
        if self.has_feet {
            draw_numbers(canvas, &self.panel.x, &x);
            canvas.text(&self.panel.x.title, (middle.0, bottom + 34.0), TEXT, Anchor::Middle);
        }
    }
}

fn draw_numbers(canvas: &mut Canvas, axis: &PictureAxis, edge: &PanelEdge<'_>) {
    if axis.names.is_empty() {
        return edge.draw_axis(canvas);
    }
    let [(left, _), (_, bottom)] = edge.panel;
    let is_shown =
        |value: usize| axis.ends.is_none_or(|(low, high)| (low..=high).contains(&(value as f64)));
    for (value, name) in axis.names.iter().enumerate().filter(|(value, _)| is_shown(*value)) {
        let place = edge.axis.place(value as f64);
        match edge.side {
            PanelSide::Below => canvas.text(name, (place, bottom + 13.0), TEXT, Anchor::Middle),
            PanelSide::Left | PanelSide::Right => {
                canvas.text(name, (left - 7.0, place), TEXT, Anchor::End);
            }
        }
    }
}

fn roomy(values: impl Iterator<Item = f64>) -> Range<f64> {
    let values = values.filter(|it| it.is_finite());
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low >= high || !(high - low).is_finite() {
        return 0.0..1.0;
    }
    let room = 0.04 * (high - low);
    low - room..high + room
}

fn short(name: &str) -> String {
    if name.chars().count() <= LONGEST {
        return name.to_owned();
    }
    name.chars().take(LONGEST - 1).chain(['…']).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_has_its_curves_titles_and_names() {
        for x in [PictureAxis::linear("X"), PictureAxis::logarithmic("X")] {
            let stroke = Stroke::new(INK, 1.5);
            let look = CurveLook::Marked(MarkerShape::Circle);
            let mut curve =
                PictureCurve::new("a grand", stroke, look, vec![(0.5, 1.0), (2.0, 3.0)]);
            curve.failures = vec![1.0];
            let color = Color(9, 9, 9);
            let (name, text) = ("mode".to_owned(), "B1".to_owned());
            let panel = PicturePanel {
                x,
                y: vec![PictureAxis::logarithmic("Y"), PictureAxis::linear("Z")],
                areas: vec![PictureArea { x: (0.5, 1.5), y: None, color, name, text }],
                curves: vec![curve],
                levels: vec![(2.0, "level".to_owned())],
                slopes: Vec::new(),
            };
            let mut picture = Picture::of_panel("T", panel);
            picture.labels = vec![(1.0, "rule".to_owned()), (1.0, "other".to_owned())];
            let svg = picture.svg();
            for text in ["T", "X", "Y", "Z", "a grand", "mode", "B1", "level", "rule", "other"] {
                assert!(svg.contains(&format!(">\n{text}\n<")), "{text} in {svg}");
            }
            for part in ["<polyline", "<circle", "#FBE8E4"] {
                assert!(svg.contains(part), "{part} in {svg}");
            }
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        }
    }
}
