//! Generated nodes of a tree, at the place of the text from which they follow.

use documents::toml::{SourcePlace, TomlEntry, TomlKind, TomlNode};

pub(super) fn entry(name: &str, place: SourcePlace, kind: TomlKind) -> TomlEntry {
    TomlEntry { name: name.to_owned(), place, node: TomlNode { place, kind } }
}

pub(super) fn text(name: &str, place: SourcePlace, text: &str) -> TomlEntry {
    entry(name, place, TomlKind::Text(text.to_owned(), false))
}

pub(super) fn table(place: SourcePlace, entries: Vec<TomlEntry>) -> TomlNode {
    TomlNode { place, kind: TomlKind::Table(entries) }
}

pub(super) fn of_name(name: &str, place: SourcePlace) -> TomlNode {
    TomlNode { place, kind: TomlKind::Text(name.to_owned(), false) }
}

/// Returns the items of a list, or a single value as a list.
pub(super) fn list_of(node: &TomlNode) -> Vec<TomlNode> {
    node.items().map_or_else(|| vec![node.clone()], <[TomlNode]>::to_vec)
}

/// Returns the texts of a list, or a single text as a list.
pub(super) fn names_in(node: &TomlNode) -> Vec<String> {
    list_of(node).iter().filter_map(|it| it.text().map(str::to_owned)).collect()
}

pub(super) fn each(node: &mut TomlNode, act: &mut dyn FnMut(&mut TomlNode)) {
    match &mut node.kind {
        TomlKind::Table(entries) => entries.iter_mut().for_each(|it| act(&mut it.node)),
        TomlKind::List(items) => items.iter_mut().for_each(act),
        TomlKind::Text(..)
        | TomlKind::Integer(_)
        | TomlKind::Float(_)
        | TomlKind::Truth(_)
        | TomlKind::Date => {}
    }
}

pub(super) fn key_of(node: &mut TomlNode, name: &str, act: &mut dyn FnMut(&mut TomlNode)) {
    let TomlKind::Table(entries) = &mut node.kind else { return };
    for entry in entries.iter_mut().filter(|entry| entry.name == name) {
        act(&mut entry.node);
    }
}
