//! The most important comparison: cost at equal error of event times.

use super::page::{Table, TableCell};
use super::summary::{Cheapest, TARGETS, failures, in_ticks, offline, peer};
use super::{StudyReport, peers::Author, text};
use crate::accuracy::MeasuredScenario;

pub(super) const TEXT: &str = "ns per simulated ms of the cheapest run whose events are all right \
    and this near: in ticks of 5 ms or less, as at a deadline; below it with steps by a tolerance, \
    offline; and, measured in one run of their own, ours side by side with other people's codes and \
    with what was written by hand for the one problem.";

pub(super) fn table(report: &StudyReport) -> Table {
    let targets = TARGETS.map(|it| format!("all events within {}", text::duration(it)));
    let first = ["scenario", "runs that failed"].map(str::to_owned);
    let titles = first.into_iter().chain(targets).map(|it| (it.clone(), it));
    Table::new(titles).with(report.measured.iter().flat_map(|it| rows(report, it)))
}

fn rows(report: &StudyReport, measured: &MeasuredScenario) -> Vec<Vec<TableCell>> {
    let failed = format!("{} of {}", failures(measured), measured.rows.len());
    let mut rows = vec![row(measured.entry.name, &failed, |it| in_ticks(measured, it))];
    let mut more = |name: &str, cheapest: &dyn Fn(f64) -> Option<Cheapest>| {
        if TARGETS.iter().any(|target| cheapest(*target).is_some()) {
            rows.push(row(name, "", cheapest));
        }
    };
    more("— offline", &|it| offline(measured, it));
    more("— side by side: pode", &|it| peer(report, measured, Author::Ours, it));
    more("— side by side: others", &|it| peer(report, measured, Author::Others, it));
    more("— side by side: by hand", &|it| peer(report, measured, Author::ByHand, it));
    rows
}

fn row(name: &str, failed: &str, cheapest: impl Fn(f64) -> Option<Cheapest>) -> Vec<TableCell> {
    let cells = TARGETS.map(|target| TableCell::Words(words(cheapest(target))));
    [name, failed].map(TableCell::words).into_iter().chain(cells).collect()
}

fn words(cheapest: Option<Cheapest>) -> String {
    cheapest.map_or_else(
        || "—".to_owned(),
        |it| format!("{} ns: {}, {}", text::short(it.ns_per_ms), it.who, it.setting),
    )
}
