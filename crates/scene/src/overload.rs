//! `[overload]`: what is simplified while a tick has more work than time, in which order.

use scheduler::overload::{OverloadRules, Simplification};
use toml_edit::{Array, Table, value};

use super::quantity::Quantity;
use super::read::{self, TableReader};
use documents::toml::{FindingList, SourcePlace, TomlKind};

/// Fraction of a tick.
const LOAD: Quantity = Quantity { unit: "1", range: (0.01, 2.0) };

const EVALUATIONS: Quantity = Quantity { unit: "1", range: (1.0, 1e9) };

pub(super) fn read(report: &mut FindingList, scene: &mut TableReader<'_>) -> OverloadRules {
    let mut rules = OverloadRules::default();
    let Some(mut reader) = scene.table(report, "overload") else { return rules };
    rules.order = read_order(report, &mut reader).unwrap_or(rules.order);
    rules.above = reader.number(report, "above", LOAD).unwrap_or(rules.above);
    rules.below = reader.number(report, "below", LOAD).unwrap_or(rules.below);
    if rules.above <= rules.below {
        let message = format!("\"above\" is {} and \"below\" is {}", rules.above, rules.below);
        let help = "give a load to go back below that is lower, as below = 0.4 with above = 0.8";
        report.say(reader.place, message, help);
    }
    rules.evaluations = reader.whole(report, "evaluations", EVALUATIONS);
    reader.finish(report);
    rules
}

fn read_order(
    report: &mut FindingList,
    reader: &mut TableReader<'_>,
) -> Option<[Option<Simplification>; Simplification::ALL.len()]> {
    let entry = reader.take("order")?;
    let TomlKind::List(nodes) = &entry.node.kind else {
        let help =
            "write what is left out first, as [\"telemetry\", \"slopes\"], or [] for nothing";
        read::wrong_kind(report, "order", &entry.node, "a list", help);
        return None;
    };
    let mut order: Vec<Simplification> = Vec::new();
    for node in nodes {
        let Some(name) = read::text(report, "order", node) else { continue };
        order.extend(known(report, node.place, &name, &order));
    }
    let mut order = order.into_iter();
    Some([(); Simplification::ALL.len()].map(|()| order.next()))
}

/// Returns the simplification called `name`, unless it is in `order`.
fn known(
    report: &mut FindingList,
    place: SourcePlace,
    name: &str,
    order: &[Simplification],
) -> Option<Simplification> {
    let Some(found) = Simplification::ALL.into_iter().find(|it| it.name() == name) else {
        let names = Simplification::ALL.into_iter().map(Simplification::name);
        read::unknown(report, place, "nothing that can be left out is called", name, names);
        return None;
    };
    if order.contains(&found) {
        report.say(place, format!("\"{name}\" is there twice"), "name it once");
        return None;
    }
    Some(found)
}

pub(super) fn written(rules: &OverloadRules) -> Table {
    let mut table = Table::new();
    let order = rules.order.iter().flatten().map(|it| it.name());
    table["order"] = value(order.collect::<Array>());
    table["above"] = value(rules.above);
    table["below"] = value(rules.below);
    if let Some(count) = rules.evaluations {
        table["evaluations"] = value(i64::from(count));
    }
    table
}
