//! What is drawn: a curve for each method and for each way of running another code.

use super::marker::{CurveStyle, MarkerShape};
use super::quantity::CostErrorPoint;
use crate::accuracy::{MeasuredScenario, MethodKind};
use crate::plot::color::{CURVES, Color, Stroke};
use crate::report::peers::{Author, Peer};

/// A curve: runs from the coarsest to the finest.
#[derive(Clone, Debug)]
pub(super) struct CostErrorCurve {
    pub(super) name: String,
    pub(super) style: CurveStyle,
    pub(super) points: Vec<CostErrorPoint>,
}

const BLACK: Color = Color(0, 0, 0);
/// The choice by need.
const GREY: Color = Color(125, 125, 125);

/// The curves of our methods.
pub(super) fn methods(measured: &MeasuredScenario) -> Vec<CostErrorCurve> {
    let mut curves: Vec<CostErrorCurve> = Vec::new();
    for row in &measured.rows {
        let name = row.method.name;
        if curves.last().is_none_or(|curve| curve.name != name) {
            let style = ours(curves.len(), row.method.kind);
            curves.push(CostErrorCurve { name: name.to_owned(), style, points: Vec::new() });
        }
        if let Some(curve) = curves.last_mut() {
            curve.points.push(CostErrorPoint::of(row));
        }
    }
    curves
}

/// The curves of the codes that were run side by side on a problem that ends `until` (s).
pub(super) fn peers(peers: &[&Peer], until: f64) -> Vec<CostErrorCurve> {
    let mut curves: Vec<CostErrorCurve> = Vec::new();
    for peer in peers {
        let (name, point) = (peer.curve(), CostErrorPoint::of_peer(peer, until));
        if let Some(curve) = curves.iter_mut().find(|curve| curve.name == name) {
            curve.points.push(point);
        } else {
            curves.push(CostErrorCurve { name, style: of_peer(peer, peers), points: vec![point] });
        }
    }
    // Ours lie on top.
    curves.sort_by_key(|curve| !curve.style.is_peer());
    curves
}

fn ours(index: usize, kind: MethodKind) -> CurveStyle {
    let broad = |color| CurveStyle { shape: MarkerShape::Circle, stroke: Stroke::new(color, 2.6) };
    match kind {
        MethodKind::Fixed | MethodKind::Controlled => CurveStyle {
            shape: MarkerShape::ALL[index % MarkerShape::ALL.len()],
            stroke: Stroke::new(CURVES[index % CURVES.len()], 1.6),
        },
        // What instruments play stands out.
        MethodKind::Played => broad(BLACK),
        MethodKind::Budgeted => broad(GREY),
    }
}

/// A colour for each code, a shape for each way of running it; ours is black.
fn of_peer(peer: &Peer, peers: &[&Peer]) -> CurveStyle {
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
    // Codes that share a colour have other shapes, as far as there are any.
    let turn = code.map_or(0, |code| code / CURVES.len() * (MarkerShape::ALL.len() / 2));
    let stroke = code.map_or(Stroke::new(BLACK, 2.2), |code| {
        let stroke = Stroke::new(CURVES[code % CURVES.len()], 1.2);
        Stroke { is_dashed: true, ..stroke }
    });
    CurveStyle { shape: MarkerShape::ALL[(way + turn) % MarkerShape::ALL.len()], stroke }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::report::peers::read;

    fn looks(style: &CurveStyle) -> (Color, MarkerShape, bool) {
        (style.stroke.color, style.shape, style.is_peer())
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
