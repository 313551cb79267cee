//! Draws a scenario's errors against costs, on logarithmic axes.
//!
//! ```text
//!   event error / ns per ms      event error / evaluations     legend
//!   state error / ns per ms      force error / ns per ms
//!   event error / ns of a tick without, with one, with the most events, of the worst tick
//! ```
//!
//! A second picture compares the errors of codes that were run side by side.

use super::peers::{Author, Peer};
use crate::accuracy::{MeasuredScenario, MethodKind, StudyRow};
use figures::plot::color::{CURVES, Color, Stroke};
use figures::plot::marker::MarkerShape;
use figures::plot::picture::{CurveLook, Picture, PictureAxis, PictureCurve, PicturePanel};

pub(super) fn methods(measured: &MeasuredScenario) -> Picture {
    picture(title(measured), &OURS, &curves(measured))
}

pub(super) fn peers(measured: &MeasuredScenario, peers: &[&Peer]) -> Picture {
    let title = format!("{}, side by side with other codes", title(measured));
    picture(title, &THEIRS, &peer_curves(peers, measured.until))
}

fn title(measured: &MeasuredScenario) -> String {
    format!("{}: {}", measured.entry.name, measured.entry.title)
}

fn picture(title: String, panels: &[Quantities], curves: &[CostErrorCurve]) -> Picture {
    let panel = |it: &Quantities| PicturePanel {
        x: PictureAxis::logarithmic(it.x_title),
        y: vec![PictureAxis::logarithmic(it.y_title)],
        curves: curves.iter().map(|curve| curve.against(it)).collect(),
        ..PicturePanel::default()
    };
    Picture {
        title,
        notes: vec!["A cross above a panel: wrong events, or no end.".to_owned()],
        columns: 2,
        size: (400.0, 232.0),
        panels: panels.iter().map(panel).collect(),
        ..Picture::default()
    }
}

#[derive(Clone, Debug)]
struct CostErrorCurve {
    name: String,
    style: CurveStyle,
    points: Vec<CostErrorPoint>,
}

#[derive(Clone, Copy, Debug)]
struct CurveStyle {
    shape: MarkerShape,
    stroke: Stroke,
}

const BLACK: Color = Color(0, 0, 0);
const GREY: Color = Color(125, 125, 125);

fn curves(measured: &MeasuredScenario) -> Vec<CostErrorCurve> {
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

fn peer_curves(peers: &[&Peer], until: f64) -> Vec<CostErrorCurve> {
    let mut curves: Vec<CostErrorCurve> = Vec::new();
    for peer in peers {
        let (name, point) = (peer.curve(), CostErrorPoint::of_peer(peer, until));
        if let Some(curve) = curves.iter_mut().find(|curve| curve.name == name) {
            curve.points.push(point);
        } else {
            curves.push(CostErrorCurve { name, style: of_peer(peer, peers), points: vec![point] });
        }
    }
    // Our curves lie on top.
    curves.sort_by_key(|curve| !curve.style.stroke.is_dashed);
    curves
}

fn ours(index: usize, kind: MethodKind) -> CurveStyle {
    let broad = |color| CurveStyle { shape: MarkerShape::Circle, stroke: Stroke::new(color, 2.6) };
    match kind {
        MethodKind::Fixed | MethodKind::Controlled => CurveStyle {
            shape: MarkerShape::ALL[index % MarkerShape::ALL.len()],
            stroke: Stroke::new(CURVES[index % CURVES.len()], 1.6),
        },
        MethodKind::Played => broad(BLACK),
        MethodKind::Budgeted => broad(GREY),
    }
}

/// Returns a colour per code and a shape per way of running it; ours is black.
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
    // Codes that share a colour have different shapes, as far as there are any.
    let turn = code.map_or(0, |code| code / CURVES.len() * (MarkerShape::ALL.len() / 2));
    let stroke = code.map_or(Stroke::new(BLACK, 2.2), |code| {
        let stroke = Stroke::new(CURVES[code % CURVES.len()], 1.2);
        Stroke { is_dashed: true, ..stroke }
    });
    CurveStyle { shape: MarkerShape::ALL[(way + turn) % MarkerShape::ALL.len()], stroke }
}

