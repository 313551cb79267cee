//! Draws a scenario's errors against costs, on logarithmic axes.
//!
//! ```text
//!   event error / ns per ms      state error / ns per ms       legend
//!   force error / ns per ms      event error / ns of the worst tick
//!   event error / ns of a tick without, with one, with the most events
//! ```
//!
//! A second picture has the errors against counted evaluations, and a third compares codes that
//! were run side by side.

use super::peers::{Author, Peer};
use crate::accuracy::{
    EnergyDrift, METHODS, MeasuredScenario, MethodGroup, MethodKind, NamedMethod, StudyRow,
};
use figures::plot::color::{CURVES, Color, Stroke};
use figures::plot::marker::MarkerShape;
use figures::plot::picture::{CurveLook, Picture, PictureAxis, PictureCurve, PicturePanel};

pub(super) fn methods(measured: &MeasuredScenario) -> Picture {
    ours(measured, &TIMED)
}

/// Draws the errors against counts, which are the same on every machine.
pub(super) fn counts(measured: &MeasuredScenario) -> Picture {
    ours(measured, &COUNTED)
}

fn ours(measured: &MeasuredScenario, panels: &[Quantities]) -> Picture {
    let curves = curves(measured);
    let mut picture = picture(title(measured), panels, &curves);
    picture.notes.splice(0..0, [GROUPS, LINES].map(str::to_owned));
    let least = measured.rows.first().map_or([0.0; 2], |row| row.verdict.least_errors);
    for (panel, quantities) in picture.panels.iter_mut().zip(panels) {
        let least = least[usize::from(quantities.y_title != EVENTS.0)];
        let reaches = curves.iter().flat_map(|it| &it.points).filter_map(quantities.y);
        if least > 0.0 && reaches.fold(f64::INFINITY, f64::min) <= least {
            panel.levels.push((least, String::new()));
        }
        if quantities.x_title.ends_with(RATE) {
            panel.slopes = slopes(measured);
        }
    }
    picture
}

const GROUPS: &str = "Blue: explicit. Orange: long steps by a tolerance. Green: implicit. \
    Purple: exact and by need. Black: as played.";
const LINES: &str =
    "Triangles: slopes of the orders. Dashed: least error that the reference shows.";

/// Returns the orders of the methods whose step is the tick.
fn slopes(measured: &MeasuredScenario) -> Vec<u32> {
    let rows = measured.rows.iter().filter(|row| row.method.kind == MethodKind::Fixed);
    let mut orders: Vec<u32> = rows.map(|row| row.method.order).filter(|it| *it < 9).collect();
    orders.sort_unstable();
    orders.dedup();
    orders
}

pub(super) const LONG_RUN_TEXT: &str = "A hammer head that bounces on a lossless spring, five \
    times a second, with a contact of 10 ms: the largest error of its energy so far, of the energy \
    at the start. Steps are ticks of 1 ms; methods with a tolerance have 1e-10, by-need a budget of \
    1e-8.";

/// Draws the error of the energy against time.
pub(super) fn drifts(drifts: &[EnergyDrift]) -> Picture {
    let curve = |drift: &EnergyDrift| {
        let CurveStyle { shape, stroke } = style(drift.method);
        let look = CurveLook::Marked(shape);
        PictureCurve::new(drift.method.name, stroke, look, drift.points.clone())
    };
    let panel = PicturePanel {
        x: PictureAxis::logarithmic("time [s]"),
        y: vec![PictureAxis::logarithmic("error of the energy, of its size")],
        curves: drifts.iter().map(curve).collect(),
        ..PicturePanel::default()
    };
    let picture = Picture::of_panel("Energy over long runs", panel);
    Picture { notes: vec![GROUPS.to_owned()], size: (620.0, 420.0), ..picture }
}

pub(super) fn peers(measured: &MeasuredScenario, peers: &[&Peer]) -> Picture {
    let title = format!("{}, side by side with other codes", title(measured));
    picture(title, &THEIRS, &peer_curves(peers, measured.plan.until))
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

fn curves(measured: &MeasuredScenario) -> Vec<CostErrorCurve> {
    let mut curves: Vec<CostErrorCurve> = Vec::new();
    for row in &measured.rows {
        let name = row.method.name;
        if curves.last().is_none_or(|curve| curve.name != name) {
            let style = style(row.method);
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

/// Returns a shade of the group's colour and a mark, which no other method of the group has.
fn style(method: &NamedMethod) -> CurveStyle {
    let same = METHODS.iter().filter(|it| it.group == method.group);
    let index = same.take_while(|it| it.name != method.name).count();
    let shades: &[Color] = match method.group {
        MethodGroup::Explicit => &[Color(0, 114, 178), Color(86, 180, 233), Color(0, 52, 110)],
        MethodGroup::LongStep => &[Color(213, 94, 0), Color(240, 165, 30)],
        MethodGroup::Implicit => &[Color(0, 158, 115), Color(120, 190, 60)],
        MethodGroup::Chosen => &[Color(204, 121, 167), Color(120, 60, 150)],
        MethodGroup::Played => &[BLACK],
    };
    let width = if method.group == MethodGroup::Played { 2.6 } else { 1.6 };
    CurveStyle {
        shape: MarkerShape::ALL[index % MarkerShape::ALL.len()],
        stroke: Stroke::new(shades[index % shades.len()], width),
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

/// End of the titles of costs in inverse proportion to the step.
const RATE: &str = "per simulated ms";
const PER_MS: (&str, PointFigure) = ("ns per simulated ms", |point| point.per_ms);
const EVALUATIONS: (&str, PointFigure) =
    ("evaluations of the derivative per simulated ms", |point| point.evaluations);

const EVENTS: (&str, PointFigure) = ("error of event times [s]", |point| point.event_error);
const STATES: (&str, PointFigure) =
    ("error of states away from events, of their size", |point| point.state_error);

const fn panel(y: (&'static str, PointFigure), x: (&'static str, PointFigure)) -> Quantities {
    Quantities { x_title: x.0, y_title: y.0, x: x.1, y: y.1 }
}

const TIMED: [Quantities; 7] = [
    panel(EVENTS, PER_MS),
    panel(STATES, PER_MS),
    panel(("error of the force, of its size", |point| point.force_error), PER_MS),
    panel(EVENTS, ("ns of the worst tick", |point| point.worst_tick)),
    panel(EVENTS, ("ns of a tick without event", |point| point.without_event)),
    panel(EVENTS, ("ns of a tick with one event", |point| point.with_one_event)),
    panel(EVENTS, ("ns of a tick with the most events", |point| point.with_most_events)),
];

const COUNTED: [Quantities; 2] = [panel(EVENTS, EVALUATIONS), panel(STATES, EVALUATIONS)];

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
        let own: Vec<_> = METHODS.iter().map(|method| looks(&style(method))).collect();
        for (i, look) in own.iter().enumerate() {
            assert!(!own[..i].contains(look), "{}", METHODS[i].name);
        }
    }
}
