//! Time as a coordinate with the rate 1, for descriptions that use `t` and give it no meaning.

use documents::toml::{TomlEntry, TomlKind, TomlNode};

use super::rigid::extend;
use super::toml_making::{entry, text};
use crate::kane::text::{Form, PartShape, parse};

const TIME: &str = "t";

/// Tables whose entries are names that expressions can use.
const NAMED: [&str; 4] = ["parameters", "coordinates", "speeds", "definitions"];

/// Keys with prose.
const PROSE: [&str; 4] = ["name", "summary", "doc", "title"];

/// Returns the description with `t` as a coordinate; `None` if it does not use it, or defines it.
pub(super) fn with_time(tree: &TomlNode) -> Option<TomlNode> {
    let is_defined =
        NAMED.iter().any(|table| tree.get(table).is_some_and(|it| it.node.get(TIME).is_some()));
    let input = tree.get("input").and_then(|it| it.node.get("name")?.node.text());
    if is_defined || input == Some(TIME) || !has_time(tree) {
        return None;
    }
    let mut out = tree.clone();
    let place = tree.place;
    let TomlKind::Table(entries) = &mut out.kind else { return None };
    let end = |seconds: i64| TomlNode { place, kind: TomlKind::Integer(seconds) };
    let range = TomlKind::List(vec![end(0), end(1_000_000_000)]);
    let keys = vec![text("unit", place, "s"), entry("range", place, range)];
    extend(entries, "coordinates", place, vec![entry(TIME, place, TomlKind::Table(keys))]);
    extend(entries, "rates", place, vec![text(TIME, place, "1")]);
    Some(out)
}

fn has_time(node: &TomlNode) -> bool {
    let is_prose = |it: &TomlEntry| PROSE.contains(&it.name.as_str());
    if let Some(entries) = node.entries() {
        return entries.iter().any(|it| !is_prose(it) && has_time(&it.node));
    }
    let items = node.items().unwrap_or_default();
    node.text().is_some_and(uses_time) || items.iter().any(has_time)
}

fn uses_time(text: &str) -> bool {
    let is_part = |it: char| it.is_alphanumeric() || it == '_';
    let is_written = text.split(|it| !is_part(it)).any(|word| word == TIME);
    let parsed = is_written.then(|| {
        [Form::Value, Form::Condition].into_iter().find_map(|form| parse(text, form).ok())
    });
    parsed.flatten().is_some_and(|expression| {
        let mut shapes = expression.parts.iter().map(|part| &part.shape);
        shapes.any(|it| matches!(it, PartShape::Name { name, .. } if name == TIME))
    })
}