impl CostErrorCurve {
    fn against(&self, quantities: &Quantities) -> PictureCurve {
        let place = |it: &CostErrorPoint| {
            let (x, y) = ((quantities.x)(it)?, (quantities.y)(it)?);
            it.is_right.then_some((x, y))
        };
        let runs = self.points.chunk_by(|a, b| place(a).is_some() == place(b).is_some());
        let stretches = runs.map(|run| run.iter().filter_map(place).collect()).collect();
        let wrong = self.points.iter().filter(|it| !it.is_right);
        let failures = wrong.filter_map(quantities.x).collect();
        let look = CurveLook::Marked(self.style.shape);
        let curve = PictureCurve::new(self.name.as_str(), self.style.stroke, look, Vec::new());
        PictureCurve { stretches, failures, ..curve }
    }
}

#[derive(Clone, Copy, Debug, Default)]
struct CostErrorPoint {
    is_right: bool,
    event_error: Option<f64>,
    state_error: Option<f64>,
    force_error: Option<f64>,
    per_ms: Option<f64>,
    evaluations: Option<f64>,
    without_event: Option<f64>,
    with_one_event: Option<f64>,
    with_most_events: Option<f64>,
    worst_tick: Option<f64>,
}

impl CostErrorPoint {
    fn of(row: &StudyRow) -> Self {
        let StudyRow { verdict, counts, times, .. } = row;
        Self {
            is_right: verdict.sequence.is_right(),
            event_error: verdict.event_error,
            state_error: verdict.state_error,
            force_error: verdict.force_error,
            per_ms: Some(times.per_ms),
            evaluations: Some(counts.evaluations_per_ms),
            without_event: times.without_event,
            with_one_event: times.with_one_event,
            with_most_events: times.with_most_events,
            worst_tick: Some(times.worst_tick),
        }
    }

    fn of_peer(peer: &Peer, until: f64) -> Self {
        Self {
            is_right: peer.sequence_ok,
            event_error: peer.event_error_s,
            state_error: peer.state_error,
            per_ms: peer.ns_per_ms_min,
            evaluations: peer.rhs.map(|rhs| rhs / (1e3 * until)),
            ..Self::default()
        }
    }
}

type PointFigure = fn(&CostErrorPoint) -> Option<f64>;

#[derive(Clone, Copy, Debug)]
struct Quantities {
    x_title: &'static str,
    y_title: &'static str,
    x: PointFigure,
    y: PointFigure,
}

const PER_MS: (&str, PointFigure) = ("ns per simulated ms", |point| point.per_ms);
const EVALUATIONS: (&str, PointFigure) =
    ("evaluations of the derivative per simulated ms", |point| point.evaluations);

const EVENTS: (&str, PointFigure) = ("error of event times [s]", |point| point.event_error);
const STATES: (&str, PointFigure) =
    ("error of states away from events, of their size", |point| point.state_error);

const fn panel(y: (&'static str, PointFigure), x: (&'static str, PointFigure)) -> Quantities {
    Quantities { x_title: x.0, y_title: y.0, x: x.1, y: y.1 }
}

const OURS: [Quantities; 8] = [
    panel(EVENTS, PER_MS),
    panel(EVENTS, EVALUATIONS),
    panel(STATES, PER_MS),
    panel(("error of the force, of its size", |point| point.force_error), PER_MS),
    panel(EVENTS, ("ns of a tick without event", |point| point.without_event)),
    panel(EVENTS, ("ns of a tick with one event", |point| point.with_one_event)),
    panel(EVENTS, ("ns of a tick with the most events", |point| point.with_most_events)),
    panel(EVENTS, ("ns of the worst tick", |point| point.worst_tick)),
];

const THEIRS: [Quantities; 4] = [
    panel(EVENTS, PER_MS),
    panel(EVENTS, EVALUATIONS),
    panel(STATES, PER_MS),
    panel(STATES, EVALUATIONS),
];

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::report::peers::read;

    fn looks(style: &CurveStyle) -> (Color, MarkerShape, bool) {
        (style.stroke.color, style.shape, style.stroke.is_dashed)
    }

    #[test]
    fn no_two_curves_of_a_plot_look_the_same() {
        let results =
            concat!(env!("CARGO_MANIFEST_DIR"), "/../../benches/peers/results/results.json");
        let all = read(Path::new(results)).expect("the committed results");
        for problem in ["figure-6", "ball", "stiff-10"] {
            let rows: Vec<_> = all.iter().filter(|peer| peer.problem == problem).collect();
            let curves = peer_curves(&rows, 1.0);
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
