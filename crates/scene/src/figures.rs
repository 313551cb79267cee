//! `[figures]`: what should be measured of an instrument, by name.

use super::document::{DocumentNode, TomlValue};
use super::quantity::Quantity;
use super::read::{self, TableReader, wrong_type};
use super::report::MistakeList;
use diagnostics::quoted;

/// A limit may be `inf`: then there is none on that side.
const LIMIT: Quantity = Quantity { unit: "", range: (f64::NEG_INFINITY, f64::INFINITY) };

/// Reads the lowest and the highest value that each figure should have.
pub(super) fn read(
    report: &mut MistakeList<'_>,
    instrument: &mut TableReader<'_>,
) -> Vec<(String, (f64, f64))> {
    let Some(entry) = instrument.take("figures") else { return Vec::new() };
    let Some(figures) = entry.node.entries() else {
        wrong_type(report, "figures", &entry.node, "a table", "write it as [figures]");
        return Vec::new();
    };
    let limits = |report: &mut MistakeList<'_>, name: &str, node: &DocumentNode| {
        let TomlValue::List(items) = &node.value else {
            wrong_type(report, name, node, "a list", "give the lowest and the highest value");
            return None;
        };
        let [low, high] = items.as_slice() else {
            let message = format!("{} has {} values", quoted(name), items.len());
            report.say(node.place, message, "give the lowest and the highest value");
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
    };
    let figure = |report: &mut MistakeList<'_>, name: &str, node: &DocumentNode| {
        Some((name.to_owned(), limits(report, name, node)?))
    };
    figures.iter().filter_map(|it| figure(report, &it.name, &it.node)).collect()
}
