//! A drawing as a picture, to be looked at.

use std::fmt::Write as _;

use models::draw::{Ends, Material};

use super::play::Moment;
use super::{Drawing, Point};

/// Width of a picture (pixels).
const WIDTH: f64 = 1400.0;

/// From metres to pixels.
struct Paper {
    left: f64,
    top: f64,
    scale: f64,
}

impl Paper {
    fn path(&self, points: &[Point]) -> String {
        let place = |[x, y]: &Point| {
            format!("{:.2},{:.2} ", (x - self.left) * self.scale, (self.top - y) * self.scale)
        };
        points.iter().map(place).collect()
    }
}

/// The drawing at `moment` as SVG text.
pub fn picture(drawing: &Drawing, moment: &Moment, title: &str) -> String {
    let [left, bottom, right, top] = drawing.views[0];
    let paper = Paper { left, top, scale: WIDTH / (right - left) };
    let height = (top - bottom) * paper.scale;
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{WIDTH}' height='{height:.0}'>\
         <rect width='100%' height='100%' fill='white'/>\
         <text x='20' y='30' font-size='18' font-family='sans-serif'>{title}</text>"
    );
    for part in drawing.parts.iter().filter(|it| it.is_shown(moment)) {
        for (index, outline) in part.outlines.iter().enumerate() {
            let points = paper.path(&part.placed(moment, index));
            svg += &shape(&points, outline.material, outline.ends);
        }
    }
    for (_, [from, to]) in drawing.coils(moment) {
        let points = paper.path(&zigzag(from, to, 10.0 / paper.scale));
        write!(svg, "<polyline points='{points}' fill='none' stroke='#c03030' stroke-width='2'/>")
            .expect("text");
    }
    svg + "</svg>"
}

fn shape(points: &str, material: Material, ends: Ends) -> String {
    let (fill, line) = match material {
        Material::Wood => ("#e6c89a", "#7a5a2a"),
        Material::Felt => ("#b8c8a8", "#50683c"),
        Material::Metal => ("#a0a4ac", "#404448"),
        Material::String => ("none", "#c08000"),
        Material::Ground => ("#d8d8d8", "#888888"),
        Material::Finger => ("#f2c4b0", "#a06850"),
    };
    let (shape, fill) = match ends {
        Ends::Open => ("polyline", "none"),
        Ends::Closed => ("polygon", fill),
    };
    format!("<{shape} points='{points}' fill='{fill}' stroke='{line}' stroke-width='2'/>")
}

fn zigzag(from: Point, to: Point, wide: f64) -> Vec<Point> {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let long = dx.hypot(dy).max(1e-12);
    let side = [-dy / long * wide, dx / long * wide];
    let at = |i: u32| {
        let t = f64::from(i) / 12.0;
        let aside = if i.is_multiple_of(2) { 0.5 } else { -0.5 };
        let k = if i == 0 || i == 12 { 0.0 } else { aside };
        [from[0] + t * dx + k * side[0], from[1] + t * dy + k * side[1]]
    };
    (0..=12).map(at).collect()
}
