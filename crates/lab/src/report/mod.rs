//! What was measured, as CSV, SVG and one HTML page.
//!
//! A report is written anew after each scenario, so that a study that is stopped halfway keeps
//! what it has measured. Each file is written beside its place and then moved there, so that none
//! is ever half of one.

mod date;
mod disk;
mod machine;
pub mod page;
mod peers;
mod plot;
mod summary;
mod table;
pub(crate) mod text;

use std::path::Path;
use std::time::SystemTime;

pub use disk::DiskError;
pub use machine::Machine;
pub use peers::{BadPeers, Peer, read as read_peers};
pub use summary::Summary;

use crate::accuracy::MeasuredScenario;

/// Name of the page's file.
pub const PAGE: &str = "index.html";
/// Name of the table's file.
pub const TABLE: &str = "accuracy.csv";

/// What a study has measured so far, and where.
#[derive(Clone, Debug)]
pub struct StudyReport {
    pub machine: Machine,
    /// When the study was begun.
    pub date: SystemTime,
    pub measured: Vec<MeasuredScenario>,
    /// Runs of other codes on some of the same problems.
    pub peers: Vec<Peer>,
}

/// Why a report could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    #[error(transparent)]
    Disk(#[from] DiskError),
    #[error("the table cannot be put together: {0}")]
    Table(#[from] csv::Error),
}

/// Creates `folder` and looks whether files can be created there.
///
/// # Errors
/// When they cannot.
pub fn prepare(folder: &Path) -> Result<(), DiskError> {
    disk::prepare(folder)
}

/// Writes `text` to the file at `path`, which is complete or as it was before.
///
/// # Errors
/// When it cannot be written.
pub fn write_file(path: &Path, text: &str) -> Result<(), DiskError> {
    disk::write(path, text)
}

impl StudyReport {
    /// Writes the table, a plot for each scenario, and the page into `folder`.
    ///
    /// # Errors
    /// When a file cannot be written; those that could are complete.
    pub fn write(&self, folder: &Path) -> Result<(), ReportError> {
        disk::write(&folder.join(TABLE), &table::csv(&self.measured)?)?;
        let mut pages = Vec::new();
        for measured in &self.measured {
            let plots = self.plots(measured);
            for (name, svg) in &plots {
                disk::write(&folder.join(name), svg)?;
            }
            pages.push(plots.into_iter().map(|(_, svg)| svg).collect());
        }
        Ok(disk::write(&folder.join(PAGE), &page::html(self, &pages))?)
    }

    /// The plots of a scenario with their files' names: ours, and other codes' if there are any.
    fn plots(&self, measured: &MeasuredScenario) -> Vec<(String, String)> {
        let name = measured.entry.name;
        let mut plots = vec![(format!("{name}.svg"), plot::methods(measured))];
        let peers = self.peers_on(name);
        if !peers.is_empty() {
            plots.push((format!("{name}-peers.svg"), plot::peers(measured, &peers)));
        }
        plots
    }

    /// Returns the main figures, for a program to read.
    pub fn summary(&self) -> Summary<'_> {
        Summary::new(self)
    }

    /// The other codes' rows on `problem`.
    fn peers_on(&self, problem: &str) -> Vec<&Peer> {
        self.peers.iter().filter(|peer| peer.problem == problem).collect()
    }
}
