//! The report: the picture, the public bug reports with their outcome here, and all runs.

use std::path::Path;

use super::picture::picture;
use super::rows::HardRow;
use super::run::HardRun;
use crate::report::{DiskError, Report, Table, TableCell};

const HOW: &str = "Every method runs each case at four steps. Right: the events in their order, and \
    times and values within the tolerance of the case. Reported: the run ends with a reason, or its \
    energy audit is off by more than 1 %. Inaccurate and wrong are errors without a report. A case \
    fails (✗) if rk4, dop853, tsitouras5, by-need or exact is so at the shortest step.";

/// Writes the page, hard.svg, hard.csv and reports.csv into `folder`.
///
/// # Errors
/// If a file cannot be written; files written before are complete.
pub fn write_hard(folder: &Path, rows: &[HardRow]) -> Result<(), DiskError> {
    let mut report = Report::new("Hard cases");
    report.introduce(HOW);
    report.drawing("hard", picture(rows));
    let failed: Vec<_> = rows.iter().filter(|it| !it.failures().is_empty()).collect();
    report.heading(&format!("{} of {} cases fail", failed.len(), rows.len()));
    report.table(&outcomes(&mut failed.into_iter()));
    report.heading("Public bug reports, and the same here");
    let reports = outcomes(&mut rows.iter().filter(|it| it.case.source.starts_with("http")));
    report.table(&reports);
    report.csv("reports", &reports);
    report.heading("All runs");
    let mut all = runs();
    for row in rows {
        let own = runs().with(row.runs.iter().map(|it| cells(row, it)));
        report.folded(&format!("{}: {}", row.case.name, row.outcome()), &own);
        all.rows.extend(own.rows);
    }
    report.csv("hard", &all);
    report.write(folder)
}

fn outcomes(rows: &mut dyn Iterator<Item = &HardRow>) -> Table {
    let columns = [
        ("case", "case"),
        ("source", "source"),
        ("symptom", "symptom elsewhere"),
        ("here", "here, by the five methods that must be right"),
    ];
    let row = |it: &HardRow| {
        let [case, source, symptom] =
            [&it.case.name, &it.case.source, &it.case.symptom].map(TableCell::words);
        let cell = if it.failures().is_empty() { TableCell::Words } else { TableCell::WrongWords };
        [case, source, symptom, cell(it.outcome())]
    };
    Table::new(columns).with(rows.map(row))
}

fn runs() -> Table {
    Table::new([
        ("case", ""),
        ("topic", ""),
        ("method", "method"),
        ("verdict", "verdict"),
        ("step", "step [s]"),
        ("event_error", "time of an event [s]"),
        ("value_error", "value at the end"),
        ("energy_error", "energy, of what moved"),
        ("derivatives", "derivatives"),
        ("remark", "remark"),
    ])
}

fn cells(row: &HardRow, it: &HardRun) -> Vec<TableCell> {
    let [case, topic, method] =
        [&*row.case.name, &*row.case.topic, it.method].map(TableCell::words);
    let cell = if it.verdict.is_silent() { TableCell::WrongWords } else { TableCell::Words };
    let verdict = cell(it.verdict.title().to_owned());
    let derivatives = it.derivatives.map(|it| it as f64);
    let numbers = [Some(it.step), it.event_error, it.value_error, it.energy_error, derivatives];
    let first = [case, topic, method, verdict].into_iter();
    let all = first.chain(numbers.map(TableCell::maybe));
    all.chain([TableCell::words(it.remark.clone())]).collect()
}
