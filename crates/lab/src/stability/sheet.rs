//! The report: tables of all cells and of the boundary, a picture for each map, and one page.

use std::{collections::BTreeMap, path::Path};

use haptics::EstimatorName;
use serde::Serialize;

use super::axis::{AxisTarget, MapAxis};
use super::map::{StabilityMap, StabilityStudy, VerdictCounts};
use super::picture::picture;
use super::quantity::{FINGERS, LoopQuantity, QUANTITIES};
use crate::report::{DiskError, Report, Table, TableCell};
use figures::digits::rounded;

/// Maximum columns with their boundary on the page.
const ROWS: usize = 16;

/// Figures of a study, for programs.
#[derive(Clone, Debug, Serialize)]
pub struct StabilitySummary {
    pub name: String,
    /// Values of all that is no axis, by name (SI).
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

/// Figures of one map, for programs.
#[derive(Clone, Debug, Serialize)]
pub struct MapSummary {
    pub estimator: &'static str,
    pub cells: VerdictCounts,
    pub boundary: Vec<BoundaryRow>,
    /// Ratio of the measured boundary to each theory's.
    pub ratios: BTreeMap<&'static str, BoundaryRatio>,
}

/// Change of stability of a column, along the second axis.
#[derive(Clone, Debug, Serialize)]
pub struct BoundaryRow {
    pub x: f64,
    pub measured: Vec<f64>,
    pub theory: BTreeMap<&'static str, Vec<f64>>,
}

/// Ratio of the measured boundary to a theory's, over the columns that have both.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct BoundaryRatio {
    pub columns: usize,
    pub least: f64,
    pub median: f64,
    pub most: f64,
}

impl StabilitySummary {
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

fn settings(study: &StabilityStudy<'_>) -> impl Iterator<Item = (&'static str, f64, &'static str)> {
    let is_axis =
        |quantity| study.axes.iter().any(|it| it.target == AxisTarget::Quantity(quantity));
    let counted = QUANTITIES.iter().filter(move |it| !is_axis(it.quantity));
    counted.map(|it| (it.name, study.base.values.get(it.quantity), it.unit))
}

fn settings_lines(study: &StabilityStudy<'_>, estimator: EstimatorName) -> Vec<String> {
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

const HOW: &str = "Each cell is one closed loop in simulation: the key rests, is knocked once by a \
    weight that is laid on it and taken away, and is left alone. In four windows after that the \
    mean square of its velocity and the range of the force must fall, else it rings for ever or \
    makes energy. The boundary is found between two cells by bisection. A theory of passivity \
    says where every passive load at the key is stable; a key of a given mass alone allows more.";

/// Writes map.csv, boundary.csv, a picture for each map, and a page into `folder`.
///
/// # Errors
/// If a file cannot be written; files written before are complete.
pub fn write_maps(
    folder: &Path,
    study: &StabilityStudy<'_>,
    maps: &[StabilityMap],
) -> Result<(), DiskError> {
    let summary = StabilitySummary::new(study, maps);
    let mut report = Report::new(format!("Where {} is stable", study.name));
    report.introduce(HOW);
    report.csv("map", &cells(study, maps));
    let mut all = boundary_table(study);
    for (map, figures) in maps.iter().zip(&summary.maps) {
        let name = map.estimator.name();
        report.heading(&format!("Velocity by {name}"));
        let settings = settings_lines(study, map.estimator);
        report.picture(name, &picture(study, map, settings));
        let step = figures.boundary.len().div_ceil(ROWS).max(1);
        let shown = figures.boundary.iter().step_by(step);
        report.table(&boundary_table(study).with(shown.flat_map(|row| row.cells(name))));
        all.rows.extend(figures.boundary.iter().flat_map(|row| row.cells(name)));
    }
    report.csv("boundary", &all);
    report.write(folder)
}

fn column(axis: &MapAxis) -> (String, String) {
    let unit = axis.unit.replace(['*', '^'], "");
    let titled = |title: &str| match unit.as_str() {
        "" | "1" => title.to_owned(),
        unit => format!("{title} [{unit}]"),
    };
    (titled(&axis.name), titled(&axis.title))
}

fn own_column(name: &str) -> (String, String) {
    (name.to_owned(), name.to_owned())
}

fn cells(study: &StabilityStudy<'_>, maps: &[StabilityMap]) -> Table {
    let [across, up] = [0, 1].map(|axis| column(&study.axes[axis]));
    let table = Table::new([own_column("estimator"), across, up, own_column("verdict")]);
    let value =
        |axis: usize, cell| TableCell::Number(study.axes[axis].value(study.middle(axis, cell)));
    table.with(maps.iter().flat_map(|map| {
        let name = map.estimator.name();
        map.columns.iter().enumerate().flat_map(move |(x, cells)| {
            cells.iter().enumerate().map(move |(y, verdict)| {
                let [name, verdict] = [name, verdict.title()].map(TableCell::words);
                [name, value(0, x), value(1, y), verdict]
            })
        })
    }))
}

fn boundary_table(study: &StabilityStudy<'_>) -> Table {
    let [across, up] = [0, 1].map(|axis| column(&study.axes[axis]));
    // The page has the estimator in its heading.
    let estimator = ("estimator".to_owned(), String::new());
    Table::new([estimator, across, own_column("boundary"), up])
}

impl BoundaryRow {
    fn cells(&self, estimator: &str) -> Vec<Vec<TableCell>> {
        let theory = self.theory.iter().map(|(name, all)| (*name, all));
        let named = std::iter::once(("measured", &self.measured)).chain(theory);
        let places = named.flat_map(|(name, all)| all.iter().map(move |it| (name, *it)));
        let cells = places.map(|(name, value)| {
            let [estimator, name] = [estimator, name].map(TableCell::words);
            vec![estimator, TableCell::Number(self.x), name, TableCell::Number(value)]
        });
        cells.collect()
    }
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
