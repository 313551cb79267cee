//! The report: a table of all points, a picture, and one page; and the figures for programs.

use std::path::Path;

use lab::digits::rounded;
use lab::report::page::{HtmlCell, STYLE, escape, table};
use lab::report::{DiskError, PAGE, write_file};
use serde::Serialize;

use crate::curve::{ActiveBand, ImpedanceCurve, ImpedancePoint};
use crate::picture::svg;

/// Most rows of a table on the page.
const ROWS: usize = 16;

/// What a reader must know before looking at a curve.
const HOW: &str = "Z = F/v at the key's front: the force on the finger over the finger's velocity. \
    A damper is level at 0°, a spring falls at −90°, a mass rises at +90°. Where Re Z is below zero, \
    shaded, the key is not passive: a finger that shakes it there gets work out of it. \
    Peaks of Re Z are cut at the edge of their panel. A mode is linearised, with exact input. A voice \
    is shaken by a small sinusoid tick by tick, and its force is held and delayed. A recorded stroke \
    is a cross-spectrum. Below a coherence of 0.5, and within three standard errors of zero, Re Z is \
    not judged.";

/// The figures of a study, for programs.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ImpedanceSummary<'a> {
    pub name: &'a str,
    pub curves: Vec<CurveSummary<'a>>,
}

/// A curve with where it is not passive.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct CurveSummary<'a> {
    #[serde(flatten)]
    pub curve: &'a ImpedanceCurve,
    pub not_passive: Vec<ActiveBand>,
}

impl<'a> ImpedanceSummary<'a> {
    /// Returns the figures of `curves` under a name.
    pub fn new(name: &'a str, curves: &'a [ImpedanceCurve]) -> Self {
        let summary =
            |curve| CurveSummary { curve, not_passive: ImpedanceCurve::active_bands(curve) };
        Self { name, curves: curves.iter().map(summary).collect() }
    }
}

/// Writes `curves` into `folder`: impedance.csv, impedance.svg, and a page.
///
/// # Errors
/// When a file cannot be written; those that could are complete.
pub fn write_impedance(
    folder: &Path,
    name: &str,
    curves: &[ImpedanceCurve],
) -> Result<(), DiskError> {
    let title = format!("Impedance of {name}");
    let picture = svg(&title, curves);
    write_file(&folder.join("impedance.csv"), &csv(curves))?;
    write_file(&folder.join("impedance.svg"), &picture)?;
    write_file(&folder.join(PAGE), &page(&title, curves, &picture))
}

fn csv(curves: &[ImpedanceCurve]) -> String {
    let header = "curve,frequency [Hz],magnitude [N s/m],phase [deg],real [N s/m],\
                  imaginary [N s/m],coherence,error [N s/m]\n";
    let line = |name: &str, it: &ImpedancePoint| {
        let (magnitude, phase) = (it.magnitude(), it.phase());
        let ImpedancePoint { frequency, real, imaginary, coherence, error } = it;
        format!(
            "\"{name}\",{frequency},{magnitude},{phase},{real},{imaginary},{coherence},{error}\n"
        )
    };
    let lines = curves.iter().flat_map(|curve| {
        let name = curve.name.replace('"', "\"\"");
        curve.points.iter().map(move |it| line(&name, it))
    });
    std::iter::once(header.to_owned()).chain(lines).collect()
}

fn page(title: &str, curves: &[ImpedanceCurve], picture: &str) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>Letoff: {0}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>{0}</h1>\n<p class=\"read\">{HOW}</p>\n<figure>\n{picture}</figure>\n",
        escape(title),
    );
    for curve in curves {
        let [name, remark, verdict] =
            [&curve.name, &curve.remark, &curve.verdict()].map(|it| escape(it));
        page += &["<h2>", &name, "</h2>\n<p>", &remark, ". ", &verdict, ".</p>\n"].concat();
        page += &points_table(curve);
    }
    page + "</body>\n</html>\n"
}

fn points_table(curve: &ImpedanceCurve) -> String {
    let header = ["f [Hz]", "|Z| [N·s/m]", "phase [°]", "Re Z [N·s/m]", "coherence"];
    let row = |it: &ImpedancePoint| {
        let values = [it.frequency, it.magnitude(), it.phase(), it.real, it.coherence];
        values.map(|it| HtmlCell::Number(rounded(it))).to_vec()
    };
    let step = curve.points.len().div_ceil(ROWS).max(1);
    table(&header, &curve.points.iter().step_by(step).map(row).collect::<Vec<_>>())
}
