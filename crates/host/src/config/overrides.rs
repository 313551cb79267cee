//! `--set name=value`: values of a scene by dotted path, put into the document before it is checked.

use super::document::{Entry, Node, Value};
use super::report::{Place, Report};
use crate::names::quoted;

/// Names in the longest path that means anything are four: `keys.0.parameters.restitution`.
const DEEPEST: usize = 8;

/// What a key range's model comes from; a new one replaces what the file says of all three.
const VOICE: [&str; 3] = ["instrument", "model", "preset"];

/// Puts `overrides` into the scene `root`, the last of a name winning.
///
/// `keys.0.…` means the first key range, and `keys.…` all of them.
pub(super) fn apply(report: &mut Report<'_>, root: &mut Node, overrides: &[(String, String)]) {
    for (index, (name, value)) in overrides.iter().enumerate() {
        let place = Place::Override(index);
        let steps: Vec<&str> = name.split('.').map(str::trim).collect();
        if steps.iter().any(|step| step.is_empty()) || DEEPEST < steps.len() {
            let help = "write it as render.stepper=heun or keys.0.instrument=grand-rigid";
            report.say(place, format!("{} is no name of a value", quoted(name)), help);
            continue;
        }
        let node = Node::overriding(value, place);
        match steps.as_slice() {
            ["keys", rest @ ..] if !rest.is_empty() => set_keys(report, root, rest, &node),
            steps => set(root, steps, &node),
        }
    }
}

/// Sets the value at `steps` of some or all key ranges.
fn set_keys(report: &mut Report<'_>, root: &mut Node, steps: &[&str], value: &Node) {
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
            set(range, steps, value);
        }
    }
}

fn ranges_of(root: &mut Node) -> &mut [Node] {
    let Value::Table(entries) = &mut root.value else { return &mut [] };
    match entries.iter_mut().find(|entry| entry.name == "keys").map(|entry| &mut entry.node.value) {
        Some(Value::List(ranges)) => ranges,
        _ => &mut [],
    }
}

/// Removes what the file says of the voice, if `steps` set another.
fn replace_voice(range: &mut Node, steps: &[&str]) {
    if !matches!(steps, ["instrument" | "model"]) {
        return;
    }
    if let Value::Table(entries) = &mut range.value {
        entries.retain(|entry| {
            matches!(entry.place, Place::Override(_)) || !VOICE.contains(&entry.name.as_str())
        });
    }
}

/// Sets the value at `steps` of `node`; whether it belongs there is checked later.
fn set(node: &mut Node, steps: &[&str], value: &Node) {
    let [first, rest @ ..] = steps else {
        node.clone_from(value);
        return;
    };
    if node.entries().is_none() {
        *node = empty(value.place);
    }
    let Value::Table(entries) = &mut node.value else { return };
    let found = entries.iter().position(|entry| entry.name == *first);
    let index = found.unwrap_or_else(|| {
        let node = empty(value.place);
        entries.push(Entry { name: (*first).to_owned(), place: value.place, node });
        entries.len() - 1
    });
    let entry = &mut entries[index];
    if rest.is_empty() {
        entry.place = value.place;
    }
    set(&mut entry.node, rest, value);
}

const fn empty(place: Place) -> Node {
    Node { place, value: Value::Table(Vec::new()) }
}
