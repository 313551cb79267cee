//! The report: a table of all points, a picture, one page, and the figures for programs.

use std::path::Path;

use crate::report::{DiskError, Report, Table, TableCell};
use serde::Serialize;

use crate::impedance::curve::{ActiveBand, ImpedanceCurve, ImpedancePoint};
use crate::impedance::picture::picture;

const ROWS: usize = 16;

const HOW: &str = "Z = F/v at the key's front: the force on the finger over the finger's velocity. \
    A damper is level at 0°, a spring falls at −90°, a mass rises at +90°. Where Re Z is below zero, \
    shaded, the key is not passive: a finger that shakes it there gets work out of it. \
    Peaks of Re Z are cut at the edge of their panel. A mode is linearised, with exact input. A voice \
    is shaken by a small sinusoid tick by tick, and its force is held and delayed. A recorded stroke \
    is a cross-spectrum. Below a coherence of 0.5, and within three standard errors of zero, Re Z is \
    not judged.";

/// Figures of a study, for programs.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ImpedanceSummary<'a> {
    pub name: &'a str,
    pub curves: Vec<CurveSummary<'a>>,
}

/// A curve with its bands that are not passive.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct CurveSummary<'a> {
    #[serde(flatten)]
    pub curve: &'a ImpedanceCurve,
    pub not_passive: Vec<ActiveBand>,
}

impl<'a> ImpedanceSummary<'a> {
    pub fn new(name: &'a str, curves: &'a [ImpedanceCurve]) -> Self {
        let summary =
            |curve| CurveSummary { curve, not_passive: ImpedanceCurve::active_bands(curve) };
        Self { name, curves: curves.iter().map(summary).collect() }
    }
}

/// Writes impedance.csv, impedance.svg and a page into `folder`.
///
/// # Errors
/// If a file cannot be written; files written before are complete.
pub fn write_impedance(
    folder: &Path,
    name: &str,
    curves: &[ImpedanceCurve],
) -> Result<(), DiskError> {
    let title = format!("Impedance of {name}");
    let mut report = Report::new(title.clone());
    report.introduce(HOW);
    report.picture("impedance", &picture(title, curves));
    for curve in curves {
        report.heading(&curve.name);
        report.text(&format!("{}. {}.", curve.remark, curve.verdict()));
        let step = curve.points.len().div_ceil(ROWS).max(1);
        report.table(&points().with(curve.points.iter().step_by(step).map(|it| row(curve, it))));
    }
    let rows = curves.iter().flat_map(|curve| curve.points.iter().map(|it| row(curve, it)));
    report.csv("impedance", &points().with(rows));
    report.write(folder)
}

fn points() -> Table {
    Table::new([
        ("curve", ""),
        ("frequency [Hz]", "f [Hz]"),
        ("magnitude [N s/m]", "|Z| [N·s/m]"),
        ("phase [deg]", "phase [°]"),
        ("real [N s/m]", "Re Z [N·s/m]"),
        ("imaginary [N s/m]", "Im Z [N·s/m]"),
        ("coherence", "coherence"),
        ("error [N s/m]", "standard error [N·s/m]"),
    ])
}

fn row(curve: &ImpedanceCurve, point: &ImpedancePoint) -> Vec<TableCell> {
    let ImpedancePoint { frequency, real, imaginary, coherence, error } = *point;
    let polar = [frequency, point.magnitude(), point.phase()];
    let numbers = polar.into_iter().chain([real, imaginary, coherence, error]);
    let name = TableCell::words(curve.name.as_str());
    std::iter::once(name).chain(numbers.map(TableCell::Number)).collect()
}
