//! Bases: descriptions from which others start.

use documents::quoted;
use documents::toml::{
    self, FindingList, SourcePlace, TextPlace, TomlEntry, TomlKind, TomlNode, TomlSource,
};

use super::LONGEST;

const MOST_BASES: usize = 8;

/// Source of the bases of descriptions.
pub trait Bases {
    /// Returns the bytes of the description `base` named by the description `from`, and its name in
    /// reported mistakes.
    ///
    /// # Errors
    /// The reason in words.
    fn load(&self, base: &str, from: &str) -> Result<(String, Vec<u8>), String>;
}

impl Bases for () {
    fn load(&self, _base: &str, _from: &str) -> Result<(String, Vec<u8>), String> {
        Err("there are no other descriptions here".to_owned())
    }
}

/// Returns the tree of `source` merged onto its bases; the deepest base first.
pub(super) fn merged(
    report: &mut FindingList,
    source: TomlSource,
    bases: &dyn Bases,
) -> Option<TomlNode> {
    let mut chain: Vec<(String, TomlNode)> = Vec::new();
    let mut next = Some(source);
    while let Some(source) = next {
        let name = source.name.clone();
        let number = report.source(source);
        let tree = toml::parse(report, number, TextPlace::FirstCharacter)?;
        next = base_of(report, &tree, &name, &chain, bases);
        chain.push((name, tree));
    }
    let (_, mut tree) = chain.pop()?;
    while let Some((_, mut over)) = chain.pop() {
        remove(report, &mut tree, &over);
        take_out(&mut over, "remove");
        take_out(&mut over, "base");
        merge(&mut tree, over);
    }
    take_out(&mut tree, "base");
    Some(tree)
}

fn take_out(tree: &mut TomlNode, name: &str) {
    if let TomlKind::Table(entries) = &mut tree.kind {
        entries.retain(|entry| entry.name != name);
    }
}

fn base_of(
    report: &mut FindingList,
    tree: &TomlNode,
    from: &str,
    chain: &[(String, TomlNode)],
    bases: &dyn Bases,
) -> Option<TomlSource> {
    let entry = tree.get("base")?;
    let (base, place) = toml::text(report, "base", &entry.node)?;
    if chain.len() + 1 >= MOST_BASES {
        let message = format!("more than {MOST_BASES} descriptions start one from the other");
        report.say(place, message, "start from one nearer to the first");
        return None;
    }
    let (name, bytes) = match bases.load(base, from) {
        Ok(loaded) => loaded,
        Err(reason) => {
            let message = format!("the base {} cannot be read, {reason}", quoted(base));
            report.say(place, message, "give the path of a description, as \"other.toml\"");
            return None;
        }
    };
    if name == from || chain.iter().any(|(known, _)| *known == name) {
        let message = format!("the base {} starts from this description itself", quoted(base));
        report.say(place, message, "end the circle: remove one of the bases");
        return None;
    }
    if bytes.len() > LONGEST {
        let message = format!("the base {} is longer than {LONGEST} bytes", quoted(base));
        report.say(place, message, "give a description");
        return None;
    }
    match String::from_utf8(bytes) {
        Ok(text) => Some(TomlSource { name, text }),
        Err(_no_text) => {
            let message = format!("the base {} is not UTF-8 text", quoted(base));
            report.say(place, message, "give a description");
            None
        }
    }
}

fn remove(report: &mut FindingList, tree: &mut TomlNode, over: &TomlNode) {
    let Some(entry) = over.get("remove") else { return };
    for item in toml::list(report, "remove", &entry.node) {
        let Some((path, place)) = toml::text(report, "remove", item) else { continue };
        if !remove_path(tree, path) {
            let message = format!("the base has no {}", quoted(path));
            report.say(place, message, "write the path of a table or key, as springs.k1");
        }
    }
}

/// Removes `path`, as `springs.k1`; returns `false` if it does not exist.
fn remove_path(tree: &mut TomlNode, path: &str) -> bool {
    let mut node = tree;
    let mut names = path.split('.').peekable();
    while let Some(name) = names.next() {
        let TomlKind::Table(entries) = &mut node.kind else { return false };
        let Some(at) = entries.iter().position(|entry| entry.name == name) else { return false };
        if names.peek().is_none() {
            entries.remove(at);
            return true;
        }
        let Some(entry) = entries.get_mut(at) else { return false };
        node = &mut entry.node;
    }
    false
}

/// Merges `over` onto `tree`: tables key by key, other values whole. TOML limits the depth.
fn merge(tree: &mut TomlNode, over: TomlNode) {
    let TomlNode { place, kind } = over;
    match (&mut tree.kind, kind) {
        (TomlKind::Table(entries), TomlKind::Table(new)) => {
            for entry in new {
                enter(entries, entry);
            }
        }
        (_, kind) => *tree = TomlNode { place, kind },
    }
}

fn enter(entries: &mut Vec<TomlEntry>, new: TomlEntry) {
    match entries.iter_mut().find(|entry| entry.name == new.name) {
        Some(old) => {
            old.place = new.place;
            merge(&mut old.node, new.node);
        }
        None => entries.push(new),
    }
}

pub(super) const fn start(source: usize) -> SourcePlace {
    SourcePlace { source, offset: 0 }
}
