//! The report: a table of all cells, one of the boundary, a picture for each map, and one page.

use std::collections::BTreeMap;
use std::path::Path;

use haptics::EstimatorName;
use serde::Serialize;

use super::axis::{AxisTarget, MapAxis};
use super::judge::LoopVerdict;
use super::map::{StabilityMap, StabilityStudy, VerdictCounts};
use super::picture::{axis_title, svg};
use super::quantity::{FINGERS, LoopQuantity, QUANTITIES};
use crate::digits::rounded;
use crate::report::page::{HtmlCell, STYLE, escape, table};
use crate::report::{DiskError, PAGE, write_file};

/// Most rows of a table of the boundary on the page.
const ROWS: usize = 16;

/// The figures of a study, for programs.
#[derive(Clone, Debug, Serialize)]
pub struct StabilitySummary {
    pub name: String,
    /// The values of all that is no axis, by name (SI).
    pub settings: BTreeMap<String, f64>,
    pub x: AxisSummary,
    pub y: AxisSummary,
    pub maps: Vec<MapSummary>,
}

/// An axis of a study, for programs.
#[derive(Clone, Debug, Serialize)]
pub struct AxisSummary {
    pub name: String,
    pub unit: String,
    pub low: f64,
    pub high: f64,
    pub cells: usize,
    pub logarithmic: bool,
}

/// The figures of one map, for programs.
#[derive(Clone, Debug, Serialize)]
pub struct MapSummary {
    pub estimator: &'static str,
    pub cells: VerdictCounts,
    pub boundary: Vec<BoundaryRow>,
    /// How far the measured boundary is from each theory's.
    pub ratios: BTreeMap<&'static str, BoundaryRatio>,
}

/// Where a column goes from stable to unstable or back, along the second axis.
#[derive(Clone, Debug, Serialize)]
pub struct BoundaryRow {
    pub x: f64,
    pub measured: Vec<f64>,
    /// The same by each theory.
    pub theory: BTreeMap<&'static str, Vec<f64>>,
}

/// Measured boundary over that of a theory, of the columns in which both have one.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct BoundaryRatio {
    pub columns: usize,
    pub least: f64,
    pub median: f64,
    pub most: f64,
}

impl StabilitySummary {
    /// Returns the figures of a study's maps.
    pub fn new(study: &StabilityStudy<'_>, maps: &[StabilityMap]) -> Self {
        let axis = |axis: &MapAxis| AxisSummary {
            name: axis.name.clone(),
            unit: axis.unit.clone(),
            low: axis.ends.0,
            high: axis.ends.1,
            cells: axis.cells(study.cells),
            logarithmic: axis.is_logarithmic(),
        };
        Self {
            name: study.name.clone(),
            settings: settings(study).map(|(name, value, _)| (name.to_owned(), value)).collect(),
            x: axis(&study.axes[0]),
            y: axis(&study.axes[1]),
            maps: maps.iter().map(|map| map_summary(study, map)).collect(),
        }
    }
}

fn map_summary(study: &StabilityStudy<'_>, map: &StabilityMap) -> MapSummary {
    let row = |x: usize| {
        let theory = map.theories.iter().map(|it| (it.theory.name, it.crossings[x].clone()));
        BoundaryRow {
            x: study.axes[0].value(study.middle(0, x)),
            measured: map.crossings[x].clone(),
            theory: theory.collect(),
        }
    };
    let ratios = map.theories.iter().filter_map(|line| {
        let pairs = map.crossings.iter().zip(&line.crossings);
        let both = pairs.filter_map(|pair| match (pair.0.as_slice(), pair.1.as_slice()) {
            ([measured], [theory]) if *theory != 0.0 => Some(measured / theory),
            _ => None,
        });
        Some((line.theory.name, ratio(both.collect())?))
    });
    MapSummary {
        estimator: map.estimator.name(),
        cells: map.counts(),
        boundary: (0..map.columns.len()).map(row).collect(),
        ratios: ratios.collect(),
    }
}

