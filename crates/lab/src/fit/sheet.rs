//! The report of a fit: one page, its charts, and the results for programs.

use std::path::Path;

use super::outcome::{FitOutcome, FittedStroke};
use crate::report::{DiskError, Report, Table, TableCell};
use figures::plot::color::{CURVES, Color, Stroke};
use figures::plot::marker::MarkerShape::Circle;
use figures::plot::picture::{CurveLook, Picture, PictureAxis, PictureCurve, PicturePanel};

const DATA: Color = Color(150, 150, 150);
const HOW: &str = "The front of the key is driven as it was measured, and its force is compared. \
    Intervals are of 95 %: they take the differences that remain for noise, whose neighbours may be \
    alike, and the model for linear within them. A parameter without one is not determined.";

/// Writes the page, its charts, the parameters as CSV, and the instrument (file name and text).
///
/// # Errors
/// If a file cannot be written; files written before are complete.
pub fn write_fit(
    folder: &Path,
    outcome: &FitOutcome,
    instrument: Option<(&str, &str)>,
) -> Result<(), DiskError> {
    let mut report = Report::new(format!("{}, fitted", outcome.instrument));
    report.introduce(HOW);
    if let Some((file, text)) = instrument {
        report.text(&format!("The instrument is in {file}."));
        report.file(file, text.to_owned());
    } else {
        report.text("With these values it is no instrument on all keys, so none was written.");
    }
    let parameters = parameters(outcome);
    report.table(&parameters);
    report.csv("parameters", &parameters);
    outcome.remarks.iter().for_each(|remark| report.text(remark));
    report.table(&correlations(outcome));
    for (stroke, number) in outcome.strokes.iter().zip(1..) {
        let FittedStroke { name, rows, noise, before, after, .. } = stroke;
        report.heading(name);
        report.text(&format!(
            "{rows} rows. Root mean square of the difference: {before:.3} N before, \
             {after:.3} N after; noise {noise:.3} N."
        ));
        let [force, residual] = pictures(stroke);
        report.picture(&format!("force-{number}"), &force);
        report.picture(&format!("residual-{number}"), &residual);
    }
    report.write(folder)
}

fn parameters(outcome: &FitOutcome) -> Table {
    let columns = [
        ("name", "name"),
        ("title", "parameter"),
        ("unit", "unit"),
        ("before", "before"),
        ("fitted", "fitted"),
        ("low", "95 % from"),
        ("high", "95 % to"),
        ("derivative_error", "error of the derivative"),
    ];
    Table::new(columns).with(outcome.parameters.iter().map(|it| {
        let words = [it.name, &it.title, it.unit].map(TableCell::words);
        let ends = [it.interval.map(|it| it.0), it.interval.map(|it| it.1), it.derivative_error];
        let values = [it.before, it.value].map(TableCell::Number);
        let cells = words.into_iter().chain(values).chain(ends.map(TableCell::maybe));
        cells.collect::<Vec<_>>()
    }))
}

fn correlations(outcome: &FitOutcome) -> Table {
    let known: Vec<_> = outcome.parameters.iter().filter(|it| it.interval.is_some()).collect();
    let names = known.iter().map(|it| it.name);
    let table = Table::new(["correlation"].into_iter().chain(names).map(|it| (it, it)));
    if known.len() < 2 {
        return table;
    }
    table.with(known.iter().zip(&outcome.correlations).map(|(it, row)| {
        let numbers = row.iter().map(|value| TableCell::Number((100.0 * value).round() / 100.0));
        [TableCell::words(it.name)].into_iter().chain(numbers).collect::<Vec<_>>()
    }))
}

fn pictures(stroke: &FittedStroke) -> [Picture; 2] {
    let rows = || stroke.measured.iter().zip(&stroke.forces);
    let points = |value: fn(f64, f64) -> f64| {
        rows().map(|(row, force)| (1e3 * row.travel, value(row.force, *force))).collect()
    };
    let picture = |title: &str, y_title: &str, curves| {
        let x = PictureAxis::linear("travel of the key's front [mm]");
        let y = vec![PictureAxis::linear(y_title)];
        Picture::of_panel(title, PicturePanel { x, y, curves, ..Default::default() })
    };
    let (faint, fitted) = (Stroke::new(DATA, 0.8), Stroke::new(CURVES[1], 1.6));
    let (marks, marked) = (CurveLook::Marks(Circle), CurveLook::Marked(Circle));
    let force = vec![
        PictureCurve::new("measured", faint, marks, points(|measured, _| measured)),
        PictureCurve::new("fitted", fitted, CurveLook::Line, points(|_, force| force)),
    ];
    let less = points(|measured, force| measured - force);
    let difference = vec![PictureCurve::new("difference", faint, marked, less)];
    [
        picture("Force against travel", "force at the front [N]", force),
        picture("Measured less fitted", "difference [N]", difference),
    ]
}
