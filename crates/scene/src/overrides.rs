//! `--set name=value`: replaces values of a scene by dotted path before the document is checked.
//!
//! A number in a path is an index of a list: `links.bus.0.bit_rate` is that of the first bus.

use super::source::{Override, typed_place};
use documents::quoted;
use documents::toml::{FindingList, SourcePlace, TomlEntry, TomlKind, TomlNode};

/// Limit on names in a path; the longest valid one has four: `keys.0.parameters.restitution`.
const DEEPEST: usize = 8;

/// Names of a key range's voice; a new one replaces all three of the file.
const VOICE: [&str; 3] = ["instrument", "model", "preset"];

/// Applies the override with this `index` to the scene `root`; of equal names the last one wins.
///
/// `keys.0.…` means the first key range, and `keys.…` all of them.
pub(super) fn apply(
    report: &mut FindingList,
    root: &mut TomlNode,
    index: usize,
    Override { name, value, .. }: &Override,
) {
    let place = typed_place(index);
    let steps: Vec<&str> = name.split('.').map(str::trim).collect();
    if steps.iter().any(|step| step.is_empty()) || DEEPEST < steps.len() {
        let help = "write it as render.stepper=heun or keys.0.instrument=grand-reduced";
        report.say(place, format!("{} is no name of a value", quoted(name)), help);
        return;
    }
    let node = TomlNode::typed(value, place);
    match steps.as_slice() {
        ["keys", rest @ ..] if !rest.is_empty() => set_keys(report, root, rest, &node),
        steps => set(report, root, steps, 0, &node),
    }
}

fn set_keys(report: &mut FindingList, root: &mut TomlNode, steps: &[&str], value: &TomlNode) {
    let (chosen, steps) = match steps {
        [first, rest @ ..] => match first.parse::<usize>() {
            Ok(range) => (Some(range), rest),
            Err(_all_ranges) => (None, steps),
        },
        [] => (None, steps),
    };
    let ranges = ranges_of(root);
    let n_ranges = ranges.len();
    if n_ranges <= chosen.unwrap_or(0) {
        let (message, help) = match (chosen, n_ranges) {
            (_, 0) => ("the scene has no key ranges".to_owned(), "add [[keys]] to the file".into()),
            (Some(wanted), 1) => {
                (format!("there is no key range {wanted}"), "use keys.0, the only one".into())
            }
            (wanted, n) => (
                format!("there is no key range {}", wanted.unwrap_or(0)),
                format!("use keys.0 to keys.{}, or keys for all", n - 1),
            ),
        };
        report.miss(value.place, message, help);
        return;
    }
    for (index, range) in ranges.iter_mut().enumerate() {
        if chosen.is_none_or(|chosen| chosen == index) {
            replace_voice(range, steps);
            set(report, range, steps, 0, value);
        }
    }
}

fn ranges_of(root: &mut TomlNode) -> &mut [TomlNode] {
    let TomlKind::Table(entries) = &mut root.kind else { return &mut [] };
    match entries.iter_mut().find(|entry| entry.name == "keys").map(|entry| &mut entry.node.kind) {
        Some(TomlKind::List(ranges)) => ranges,
        _ => &mut [],
    }
}

fn replace_voice(range: &mut TomlNode, steps: &[&str]) {
    if !matches!(steps, ["instrument" | "model"]) {
        return;
    }
    if let TomlKind::Table(entries) = &mut range.kind {
        entries.retain(|entry| {
            matches!(entry.place, SourcePlace { source: 1.., .. })
                || !VOICE.contains(&entry.name.as_str())
        });
    }
}

/// Sets the value at `steps` of a table; the first `depth` of them led to `node`.
fn set(
    report: &mut FindingList,
    node: &mut TomlNode,
    steps: &[&str],
    depth: usize,
    value: &TomlNode,
) {
    let Some(step) = steps.get(depth) else {
        node.clone_from(value);
        return;
    };
    let index = step.parse::<usize>().ok().filter(|_| 0 < depth);
    if index.is_some() || node.items().is_some() {
        match index.and_then(|index| node.item_mut(index)) {
            Some(item) => set(report, item, steps, depth + 1, value),
            None => refuse_item(report, node, steps.get(..depth).unwrap_or(&[]), value.place),
        }
        return;
    }
    if node.entries().is_none() {
        *node = empty(value.place);
    }
    let TomlKind::Table(entries) = &mut node.kind else { return };
    let entry = entry(entries, step, value.place);
    if depth + 1 == steps.len() {
        entry.place = value.place;
    }
    set(report, &mut entry.node, steps, depth + 1, value);
}

fn entry<'a>(entries: &'a mut Vec<TomlEntry>, name: &str, place: SourcePlace) -> &'a mut TomlEntry {
    let found = entries.iter().position(|entry| entry.name == name);
    let index = found.unwrap_or_else(|| {
        entries.push(TomlEntry { name: name.to_owned(), place, node: empty(place) });
        entries.len() - 1
    });
    &mut entries[index]
}

/// Reports that `node` at `path` has no such item.
fn refuse_item(report: &mut FindingList, node: &TomlNode, path: &[&str], place: SourcePlace) {
    let path = path.join(".");
    let n = node.items().map_or(0, <[TomlNode]>::len);
    let help = match n {
        0 => "add one to the file first".to_owned(),
        1 => format!("use {path}.0, the only one"),
        _ => format!("use {path}.0 to {path}.{}", n - 1),
    };
    let what = if n == 0 { "has no items" } else { "is a list without this item" };
    report.miss(place, format!("{} {what}", quoted(&path)), help);
}

const fn empty(place: SourcePlace) -> TomlNode {
    TomlNode { place, kind: TomlKind::Table(Vec::new()) }
}
