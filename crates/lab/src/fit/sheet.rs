//! The report of a fit: one page, its charts, and the same for programs.

use std::path::Path;

use super::outcome::{FitOutcome, FittedParameter, FittedStroke, four_digits, with_unit};
use crate::piano::SHEET;
use crate::plot::chart::{Chart, ChartCurve, CurveLook, Scales};
use crate::plot::color::{CURVES, Color, Stroke};
use crate::report::page::{HtmlCell, STYLE, escape, table};
use crate::report::{DiskError, write_file};

/// Colour of what was measured.
const DATA: Color = Color(150, 150, 150);
/// What a reader must know before looking at a value.
const HOW: &str = "The front of the key is driven as it was measured, and its force is compared. \
    Intervals are of 95 %: they take the differences that remain for noise, whose neighbours may be \
    alike, and the model for linear within them.";

/// Writes the page, its charts, the parameters as CSV, and the instrument, a file's name and text
/// if there is one, into `folder`.
///
/// # Errors
/// When a file cannot be written; those that could are complete.
pub fn write_fit(
    folder: &Path,
    outcome: &FitOutcome,
    instrument: Option<(&str, &str)>,
) -> Result<(), DiskError> {
    let charts: Vec<_> = outcome.strokes.iter().map(charts).collect();
    for (number, pair) in charts.iter().enumerate() {
        for (name, chart) in ["force", "residual"].into_iter().zip(pair) {
            write_file(&folder.join(format!("{name}-{}.svg", number + 1)), &chart.svg())?;
        }
    }
    write_file(&folder.join("parameters.csv"), &csv(outcome))?;
    if let Some((file, text)) = instrument {
        write_file(&folder.join(file), text)?;
    }
    let file = instrument.map(|(file, _text)| file);
    write_file(&folder.join(SHEET), &page(outcome, &charts, file))
}

fn page(outcome: &FitOutcome, charts: &[[Chart; 2]], file: Option<&str>) -> String {
    let place = file.map_or_else(
        || "With these values it is no instrument on all keys, so none was written.".to_owned(),
        |file| format!("The instrument is in <code>{}</code>.", escape(file)),
    );
    let title = format!("{}, fitted", escape(&outcome.instrument));
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>Letoff: {title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>{title}</h1>\n<p class=\"read\">{HOW} {place}</p>\n",
    );
    let rows: Vec<_> = outcome.parameters.iter().map(cells).collect();
    page += &table(&["parameter", "name", "before", "fitted", "95 % interval"], &rows);
    for remark in &outcome.remarks {
        page += &["<p>", &escape(remark), "</p>\n"].concat();
    }
    page += &correlations(outcome);
    for (stroke, pair) in outcome.strokes.iter().zip(charts) {
        page += &heading(stroke);
        for chart in pair {
            page += &["<figure>\n", &chart.svg(), "</figure>\n"].concat();
        }
    }
    page + "</body>\n</html>\n"
}

/// A stroke's name, and how well it is followed.
fn heading(stroke: &FittedStroke) -> String {
    let FittedStroke { name, rows, noise, before, after, .. } = stroke;
    let name = escape(name);
    format!(
        "<h2>{name}</h2>\n<p>{rows} rows. Root mean square of the difference: {before:.3} N before, \
         {after:.3} N after; noise {noise:.3} N.</p>\n"
    )
}

fn cells(it: &FittedParameter) -> Vec<HtmlCell> {
    let interval = it.interval.map_or_else(
        || "not determined".to_owned(),
        |(low, high)| format!("{} to {}", four_digits(low), with_unit(high, it.unit)),
    );
    let value = |value| HtmlCell::Number(with_unit(value, it.unit));
    let words = [HtmlCell::words(&it.title), HtmlCell::words(it.name)];
    let numbers = [value(it.before), value(it.value), HtmlCell::Number(interval)];
    words.into_iter().chain(numbers).collect()
}

/// The table of correlations, of two parameters or more.
fn correlations(outcome: &FitOutcome) -> String {
    let known: Vec<_> = outcome.parameters.iter().filter(|it| it.interval.is_some()).collect();
    if known.len() < 2 {
        return String::new();
    }
    let header: Vec<_> =
        ["correlation"].into_iter().chain(known.iter().map(|it| it.name)).collect();
    let row = |(it, row): (&&FittedParameter, &Vec<f64>)| {
        let numbers = row.iter().map(|value| HtmlCell::Number(format!("{value:.2}")));
        [HtmlCell::words(it.name)].into_iter().chain(numbers).collect()
    };
    table(&header, &known.iter().zip(&outcome.correlations).map(row).collect::<Vec<_>>())
}

fn csv(outcome: &FitOutcome) -> String {
    let mut text = "name,title,unit,before,fitted,low,high,derivative_error\n".to_owned();
    for it in &outcome.parameters {
        let number = |it: Option<f64>| it.map_or_else(String::new, |it| it.to_string());
        let [low, high] = [it.interval.map(|it| it.0), it.interval.map(|it| it.1)].map(number);
        let title = format!("\"{}\"", it.title.replace('"', "\"\""));
        let numbers = [it.before.to_string(), it.value.to_string(), low, high];
        let words = [it.name.to_owned(), title, it.unit.to_owned()];
        let all = words.into_iter().chain(numbers).chain([number(it.derivative_error)]);
        text += &all.collect::<Vec<_>>().join(",");
        text += "\n";
    }
    text
}

/// Force against travel with the fit over the data, and what is between them.
fn charts(stroke: &FittedStroke) -> [Chart; 2] {
    let FittedStroke { measured, forces, .. } = stroke;
    let place = |travel: f64| 1e3 * travel;
    let data = measured.iter().map(|row| (place(row.travel), row.force)).collect();
    let model = measured.iter().zip(forces).map(|(row, force)| (place(row.travel), *force));
    let curve = |name: &str, stroke, look, points| ChartCurve {
        name: name.to_owned(),
        stroke,
        look,
        points,
    };
    let chart = |title, y_title, curves| Chart {
        title,
        x_title: "travel of the key's front [mm]",
        y_title,
        scales: Scales::Linear,
        curves,
    };
    let faint = Stroke::new(DATA, 0.8);
    let difference =
        measured.iter().zip(forces).map(|(row, force)| (place(row.travel), row.force - force));
    let fitted = Stroke::new(CURVES[1], 1.6);
    [
        chart(
            "Force against travel",
            "force at the front [N]",
            vec![
                curve("measured", faint, CurveLook::Marks, data),
                curve("fitted", fitted, CurveLook::Line, model.collect()),
            ],
        ),
        chart(
            "Measured less fitted",
            "difference [N]",
            vec![curve("difference", faint, CurveLook::Marked, difference.collect())],
        ),
    ]
}
