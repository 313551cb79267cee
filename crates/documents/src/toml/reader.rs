//! Access to the entries of one table; unknown entries are reported.

use super::report::{FindingList, SourcePlace};
use super::tree::{TomlEntry, TomlKind, TomlNode};
use crate::{choice, quoted};

/// Reader of the entries of one table.
#[derive(Debug)]
pub struct KeyReader<'a> {
    entries: &'a [TomlEntry],
    /// Position of the table, or of its name.
    pub place: SourcePlace,
    known: Vec<&'static str>,
}

impl<'a> KeyReader<'a> {
    pub fn new(report: &mut FindingList, entry: &'a TomlEntry) -> Option<Self> {
        let Some(entries) = entry.node.entries() else {
            let help = format!("write it as {} = {{ … }}", entry.name);
            wrong_kind(report, &entry.name, &entry.node, "a table", &help);
            return None;
        };
        Some(Self { entries, place: entry.place, known: Vec::new() })
    }

    /// Returns a reader of a table without a name of its own.
    pub fn of(report: &mut FindingList, name: &str, node: &'a TomlNode) -> Option<Self> {
        Self::of_table(report, name, node, "write it as { … }")
    }

    /// Like [`Self::of`], but advises `help` if `node` is not a table.
    pub fn of_table(
        report: &mut FindingList,
        name: &str,
        node: &'a TomlNode,
        help: &str,
    ) -> Option<Self> {
        let Some(entries) = node.entries() else {
            wrong_kind(report, name, node, "a table", help);
            return None;
        };
        Some(Self { entries, place: node.place, known: Vec::new() })
    }

    pub fn take(&mut self, name: &'static str) -> Option<&'a TomlEntry> {
        if !self.known.contains(&name) {
            self.known.push(name);
        }
        self.entries.iter().find(|entry| entry.name == name)
    }

    pub fn text(
        &mut self,
        report: &mut FindingList,
        name: &'static str,
    ) -> Option<(&'a str, SourcePlace)> {
        let entry = self.take(name)?;
        text(report, name, &entry.node)
    }

    /// Returns the items of the list `name`; empty if it is missing.
    pub fn list(&mut self, report: &mut FindingList, name: &'static str) -> &'a [TomlNode] {
        self.take(name).map_or(&[], |entry| list(report, name, &entry.node))
    }

    /// Returns the entries of the table `name`, which may have any names.
    pub fn table(&mut self, report: &mut FindingList, name: &'static str) -> &'a [TomlEntry] {
        let Some(entry) = self.take(name) else { return &[] };
        entry.node.entries().unwrap_or_else(|| {
            wrong_kind(report, name, &entry.node, "a table", &format!("write it as [{name}]"));
            &[]
        })
    }

    /// Returns the truth value `name`; `false` if it is missing.
    pub fn is_set(&mut self, report: &mut FindingList, name: &'static str) -> bool {
        let Some(entry) = self.take(name) else { return false };
        if let TomlKind::Truth(truth) = entry.node.kind {
            return truth;
        }
        wrong_kind(report, name, &entry.node, "true or false", "write it without quotes");
        false
    }

    /// Returns the entries that no call has asked for: their names are free.
    pub fn others(&self) -> impl Iterator<Item = &'a TomlEntry> + use<'a, '_> {
        self.entries.iter().filter(|entry| !self.known.contains(&entry.name.as_str()))
    }

    pub fn finish(self, report: &mut FindingList) {
        for entry in self.others().take(FindingList::MOST) {
            let message = format!("there is no key {} here", quoted(&entry.name));
            report.say(entry.place, message, choice(&entry.name, self.known.iter().copied()));
        }
    }
}

/// Reports that `node`, called `name`, must be of another kind.
pub fn wrong_kind(
    report: &mut FindingList,
    name: &str,
    node: &TomlNode,
    expected: &str,
    help: &str,
) {
    let message = format!("{} is {}, not {expected}", quoted(name), node.words());
    report.say(node.place, message, help);
}

pub fn text<'a>(
    report: &mut FindingList,
    name: &str,
    node: &'a TomlNode,
) -> Option<(&'a str, SourcePlace)> {
    let Some(text) = node.text() else {
        wrong_kind(report, name, node, "text", "write it in quotes");
        return None;
    };
    Some((text, node.place))
}

pub fn list<'a>(report: &mut FindingList, name: &str, node: &'a TomlNode) -> &'a [TomlNode] {
    node.items().unwrap_or_else(|| {
        wrong_kind(report, name, node, "a list", "write it in [ ]");
        &[]
    })
}
