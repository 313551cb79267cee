//! What is drawn: a curve for each method and for each way of running another code.

use plotters::style::RGBColor;

use super::marker::Shape;
use super::quantity::CostErrorPoint;
use crate::accuracy::{MeasuredScenario, MethodKind};
use crate::report::peers::{Author, Peer};

/// A curve: runs from the coarsest to the finest.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub(super) name: String,
    pub(super) style: Style,
    pub(super) points: Vec<CostErrorPoint>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Style {
    pub(super) color: RGBColor,
    pub(super) shape: Shape,
    /// (pixels)
    pub(super) width: f64,
    /// Another code's: dashed, with hollow marks.
    pub(super) is_peer: bool,
}

/// Colours that differ for most eyes, after Okabe and Ito, without the yellow.
const COLORS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(118, 76, 36),
];
const BLACK: RGBColor = RGBColor(0, 0, 0);
/// The choice by need.
const GREY: RGBColor = RGBColor(125, 125, 125);

/// The curves of our methods.
pub(super) fn methods(measured: &MeasuredScenario) -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    for row in &measured.rows {
        let name = row.method.name;
        if curves.last().is_none_or(|curve| curve.name != name) {
            let style = ours(curves.len(), row.method.kind);
            curves.push(Curve { name: name.to_owned(), style, points: Vec::new() });
        }
        if let Some(curve) = curves.last_mut() {
            curve.points.push(CostErrorPoint::of(row));
        }
    }
    curves
}

/// The curves of the codes that were run side by side on a problem that ends `until` (s).
pub(super) fn peers(peers: &[&Peer], until: f64) -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    for peer in peers {
        let (name, point) = (peer.curve(), CostErrorPoint::of_peer(peer, until));
        if let Some(curve) = curves.iter_mut().find(|curve| curve.name == name) {
            curve.points.push(point);
        } else {
            curves.push(Curve { name, style: of_peer(peer, peers), points: vec![point] });
        }
    }
    // Ours lie on top.
    curves.sort_by_key(|curve| !curve.style.is_peer);
    curves
}

fn ours(index: usize, kind: MethodKind) -> Style {
    let style = Style {
        color: COLORS[index % COLORS.len()],
        shape: Shape::ALL[index % Shape::ALL.len()],
        width: 1.6,
        is_peer: false,
    };
    let broad = Style { shape: Shape::Circle, width: 2.6, ..style };
    match kind {
        MethodKind::Fixed | MethodKind::Controlled => style,
        // What instruments play stands out.
        MethodKind::Played => Style { color: BLACK, ..broad },
        MethodKind::Budgeted => Style { color: GREY, ..broad },
    }
}

/// A colour for each code, a shape for each way of running it; ours is black.
fn of_peer(peer: &Peer, peers: &[&Peer]) -> Style {
    let mut codes: Vec<&str> = Vec::new();
    let mut ways: Vec<String> = Vec::new();
    for other in peers {
        if other.author() != Author::Ours && !codes.contains(&other.code.as_str()) {
            codes.push(&other.code);
        }
        let way = other.curve();
        if other.code == peer.code && !ways.contains(&way) {
            ways.push(way);
        }
    }
    let code = codes.iter().position(|code| *code == peer.code);
    let way = ways.iter().position(|way| *way == peer.curve()).unwrap_or(0);
    Style {
        color: code.map_or(BLACK, |code| COLORS[code % COLORS.len()]),
        shape: Shape::ALL[way % Shape::ALL.len()],
        width: if code.is_none() { 2.2 } else { 1.2 },
        is_peer: code.is_some(),
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::report::peers::read;

    fn looks(style: &Style) -> (RGBColor, Shape, bool) {
        (style.color, style.shape, style.is_peer)
    }

    #[test]
    fn no_two_curves_of_a_plot_look_the_same() {
        let results =
            concat!(env!("CARGO_MANIFEST_DIR"), "/../../benches/peers/results/results.json");
        let all = read(Path::new(results)).expect("the committed results");
        for problem in ["figure-6", "ball", "stiff-10"] {
            let rows: Vec<_> = all.iter().filter(|peer| peer.problem == problem).collect();
            let curves = peers(&rows, 1.0);
            assert!(curves.len() > 20, "{problem}: {}", curves.len());
            for (i, curve) in curves.iter().enumerate() {
                let twin = curves[..i].iter().find(|it| looks(&it.style) == looks(&curve.style));
                assert!(twin.is_none(), "{problem}: {} and {twin:?}", curve.name);
            }
        }
        let own: Vec<_> = (0..30).map(|index| looks(&ours(index, MethodKind::Fixed))).collect();
        for (i, look) in own.iter().enumerate() {
            assert!(!own[..i].contains(look), "method {i}");
        }
    }
}
