//! Writes measurements as CSV, SVG and one HTML page.
//!
//! [`Report`] is the page of every study; [`StudyReport`] that of the accuracy of all methods.
//! Each file is written under another name and then renamed, so that no file is incomplete.

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

use std::{path::Path, time::SystemTime};

pub use disk::DiskError;
pub use machine::Machine;
pub use page::{Report, Table, TableCell};
pub use peers::{BadPeers, Peer, read as read_peers};
pub use summary::Summary;

use crate::accuracy::MeasuredScenario;

pub const PAGE: &str = "index.html";

const HOW_TO_READ: &str = include_str!("how_to_read.html");

/// Results of a study so far, with its machine.
#[derive(Clone, Debug)]
pub struct StudyReport {
    pub machine: Machine,
    pub date: SystemTime,
    pub measured: Vec<MeasuredScenario>,
    pub peers: Vec<Peer>,
}

/// Creates `folder`, and tries to create a file in it.
pub fn prepare(folder: &Path) -> Result<(), DiskError> {
    disk::prepare(folder)
}

/// Writes `text` to the file at `path`, which is complete or unchanged.
pub fn write_file(path: &Path, text: &str) -> Result<(), DiskError> {
    disk::write(path, text)
}

impl StudyReport {
    /// Writes the table, a picture for each scenario, and the page into `folder`. Called after each
    /// scenario, so that an interrupted study keeps its results.
    ///
    /// # Errors
    /// If a file cannot be written; files written before are complete.
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

    pub fn summary(&self) -> Summary<'_> {
        Summary::new(self)
    }

    fn peers_on(&self, problem: &str) -> Vec<&Peer> {
        self.peers.iter().filter(|peer| peer.problem == problem).collect()
    }
}
