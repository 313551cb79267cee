//! Rigid contacts, expanded into constraints, modes and guards before anything is read.
//!
//! A mode in which rigid contacts can close becomes one mode for each set of closed contacts:
//! `free`, `free+stop`. A closed contact is a constraint that opens when its reaction would pull. A
//! contact closes by an impact with its restitution, and stays closed where that leaves no rebound.
//! The expansion has the places of the written text.

use documents::quoted;
use documents::toml::{FindingList, KeyReader, SourcePlace, TomlEntry, TomlKind, TomlNode};
use instruments::equations::MOST_RIGID;

use super::configurations::{Configurations, FamilyNames, JOINT, RigidContact};
use super::toml_making::text;
use crate::kane::mechanism::most_modes;

const KEYS: [&str; 6] = ["rigid", "gap", "restitution", "scale", "sounds", "friction"];

/// Expands the rigid contacts of a description; without any it is unchanged.
pub(super) fn written_out(
    report: &mut FindingList,
    tree: &TomlNode,
) -> Option<(TomlNode, Vec<FamilyNames>)> {
    let RigidContacts { contacts, unreadable } = rigid(report, tree)?;
    let first = contacts.first().map_or(tree.place, |it| it.place);
    let modes = modes(tree);
    for mode in modes.iter().filter(|mode| mode.name.contains(JOINT)) {
        let message =
            format!("{} joins a mode with the rigid contacts that are closed", quoted("+"));
        report.say(mode.place, message, "give the mode a name without it");
    }
    let mut configurations = Configurations::of(tree, &contacts, &modes);
    let count = configurations.count();
    if count > most_modes() {
        let message = format!("the rigid contacts would make {count} modes");
        let help = format!(
            "there are {} at most: leave contacts out of modes with without = [\"…\"], or make \
             some compliant",
            most_modes()
        );
        report.say(first, message, help);
        // The rest is read with all names in it, and without conclusions from its modes.
        configurations.keep_open();
        report.is_broken = true;
    }
    let families = configurations.families();
    if families.iter().any(|family| family.contacts.len() > MOST_RIGID) {
        let message = format!("more than {MOST_RIGID} rigid contacts can close in one mode");
        report.say(first, message, "leave some out of the mode with without = [\"…\"]");
        report.is_broken = true;
    }
    let mut out = tree.clone();
    let written_out: Vec<_> = contacts.iter().map(|it| &it.name).chain(&unreadable).collect();
    without_rigid(&mut out, &written_out);
    let TomlKind::Table(entries) = &mut out.kind else { return None };
    let constraints = contacts.iter().map(RigidContact::constraint).collect();
    extend(entries, "constraints", first, constraints);
    let frictions = contacts.iter().filter_map(|contact| friction(report, contact)).collect();
    extend(entries, "frictions", first, frictions);
    let place = tree.get("modes").map_or(tree.place, |it| it.place);
    entries.retain(|entry| entry.name != "modes");
    extend(entries, "modes", place, configurations.modes());
    for entry in entries.iter_mut() {
        configurations.name_where(entry);
    }
    Some((out, families))
}

#[derive(Default)]
struct RigidContacts {
    contacts: Vec<RigidContact>,
    /// Names of contacts without a gap.
    unreadable: Vec<String>,
}

