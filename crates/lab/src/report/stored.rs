//! Runs as a file, so that the shares of a study can be joined.

use std::fs;
use std::path::{Path, PathBuf};

use documents::shown;
use serde::{Deserialize, Serialize};

use super::{Machine, StudyReport};
use crate::accuracy::{EnergyDrift, LONG_RUN, StudyChoice, StudyNames, StudyRow, measure};
use crate::part::StudyPart;

/// Name of the file in the folder of a report.
pub(super) const RUNS: &str = "runs.json";

/// Runs of a study, or of shares of it.
#[derive(Debug, Serialize, Deserialize)]
pub struct StoredRuns {
    pub names: StudyNames,
    machine: Machine,
    rows: Vec<StudyRow>,
    drifts: Vec<EnergyDrift>,
}

impl StoredRuns {
    pub(super) fn text(report: &StudyReport, choice: &StudyChoice) -> String {
        let rows = report.measured.iter().flat_map(|it| it.rows.clone()).collect();
        let (machine, drifts) = (report.machine.clone(), report.drifts.clone());
        let stored = Self { names: choice.names.clone(), machine, rows, drifts };
        serde_json::to_string(&stored).unwrap_or_default()
    }

    /// Reads the runs in all `folders`.
    ///
    /// # Errors
    /// One sentence for each folder that cannot be read, or is of another study than the first.
    pub fn read(folders: &[PathBuf]) -> Result<Option<Self>, Vec<String>> {
        let mut mistakes = Vec::new();
        let mut all: Option<Self> = None;
        for folder in folders {
            match (read(&folder.join(RUNS)), &mut all) {
                (Err(mistake), _) => mistakes.push(mistake),
                (Ok(first), None) => all = Some(first),
                (Ok(other), Some(all)) if all.names == other.names => {
                    all.rows.extend(other.rows);
                    all.drifts.extend(other.drifts);
                }
                (Ok(_), Some(_)) => {
                    mistakes
                        .push(format!("{} is of another study; join its shares", shown(folder)));
                }
            }
        }
        if mistakes.is_empty() { Ok(all) } else { Err(mistakes) }
    }

    /// Returns the report of the whole study, with the machine of the first share.
    ///
    /// # Errors
    /// One sentence for each scenario without one of its runs, or with a run twice.
    pub fn into_report(mut self, choice: &StudyChoice) -> Result<StudyReport, Vec<String>> {
        let mut mistakes = Vec::new();
        let mut check = |name: &str, numbers: Vec<usize>, runs: usize| {
            if !numbers.iter().copied().eq(0..runs) {
                let found = numbers.len();
                mistakes.push(format!("{name} has {found} of {runs} runs; join each share once"));
            }
        };
        self.rows.sort_by_key(|row| row.number);
        self.drifts.sort_by_key(|drift| drift.number);
        let mut report = StudyReport::new(self.machine);
        let nothing = StudyChoice { part: StudyPart::NONE, ..choice.clone() };
        for entry in &choice.scenarios {
            let measured = measure(entry, &nothing, &|_run| ());
            let mut measured = measured.map_err(|error| vec![error.to_string()])?;
            measured.rows = self.rows.extract_if(.., |row| row.scenario == entry.name).collect();
            check(entry.name, measured.rows.iter().map(|it| it.number).collect(), measured.runs);
            report.measured.push(measured);
        }
        check(LONG_RUN, self.drifts.iter().map(|it| it.number).collect(), choice.long_runs());
        report.drifts = self.drifts;
        if mistakes.is_empty() { Ok(report) } else { Err(mistakes) }
    }
}

fn read(path: &Path) -> Result<StoredRuns, String> {
    let text = fs::read_to_string(path).map_err(|cause| cause.to_string());
    let stored = text.and_then(|text| serde_json::from_str(&text).map_err(|it| it.to_string()));
    stored.map_err(|cause| format!("cannot read {}: {cause}; name folders of shares", shown(path)))
}
