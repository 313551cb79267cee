//! The comparison that counts: cost at equal error of event times.

use super::html::{HtmlCell, table};
use crate::accuracy::MeasuredScenario;
use crate::report::peers::Author;
use crate::report::summary::{Cheapest, TARGETS, failures, in_ticks, offline, peer};
use crate::report::{StudyReport, text};

const TITLE: &str = "<h2>Cheapest at equal error</h2>\n\
    <p>ns per simulated ms of the cheapest run whose events are all right and this near: \
    in ticks of 5 ms or less, as at a deadline; below it with steps by a tolerance, offline; \
    and, measured in one run of their own, ours side by side with other people's codes and \
    with what was written by hand for the one problem.</p>\n";

/// A table of the cheapest runs at each error.
pub(super) fn glance(report: &StudyReport) -> String {
    let mut header = vec!["scenario".to_owned(), "runs that failed".to_owned()];
    for target in TARGETS {
        header.push(format!("all events within {}", text::duration(target)));
    }
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let rows: Vec<_> = report.measured.iter().flat_map(|it| rows(report, it)).collect();
    TITLE.to_owned() + &table(&header, &rows)
}

/// Our own in ticks, our own offline, and others, as far as there are any.
fn rows(report: &StudyReport, measured: &MeasuredScenario) -> Vec<Vec<HtmlCell>> {
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

fn row(name: &str, failed: &str, cheapest: impl Fn(f64) -> Option<Cheapest>) -> Vec<HtmlCell> {
    let first = [HtmlCell::words(name), HtmlCell::Number(failed.to_owned())];
    let cells = TARGETS.map(|target| HtmlCell::Words(words(cheapest(target))));
    first.into_iter().chain(cells).collect()
}

fn words(cheapest: Option<Cheapest>) -> String {
    cheapest.map_or_else(
        || "—".to_owned(),
        |it| format!("{} ns: {}, {}", text::short(it.ns_per_ms), it.who, it.setting),
    )
}