fn rigid(report: &mut FindingList, tree: &TomlNode) -> Option<RigidContacts> {
    let all = tree.get("contacts")?.node.entries()?;
    let mut found = RigidContacts::default();
    for entry in all {
        let Some(rigid) = entry.node.get("rigid") else { continue };
        if rigid.node.kind == TomlKind::Truth(false) {
            continue;
        }
        if rigid.node.kind != TomlKind::Truth(true) {
            report.say(rigid.place, "rigid is true or false", "write rigid = true");
        }
        let Some(mut keys) = KeyReader::new(report, entry) else { continue };
        for key in KEYS {
            keys.take(key);
        }
        keys.finish(report);
        let Some(gap) = entry.node.get("gap") else {
            let message = format!("\"{}\" has no gap", entry.name);
            report.miss(entry.place, message, "write gap = \"…\", positive apart");
            report.is_broken = true;
            found.unreadable.push(entry.name.clone());
            continue;
        };
        let value = |name: &str| entry.node.get(name).cloned();
        found.contacts.push(RigidContact {
            name: entry.name.clone(),
            place: entry.place,
            gap: gap.node.clone(),
            extras: ["scale", "sounds"].into_iter().filter_map(value).collect(),
            restitution: value("restitution"),
            friction: value("friction"),
        });
    }
    (!found.contacts.is_empty() || !found.unreadable.is_empty()).then_some(found)
}

/// Returns the friction of a closed contact: coefficients times its reaction.
fn friction(report: &mut FindingList, contact: &RigidContact) -> Option<TomlEntry> {
    let entry = contact.friction.as_ref()?;
    let mut keys = KeyReader::new(report, entry)?;
    let mut found: Vec<TomlEntry> = Vec::new();
    found.extend(["slip", "scales"].into_iter().filter_map(|key| keys.take(key).cloned()));
    for (key, limit) in [("coefficient", "stiction"), ("kinetic", "kinetic")] {
        let Some(own) = keys.take(key) else { continue };
        let factor = match &own.node.kind {
            TomlKind::Text(text, _) => text.clone(),
            TomlKind::Integer(number) => number.to_string(),
            TomlKind::Float(number) => number.to_string(),
            TomlKind::Truth(_) | TomlKind::Date | TomlKind::List(_) | TomlKind::Table(_) => {
                report.say(own.place, "a coefficient of friction is a ratio", "write 0.3");
                continue;
            }
        };
        found.push(text(limit, own.place, &format!("({factor})*reaction({})", contact.name)));
    }
    for needed in ["slip", "coefficient"] {
        if keys.take(needed).is_none() {
            let message = format!("the friction of \"{}\" has no {needed}", contact.name);
            report.miss(entry.place, message, format!("write {needed} = \"…\""));
            report.is_broken = true;
        }
    }
    keys.finish(report);
    let node = TomlNode { place: entry.place, kind: TomlKind::Table(found) };
    Some(TomlEntry { name: contact.friction_name()?, place: entry.place, node })
}

fn modes(tree: &TomlNode) -> Vec<TomlEntry> {
    let modes = tree.get("modes").and_then(|it| it.node.entries());
    modes.map_or_else(
        || {
            let node = TomlNode { place: tree.place, kind: TomlKind::Table(Vec::new()) };
            vec![TomlEntry { name: "motion".to_owned(), place: tree.place, node }]
        },
        <[TomlEntry]>::to_vec,
    )
}

/// Removes the contacts called `rigid`, and `rigid = false` of the others.
fn without_rigid(tree: &mut TomlNode, rigid: &[&String]) {
    let TomlKind::Table(entries) = &mut tree.kind else { return };
    let Some(table) = entries.iter_mut().find(|entry| entry.name == "contacts") else { return };
    let TomlKind::Table(all) = &mut table.node.kind else { return };
    all.retain(|entry| !rigid.contains(&&entry.name));
    for entry in all {
        if let TomlKind::Table(keys) = &mut entry.node.kind {
            keys.retain(|key| key.name != "rigid");
        }
    }
}

pub(super) fn extend(
    entries: &mut Vec<TomlEntry>,
    name: &str,
    place: SourcePlace,
    more: Vec<TomlEntry>,
) {
    if let Some(entry) = entries.iter_mut().find(|entry| entry.name == name) {
        if let TomlKind::Table(all) = &mut entry.node.kind {
            all.extend(more);
        }
        return;
    }
    let node = TomlNode { place, kind: TomlKind::Table(more) };
    entries.push(TomlEntry { name: name.to_owned(), place, node });
}
