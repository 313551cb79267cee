//! `[figures]`: target ranges of an instrument's measured figures, by name.

use super::quantity::Quantity;
use super::read::{self, TableReader, wrong_kind};
use documents::quoted;
use documents::toml::{FindingList, TomlKind, TomlNode};

const LIMIT: Quantity = Quantity { unit: "", range: (f64::MIN, f64::MAX) };

const HELP: &str = "give [lowest, highest], { at_least = … } or { at_most = … }";

/// Reads the lowest and highest value of each figure; a missing limit is infinite.
pub(super) fn read(
    report: &mut FindingList,
    instrument: &mut TableReader<'_>,
) -> Vec<(String, (f64, f64))> {
    let Some(entry) = instrument.take("figures") else { return Vec::new() };
    let Some(figures) = entry.node.entries() else {
        wrong_kind(report, "figures", &entry.node, "a table", "write it as [figures]");
        return Vec::new();
    };
    let mut read = Vec::new();
    for figure in figures {
        let limits = limits(report, &figure.name, &figure.node);
        read.extend(limits.map(|limits| (figure.name.clone(), limits)));
    }
    read
}

fn limits(report: &mut FindingList, name: &str, node: &TomlNode) -> Option<(f64, f64)> {
    let TomlKind::List(items) = &node.kind else { return limit(report, name, node) };
    let [low, high] = items.as_slice() else {
        report.say(node.place, format!("{} has {} values", quoted(name), items.len()), HELP);
        return None;
    };
    let low = read::number(report, name, low, LIMIT)?;
    let high = read::number(report, name, high, LIMIT)?;
    if low > high {
        let message = format!("{} has its lowest value above its highest", quoted(name));
        report.say(node.place, message, "give the lowest value first");
        return None;
    }
    Some((low, high))
}

fn limit(report: &mut FindingList, name: &str, node: &TomlNode) -> Option<(f64, f64)> {
    if node.entries().is_none() {
        wrong_kind(report, name, node, "a list or a table", HELP);
        return None;
    }
    let mut reader = TableReader::new(report, name, node)?;
    let low = reader.number(report, "at_least", LIMIT);
    let high = reader.number(report, "at_most", LIMIT);
    if low.is_none() && high.is_none() {
        report.say(node.place, format!("{} has no limit", quoted(name)), HELP);
    }
    reader.finish(report);
    Some((low.unwrap_or(f64::NEG_INFINITY), high.unwrap_or(f64::INFINITY)))
}