fn ratio(mut all: Vec<f64>) -> Option<BoundaryRatio> {
    all.sort_by(f64::total_cmp);
    let (least, most) = (*all.first()?, *all.last()?);
    Some(BoundaryRatio { columns: all.len(), least, median: all[all.len() / 2], most })
}

/// Name, value (SI) and unit of each quantity that counts and is no axis.
fn settings(study: &StabilityStudy<'_>) -> impl Iterator<Item = (&'static str, f64, &'static str)> {
    let is_axis =
        |quantity| study.axes.iter().any(|it| it.target == AxisTarget::Quantity(quantity));
    let counted = QUANTITIES.iter().filter(move |it| !is_axis(it.quantity));
    counted.map(|it| (it.name, study.base.values.get(it.quantity), it.unit))
}

/// The same in lines for people, of what counts for an estimator.
fn settings_lines(study: &StabilityStudy<'_>, estimator: EstimatorName) -> Vec<String> {
    /// Most characters of a line.
    const LONGEST: usize = 130;
    let told = settings(study)
        .filter(|it| it.0 != "jerk-density" || estimator == EstimatorName::Kalman)
        .map(|(name, value, _)| setting(name, value));
    let mut lines: Vec<Vec<String>> = vec![Vec::new()];
    let mut length = 0;
    for part in study.chosen.iter().cloned().chain(told) {
        length += part.len() + 2;
        match lines.last_mut() {
            Some(line) if length <= LONGEST => line.push(part),
            _ => {
                length = part.len();
                lines.push(vec![part]);
            }
        }
    }
    lines.iter().map(|line| line.join(", ")).collect()
}

/// A quantity of a loop in words.
fn setting(name: &str, value: f64) -> String {
    let shown = LoopQuantity::named(name).map(|it| it.entry().shown);
    let (unit, per) = shown.unwrap_or(("", 1.0));
    match name {
        "finger" => {
            let near = |it: &(&&str, u8)| (f64::from(it.1) - value).abs() < 0.5;
            let found = FINGERS.iter().zip(0_u8..).find(near);
            format!("finger {}", found.map_or("none", |it| it.0))
        }
        "bandwidth" if value == 0.0 => "no lag of the motor".to_owned(),
        "encoder-step" if value == 0.0 => "no steps of the encoder".to_owned(),
        "delay" | "friction" if value == 0.0 => format!("no {name}"),
        _ => format!("{name} {} {unit}", rounded(value * per)),
    }
}

/// Writes the maps of a study into `folder`: map.csv, boundary.csv, a picture for each, and a page.
///
/// # Errors
/// When a file cannot be written; those that could are complete.
pub fn write_maps(
    folder: &Path,
    study: &StabilityStudy<'_>,
    maps: &[StabilityMap],
) -> Result<(), DiskError> {
    let summary = StabilitySummary::new(study, maps);
    let picture = |map: &StabilityMap| svg(study, map, &settings_lines(study, map.estimator));
    let pictures: Vec<_> = maps.iter().map(picture).collect();
    for (map, picture) in maps.iter().zip(&pictures) {
        write_file(&folder.join(format!("{}.svg", map.estimator.name())), picture)?;
    }
    write_file(&folder.join("map.csv"), &cells_csv(study, maps))?;
    write_file(&folder.join("boundary.csv"), &boundary_csv(study, &summary))?;
    write_file(&folder.join(PAGE), &page(study, &summary, &pictures))
}

/// The header of an axis's column.
fn column(axis: &MapAxis) -> String {
    let unit = axis.unit.replace(['*', '^'], "");
    if unit.is_empty() || unit == "1" {
        axis.name.clone()
    } else {
        format!("{} [{unit}]", axis.name)
    }
}

fn cells_csv(study: &StabilityStudy<'_>, maps: &[StabilityMap]) -> String {
    let [across, up] = [0, 1].map(|axis| column(&study.axes[axis]));
    let header = format!("estimator,{across},{up},verdict\n");
    let value = |axis: usize, cell| study.axes[axis].value(study.middle(axis, cell));
    let line = |estimator: EstimatorName, x, (y, verdict): (usize, &LoopVerdict)| {
        let name = estimator.name();
        format!("{name},{},{},{}\n", value(0, x), value(1, y), verdict.title())
    };
    let columns = maps
        .iter()
        .flat_map(|map| map.columns.iter().enumerate().map(|(x, cells)| (map.estimator, x, cells)));
    let lines = columns.flat_map(|(estimator, x, cells)| {
        cells.iter().enumerate().map(move |cell| line(estimator, x, cell))
    });
    std::iter::once(header).chain(lines).collect()
}

