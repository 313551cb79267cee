//! The figure: force and guards above, three angles below, epochs shaded, switches as lines.

use super::model_run::{ModelRun, RunEvent, RunRow};
use super::outcome::STRING;
use figures::plot::color::{CURVES, INK, MODES, Stroke};
use figures::plot::level::level;
use figures::plot::picture::{
    CurveLook, Picture, PictureArea, PictureAxis, PictureCurve, PicturePanel, PictureRule,
};

const SWITCH: Stroke = Stroke::new(INK, 1.6);
/// Width of the curves (pixels).
const WIDTH: f64 = 1.9;
const TOGETHER: &str = "B1";

/// Draws a run under a title, with the string at the angle `string` (rad).
pub(super) fn picture(title: &str, run: &ModelRun, string: f64) -> Picture {
    let is_together = |row: &RunRow| row.mode == TOGETHER;
    let force = curve(run, "force F_KU on the hand", 0, |row| Some(row.f_ku));
    let contact =
        curve(run, "guard in B1: force F_KH", 1, |row| is_together(row).then_some(row.f_kh));
    let gap = curve(run, "guard in B2: gap", 2, |row| (!is_together(row)).then_some(1e3 * row.gap));
    let gap = PictureCurve { axis: 1, ..gap };
    let curves = vec![force, contact, gap];
    let [forces, gaps] = level([extent(&curves[..2]), extent(&curves[2..])]);
    let forces = PicturePanel {
        x: PictureAxis::linear("model time t [s]").between((0.0, run.end())),
        y: vec![
            PictureAxis::linear("force [N]").between(forces),
            PictureAxis::linear("gap [mm]").between(gaps),
        ],
        areas: areas(run),
        curves,
        ..PicturePanel::default()
    };
    let angles = vec![
        curve(run, "manipulandum s", 5, |row| Some(row.s)),
        curve(run, "key θk", 1, |row| Some(row.key)),
        curve(run, "hammer θh", 2, |row| Some(row.hammer)),
    ];
    let [ends] = level([extent(&angles).map(|(low, high)| (low, high.max(string)))]);
    let angles = PicturePanel {
        x: forces.x.clone(),
        y: vec![PictureAxis::linear("angle [rad]").between(ends)],
        areas: areas(run),
        curves: angles,
        levels: vec![(string, "the string's angle".to_owned())],
        ..PicturePanel::default()
    };
    Picture {
        title: title.to_owned(),
        columns: 1,
        size: (820.0, 260.0),
        panels: vec![forces, angles],
        rules: run.events.iter().map(rule).collect(),
        labels: labels(run),
        ..Picture::default()
    }
}

fn curve(
    run: &ModelRun,
    name: &str,
    color: usize,
    value: impl Fn(&RunRow) -> Option<f64>,
) -> PictureCurve {
    let stroke = Stroke::new(CURVES[color], WIDTH);
    let runs = run.rows.chunk_by(|a, b| value(a).is_some() == value(b).is_some());
    let stretches = runs.map(|rows| rows.iter().filter_map(|row| Some((row.t, value(row)?))));
    let stretches = stretches.map(Iterator::collect).filter(|it: &Vec<_>| it.len() > 1).collect();
    PictureCurve { stretches, ..PictureCurve::new(name, stroke, CurveLook::Line, Vec::new()) }
}

fn extent(curves: &[PictureCurve]) -> Option<(f64, f64)> {
    let points = curves.iter().flat_map(|it| it.stretches.iter().flatten());
    let ends = points.map(|point| (point.1, point.1));
    ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

fn areas(run: &ModelRun) -> Vec<PictureArea> {
    let first = run.rows.first().map_or("", |row| row.mode);
    let switches = run.events.iter().filter(|event| event.from != event.to);
    let begins = std::iter::once((0.0, first)).chain(switches.map(|event| (event.t, event.to)));
    let begins: Vec<_> = begins.chain([(run.end(), "")]).collect();
    let area = |pair: &[(f64, &str)]| PictureArea {
        x: (pair[0].0, pair[1].0),
        y: None,
        color: MODES[usize::from(pair[0].1 != TOGETHER)],
        name: format!("mode {}", pair[0].1),
        text: pair[0].1.to_owned(),
    };
    begins.windows(2).map(area).collect()
}

fn rule(event: &RunEvent) -> PictureRule {
    PictureRule { at: event.t, stroke: Stroke { is_dashed: event.from == event.to, ..SWITCH } }
}

fn labels(run: &ModelRun) -> Vec<(f64, String)> {
    let mut number = 0_u32;
    let label = |event: &RunEvent| {
        if event.from == event.to {
            return (event.t, STRING.to_owned());
        }
        number += 1;
        let digits = number.to_string();
        let digit = |it: char| it.to_digit(10).and_then(|it| char::from_u32(0x2080 + it));
        (event.t, std::iter::once('t').chain(digits.chars().filter_map(digit)).collect())
    };
    run.events.iter().map(label).collect()
}
