//! What was measured, as CSV, SVG and one HTML page.
//!
//! [`Report`] is the page of every study, with its tables and pictures and the files beside it;
//! [`StudyReport`] that of the accuracy of all methods. Each file is written beside its place and
//! then moved there, so that none is ever half of one.

mod date;
mod disk;
mod glance;
mod machine;
mod page;
mod peers;
mod picture;
mod runs;
mod summary;
pub(crate) mod text;

use std::path::Path;
use std::time::SystemTime;

pub use disk::DiskError;
pub use machine::Machine;
pub use page::{Report, Table, TableCell};
pub use peers::{BadPeers, Peer, read as read_peers};
pub use summary::Summary;

use crate::accuracy::MeasuredScenario;

/// Name of the page's file.
pub const PAGE: &str = "index.html";

/// What a reader must know before looking at a plot.
const HOW_TO_READ: &str = include_str!("how_to_read.html");

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
    /// Writes the table, a picture for each scenario, and the page into `folder`.
    ///
    /// It is written anew after each scenario, so that a study that is stopped halfway keeps what
    /// it has measured.
    ///
    /// # Errors
    /// When a file cannot be written; those that could are complete.
    pub fn write(&self, folder: &Path) -> Result<(), DiskError> {
        let Machine { processor, processors, system, program } = &self.machine;
        let date = date::utc(self.date);
        let mut report = Report::new("Speed against error");
        report.text(&format!("{date} · {processor}, {processors} of them, {system} · {program}."));
        report.marked_up(HOW_TO_READ);
        report.heading("Cheapest at equal error");
        report.text(glance::TEXT);
        report.table(&glance::table(self));
        let mut tables = Vec::new();
        for measured in &self.measured {
            let ours = runs::ours(measured);
            self.add(measured, &ours, &mut report);
            tables.push(ours);
        }
        report.csv("accuracy", &runs::all(tables));
        report.write(folder)
    }

    /// Adds a scenario: its title, what its reference is, its pictures and its runs.
    fn add(&self, measured: &MeasuredScenario, ours: &Table, report: &mut Report) {
        let entry = measured.entry;
        report.heading(&format!("{}: {}", entry.name, entry.title));
        report.text(entry.source);
        report.picture(entry.name, &picture::methods(measured));
        let peers = self.peers_on(entry.name);
        if !peers.is_empty() {
            report.picture(&format!("{}-peers", entry.name), &picture::peers(measured, &peers));
        }
        report.folded(&format!("All {} runs", ours.rows.len()), ours);
        if !peers.is_empty() {
            let title = format!("All {} runs of other codes", peers.len());
            report.folded(&title, &runs::theirs(&peers));
        }
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