fn boundary_csv(study: &StabilityStudy<'_>, summary: &StabilitySummary) -> String {
    let [across, up] = [0, 1].map(|axis| column(&study.axes[axis]));
    let header = format!("estimator,{across},boundary,{up}\n");
    let rows = summary
        .maps
        .iter()
        .flat_map(|map| map.boundary.iter().flat_map(|row| row.lines(map.estimator)));
    std::iter::once(header).chain(rows).collect()
}

impl BoundaryRow {
    /// A line of the table for each place of the boundary, measured and by theory.
    fn lines(&self, estimator: &str) -> Vec<String> {
        let measured = [("measured", &self.measured)];
        let theory = self.theory.iter().map(|(name, all)| (*name, all));
        let named = measured.into_iter().chain(theory);
        let places = named.flat_map(|(name, all)| all.iter().map(move |it| (name, it)));
        places.map(|(name, value)| format!("{estimator},{},{name},{value}\n", self.x)).collect()
    }
}

/// What a reader must know before looking at a map.
const HOW: &str = "Each cell is one closed loop in simulation: the key rests, is knocked once by a \
    weight that is laid on it and taken away, and is left alone. In four windows after that the \
    mean square of its velocity and the range of the force must fall, else it rings for ever or \
    makes energy. The boundary is found between two cells by bisection. A theory of passivity \
    says where every passive load at the key is stable; a key of a given mass alone allows more.";

fn page(study: &StabilityStudy<'_>, summary: &StabilitySummary, pictures: &[String]) -> String {
    let title = format!("Where {} is stable", study.name);
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>Letoff: {0}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>{0}</h1>\n<p class=\"read\">{HOW}</p>\n",
        escape(&title),
    );
    for (map, picture) in summary.maps.iter().zip(pictures) {
        page += &["<h2>Velocity by ", map.estimator, "</h2>\n<figure>\n", picture].concat();
        page += "</figure>\n";
        page += &boundary_table(study, map);
    }
    page + "</body>\n</html>\n"
}

/// Some rows of the boundary; nothing where there is none.
fn boundary_table(study: &StabilityStudy<'_>, map: &MapSummary) -> String {
    let theories = map.boundary.first().into_iter().flat_map(|it| it.theory.keys());
    let up = axis_title(&study.axes[1]);
    let mut header = vec![axis_title(&study.axes[0]), format!("{up}: measured")];
    header.extend(theories.map(|name| format!("by {name}")));
    let header: Vec<_> = header.iter().map(String::as_str).collect();
    let step = map.boundary.len().div_ceil(ROWS).max(1);
    let number = |axis: usize, value: f64| rounded(value * study.axes[axis].shown.1);
    let list = |all: &Vec<f64>| {
        let all: Vec<_> = all.iter().map(|it| number(1, *it)).collect();
        HtmlCell::Number(all.join("; "))
    };
    let row = |row: &BoundaryRow| {
        let first = [HtmlCell::Number(number(0, row.x)), list(&row.measured)];
        first.into_iter().chain(row.theory.values().map(list)).collect()
    };
    let rows = map.boundary.iter().step_by(step).filter(|it| !it.measured.is_empty());
    let rows: Vec<Vec<HtmlCell>> = rows.map(row).collect();
    if rows.is_empty() { String::new() } else { table(&header, &rows) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_is_of_the_columns_that_have_both() {
        let all = ratio(vec![1.2, 0.9, 1.0]).unwrap();
        assert_eq!(all.columns, 3);
        assert!((all.least - 0.9).abs() < 1e-12 && (all.median - 1.0).abs() < 1e-12);
        assert!(ratio(Vec::new()).is_none());
    }
}
