//! Writes measurements as CSV, SVG and one HTML page.
//!
//! [`Report`] is the page of every study; [`StudyReport`] that of the accuracy of all methods.
//! Each file is written under another name and then renamed, so that no file is incomplete.

mod date;
mod disk;
mod glance;
mod machine;
mod orders;
mod page;
mod peers;
mod picture;
mod runs;
mod stored;
mod summary;
pub(crate) mod text;

use std::{path::Path, time::SystemTime};

pub use disk::DiskError;
pub use machine::Machine;
pub use page::{Report, Table, TableCell};
pub use peers::{BadPeers, Peer, read as read_peers};
pub use stored::StoredRuns;
pub use summary::Summary;

use crate::accuracy::{EnergyDrift, MeasuredScenario, StudyChoice};

pub const PAGE: &str = "index.html";

/// CSV columns that say which run it is.
const RUN_KEYS: [&str; 4] = ["scenario", "method", "tick_s", "tolerance_or_budget"];

const HOW_TO_READ: &str = include_str!("how_to_read.html");

/// Results of a study so far, with its machine.
#[derive(Clone, Debug)]
pub struct StudyReport {
    pub machine: Machine,
    pub date: SystemTime,
    pub measured: Vec<MeasuredScenario>,
    pub drifts: Vec<EnergyDrift>,
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
    /// Returns the report, of now, of a study without results.
    pub fn new(machine: Machine) -> Self {
        let (measured, drifts) = (Vec::new(), Vec::new());
        Self { machine, date: SystemTime::now(), measured, drifts, peers: Vec::new() }
    }

    /// Writes the tables, pictures of each scenario, and the page into `folder`. Called after each
    /// scenario, so that an interrupted study keeps its results.
    ///
    /// # Errors
    /// If a file cannot be written; files written before are complete.
    pub fn write(&self, choice: &StudyChoice, folder: &Path) -> Result<(), DiskError> {
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
        self.add_drifts(&mut report);
        let (all, is_time) = (runs::all(tables), |name: &str| name.starts_with("ns_"));
        report.csv("accuracy", &all.columns(|name| !is_time(name)));
        report.csv("times", &all.columns(|name| is_time(name) || RUN_KEYS.contains(&name)));
        report.csv("orders", &orders::table(&self.measured));
        report.file(stored::RUNS, StoredRuns::text(self, choice));
        report.write(folder)
    }

    fn add_drifts(&self, report: &mut Report) {
        if self.drifts.is_empty() {
            return;
        }
        report.heading("Energy over long runs");
        report.text(picture::LONG_RUN_TEXT);
        report.picture("long-run", &picture::drifts(&self.drifts));
    }

    fn add(&self, measured: &MeasuredScenario, ours: &Table, report: &mut Report) {
        let entry = measured.entry;
        report.heading(&format!("{}: {}", entry.name, entry.title));
        report.text(entry.source);
        if let Some(error) = summary::error_where_exact(measured) {
            report.text(&format!(
                "Every method of order 2 or higher is exact here but for rounding, {} s at most; \
                 there is no picture.",
                text::exponent(error)
            ));
        } else {
            report.picture(entry.name, &picture::methods(measured));
            report.picture(&format!("{}-counts", entry.name), &picture::counts(measured));
            report.text(orders::TEXT);
            report.table(&orders::table(std::slice::from_ref(measured)));
        }
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
