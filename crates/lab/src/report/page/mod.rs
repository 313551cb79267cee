//! The page: what was measured, on one sheet that needs no other file.
//!
//! `glance` the comparison at equal error, `runs` the tables of all runs, `html` the marks.

mod glance;
mod html;
mod runs;

pub use html::{HtmlCell, escape, table};

use super::{StudyReport, date};
use crate::accuracy::MeasuredScenario;

/// The style sheet of all pages.
pub const STYLE: &str = include_str!("style.css");

/// What a reader must know before looking at a plot.
const HOW_TO_READ: &str = include_str!("how_to_read.html");

/// The page with the plots of each scenario.
pub(super) fn html(report: &StudyReport, plots: &[Vec<String>]) -> String {
    let machine = &report.machine;
    let head = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>Letoff: speed against error</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>Speed against error</h1>\n<p>{} · {}, {} of them, {} · {}.</p>\n",
        escape(&date::utc(report.date)),
        escape(&machine.processor),
        machine.processors,
        escape(&machine.system),
        escape(&machine.program),
    );
    let mut page = head + HOW_TO_READ + &glance::glance(report);
    for (measured, plots) in report.measured.iter().zip(plots) {
        page += &heading(measured, plots);
        page += &runs::ours(measured);
        page += &runs::theirs(&report.peers_on(measured.entry.name));
    }
    page + "</body>\n</html>\n"
}

/// A scenario's title, what its reference is, and its plots.
fn heading(measured: &MeasuredScenario, plots: &[String]) -> String {
    let plots = plots.join("</figure>\n<figure>\n");
    let [name, title, source] =
        [measured.entry.name, measured.entry.title, measured.entry.source].map(escape);
    format!(
        "<h2 id=\"{name}\">{name}: {title}</h2>\n<p>{source}</p>\n\
         <figure>\n{plots}</figure>\n"
    )
}
