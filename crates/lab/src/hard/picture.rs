//! Draws a row for each case and a column for each method, coloured by verdict.

use super::rows::HardRow;
use super::run::HardVerdict;
use figures::plot::canvas::{Anchor, Canvas};
use figures::plot::color::{Color, INK, Stroke};

/// Width of the names of cases, and height of the names of methods (pixels).
const LEFT: f64 = 300.0;
const TOP: f64 = 176.0;
/// Width and height of a cell (pixels).
const CELL: (f64, f64) = (56.0, 17.0);
/// Height of a topic's heading (pixels).
const HEADING: f64 = 22.0;
const TEXT: f64 = 11.5;

const fn color(verdict: HardVerdict) -> Color {
    match verdict {
        HardVerdict::Right => Color(178, 221, 204),
        HardVerdict::Refused => Color(206, 206, 206),
        HardVerdict::Reported => Color(178, 205, 235),
        HardVerdict::Rough => Color(250, 224, 158),
        HardVerdict::Wrong => Color(238, 160, 134),
    }
}

/// Draws the verdicts of all steps, the longest left, and the error at the shortest.
pub(super) fn picture(rows: &[HardRow]) -> String {
    let mut methods: Vec<&str> =
        rows.iter().take(1).flat_map(|it| &it.runs).map(|it| it.method).collect();
    methods.dedup();
    let topics = || rows.chunk_by(|a, b| a.case.topic == b.case.topic);
    let width = LEFT + CELL.0 * methods.len() as f64 + 24.0;
    let height = TOP + CELL.1 * rows.len() as f64 + HEADING * topics().count() as f64 + 12.0;
    let mut canvas = Canvas::new((width, height));
    canvas.text("Hard cases by every method", (12.0, 18.0), 15.0, Anchor::Start);
    draw_legend(&mut canvas);
    for (column, method) in methods.iter().enumerate() {
        let x = LEFT + CELL.0 * (column as f64 + 0.5);
        canvas.text(method, (x, TOP - 4.0), TEXT, Anchor::Rising);
    }
    let mut top = TOP;
    for topic in topics() {
        canvas.text(&topic[0].case.topic, (12.0, top + 13.0), 12.5, Anchor::Start);
        canvas.line(&[(12.0, top + 2.0), (width - 12.0, top + 2.0)], Stroke::new(INK, 0.5));
        top += HEADING;
        for row in topic {
            draw_row(&mut canvas, row, top, &methods);
            top += CELL.1;
        }
    }
    canvas.into_svg()
}

fn draw_legend(canvas: &mut Canvas) {
    let notes = [
        "Each cell: four steps, the longest left;",
        "the number: largest error of a time",
        "(s) or value at the shortest step.",
    ];
    for (line, note) in notes.into_iter().enumerate() {
        canvas.text(note, (12.0, 38.0 + 15.0 * line as f64), TEXT, Anchor::Start);
    }
    for (line, verdict) in HardVerdict::ALL.into_iter().enumerate() {
        let y = 86.0 + 17.0 * line as f64;
        canvas.fill([(12.0, y), (40.0, y + 13.0)], color(verdict));
        canvas.text(verdict.title(), (48.0, y + 6.5), TEXT, Anchor::Start);
    }
}

fn draw_row(canvas: &mut Canvas, row: &HardRow, top: f64, methods: &[&str]) {
    let middle = top + 0.5 * CELL.1;
    let mark = if row.failures().is_empty() { "" } else { " ✗" };
    let name = format!("{}{mark}", row.case.name);
    canvas.text(&name, (LEFT - 8.0, middle), TEXT, Anchor::End);
    for (column, method) in methods.iter().enumerate() {
        let left = LEFT + CELL.0 * column as f64;
        let runs: Vec<_> = row.runs.iter().filter(|it| it.method == *method).collect();
        let width = (CELL.0 - 1.0) / runs.len().max(1) as f64;
        let mut from = left;
        for same in runs.chunk_by(|a, b| a.verdict == b.verdict) {
            let to = from + width * same.len() as f64;
            canvas.fill([(from, top), (to, top + CELL.1 - 1.0)], color(same[0].verdict));
            from = to;
        }
        if let Some(error) = runs.last().and_then(|it| it.error()) {
            let text = if error == 0.0 { "0".to_owned() } else { format!("{error:.0e}") };
            canvas.text(&text, (left + 0.5 * CELL.0, middle), 10.5, Anchor::Middle);
        }
    }
}
