//! A picture of curves over one pair of axes, with a legend beside them.

use super::axis::Axis;
use super::canvas::{Anchor, Canvas, Pixel};
use super::color::Stroke;
use super::edge::{PanelEdge, PanelSide};
use super::legend;

/// Size of the picture (pixels).
const SIZE: Pixel = (860.0, 380.0);
/// Upper left and lower right corner of the panel (pixels).
const PANEL: [Pixel; 2] = [(62.0, 46.0), (560.0, 330.0)];
/// Where the legend begins (pixels).
const LEGEND: Pixel = (584.0, 56.0);
/// Size of the titles' text (pixels).
const TEXT: f64 = 12.0;
/// Radius of a marker (pixels).
const MARKER: f64 = 2.6;
/// About how many numbers an axis has.
const NUMBERS: f64 = 8.0;

/// How values lie on both axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Scales {
    Linear,
    Logarithmic,
    /// Logarithmic across, linear up.
    SemiLogarithmic,
    /// Linear across, logarithmic up.
    LogarithmicUp,
}

impl Scales {
    /// Whether values lie linearly across and up.
    const fn are_linear(self) -> [bool; 2] {
        match self {
            Self::Linear => [true, true],
            Self::Logarithmic => [false, false],
            Self::SemiLogarithmic => [false, true],
            Self::LogarithmicUp => [true, false],
        }
    }
}

/// A curve of a chart.
#[derive(Clone, Debug)]
pub struct ChartCurve {
    pub name: String,
    pub stroke: Stroke,
    pub look: CurveLook,
    pub points: Vec<(f64, f64)>,
}

/// How the points of a curve are joined.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CurveLook {
    Line,
    /// A line with a mark at each point.
    Marked,
    /// Marks without a line between them.
    Marks,
}

/// Curves, and what their axes are.
#[derive(Clone, Debug)]
pub struct Chart {
    pub title: &'static str,
    pub x_title: &'static str,
    pub y_title: &'static str,
    pub scales: Scales,
    pub curves: Vec<ChartCurve>,
}

impl Chart {
    /// Draws it as SVG text.
    pub fn svg(&self) -> String {
        let mut canvas = Canvas::new(SIZE);
        let [(left, top), (right, bottom)] = PANEL;
        let [x, y] = self.axes();
        for (axis, side) in [(&x, PanelSide::Below), (&y, PanelSide::Left)] {
            let edge = PanelEdge { axis, side, panel: PANEL, wanted: NUMBERS };
            edge.draw_grid(&mut canvas);
            edge.draw_axis(&mut canvas);
        }
        canvas.text(self.title, (left, 0.35 * top), 15.0, Anchor::Start);
        canvas.text(self.y_title, (left, top - 11.0), TEXT, Anchor::Start);
        canvas.text(self.x_title, (0.5 * (left + right), bottom + 32.0), TEXT, Anchor::Middle);
        for (row, curve) in self.curves.iter().enumerate() {
            curve.draw(&mut canvas, [&x, &y]);
            let at = (LEGEND.0, LEGEND.1 + row as f64 * legend::ROW);
            let middle = legend::draw_row(&mut canvas, at, curve.stroke, &curve.name);
            if curve.look != CurveLook::Line {
                canvas.circle(middle, MARKER, curve.stroke.color, curve.stroke);
            }
        }
        canvas.into_svg()
    }

    fn axes(&self) -> [Axis; 2] {
        let [(left, top), (right, bottom)] = PANEL;
        let points = || self.curves.iter().flat_map(|curve| &curve.points);
        let (across, up) = ((left, right), (bottom, top));
        let axis = |is_linear: bool, values: Vec<f64>, places| {
            if is_linear {
                Axis::linear(&range(&values), places)
            } else {
                Axis::logarithmic(values.into_iter(), places)
            }
        };
        let x = points().map(|it| it.0).collect();
        let y = points().map(|it| it.1).collect();
        let [x_linear, y_linear] = self.scales.are_linear();
        [axis(x_linear, x, across), axis(y_linear, y, up)]
    }
}

/// The range of `values` with a little room at both ends.
fn range(values: &[f64]) -> std::ops::Range<f64> {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if low >= high || !(high - low).is_finite() {
        return 0.0..1.0;
    }
    let room = 0.04 * (high - low);
    low - room..high + room
}

impl ChartCurve {
    fn draw(&self, canvas: &mut Canvas, [x, y]: [&Axis; 2]) {
        let places: Vec<Pixel> =
            self.points.iter().map(|point| (x.place(point.0), y.place(point.1))).collect();
        if self.look != CurveLook::Marks {
            canvas.line(&places, self.stroke);
        }
        if self.look != CurveLook::Line {
            for place in places {
                canvas.circle(place, MARKER, self.stroke.color, self.stroke);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::color::INK;
    use super::*;

    #[test]
    fn a_chart_has_its_curves_titles_and_names() {
        for scales in
            [Scales::Linear, Scales::Logarithmic, Scales::SemiLogarithmic, Scales::LogarithmicUp]
        {
            let curve = ChartCurve {
                name: "a grand".to_owned(),
                stroke: Stroke::new(INK, 1.5),
                look: CurveLook::Marked,
                points: vec![(0.5, 1.0), (2.0, 3.0)],
            };
            let chart =
                Chart { title: "T", x_title: "X", y_title: "Y", scales, curves: vec![curve] };
            let svg = chart.svg();
            for part in ["a grand", ">\nT\n<", ">\nX\n<", ">\nY\n<", "<polyline", "<circle"] {
                assert!(svg.contains(part), "{part} in {svg}");
            }
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        }
    }
}
