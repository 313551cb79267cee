//! One word for one thing, and comments that say something.

use std::collections::{BTreeMap, BTreeSet};

use syn::{Item, Visibility};

use crate::sources::{self, Source};

/// Names of types that may stand in more than one crate, with the reason.
const SHARED: &[(&str, &str)] = &[
    ("Epoch", "an interval in which one mode holds, drawn by the window and by plots"),
    ("Error", "the errors of a crate"),
    ("Mode", "the contact configurations of a model"),
];

#[test]
fn a_type_s_name_stands_for_one_thing_in_the_whole_workspace() {
    let mut rooms = BTreeMap::<String, BTreeSet<String>>::new();
    for source in sources::all() {
        for name in source.syntax.items.iter().filter_map(type_name) {
            rooms.entry(name).or_default().insert(source.room.clone());
        }
    }
    let shared: BTreeMap<_, _> = rooms.iter().filter(|(_, rooms)| 1 < rooms.len()).collect();
    let may = |name: &str| SHARED.iter().any(|(may, _)| *may == name);
    let double = shared.iter().filter(|(name, _)| !may(name));
    let double: Vec<_> = double.map(|(name, rooms)| format!("{name}: {rooms:?}")).collect();
    assert!(double.is_empty(), "one word for one thing:\n{}", double.join("\n"));
    for (name, _) in SHARED {
        assert!(shared.contains_key(&(*name).to_owned()), "{name} is not shared any more");
    }
}

#[test]
fn every_public_type_says_what_it_is() {
    let mut silent = Vec::new();
    for source in sources::all() {
        for item in source.syntax.items.iter().filter(|it| is_public(it)) {
            let has_doc = sources::attributes(item).iter().any(|it| it.path().is_ident("doc"));
            if let Some(name) = type_name(item).filter(|_| !has_doc) {
                silent.push(format!("{}: {name}", source.path.display()));
            }
        }
    }
    assert!(silent.is_empty(), "{} types have no doc:\n{}", silent.len(), silent.join("\n"));
}

#[expect(clippy::wildcard_enum_match_arm, reason = "the enum of items is open")]
const fn is_public(item: &Item) -> bool {
    let visibility = match item {
        Item::Enum(it) => &it.vis,
        Item::Struct(it) => &it.vis,
        Item::Trait(it) => &it.vis,
        Item::Type(it) => &it.vis,
        _ => return false,
    };
    matches!(visibility, Visibility::Public(_))
}

/// Folders of what prints paths of its own making, of devices, or on a developer's terminal.
const PRINT_RAW: [&str; 3] = ["dashboard/src", "boards/src/links", "xtask/src"];

#[test]
fn names_of_files_are_escaped_wherever_they_are_printed() {
    let is_raw = |source: &Source| {
        let text = std::fs::read_to_string(&source.path).unwrap_or_default();
        let prints_raw = PRINT_RAW.iter().any(|it| source.path.to_string_lossy().contains(it));
        !prints_raw && text.contains(".display()")
    };
    let raw: Vec<_> = sources::all().into_iter().filter(is_raw).map(|it| it.path).collect();
    assert!(raw.is_empty(), "use documents::shown instead of display(): {raw:?}");
}

#[expect(clippy::wildcard_enum_match_arm, reason = "the enum of items is open")]
fn type_name(item: &Item) -> Option<String> {
    match item {
        Item::Enum(it) => Some(it.ident.to_string()),
        Item::Struct(it) => Some(it.ident.to_string()),
        Item::Trait(it) => Some(it.ident.to_string()),
        Item::Type(it) => Some(it.ident.to_string()),
        _ => None,
    }
}
