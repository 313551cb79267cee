use documents::toml::{SourcePlace, TomlEntry, TomlKind, TomlNode};

use super::toml_making::{each, entry, key_of, list_of, names_in, of_name, table, text};

/// Separator between a mode's name and those of its closed contacts.
pub(super) const JOINT: char = '+';

#[derive(Clone, Debug)]
pub(super) struct RigidContact {
    pub(super) name: String,
    pub(super) place: SourcePlace,
    pub(super) gap: TomlNode,
    pub(super) restitution: Option<TomlEntry>,
    pub(super) friction: Option<TomlEntry>,
    /// Further entries of its guard: a scale, sounds.
    pub(super) extras: Vec<TomlEntry>,
}

/// Written mode, and the numbers of the rigid contacts that can close in it.
#[derive(Clone, Debug)]
struct WrittenMode {
    entry: TomlEntry,
    contacts: Vec<usize>,
    /// Largest number of closed contacts: the mode's degrees of freedom.
    most: usize,
    constraints: Vec<TomlNode>,
}

/// Names of the modes of a family with their closed contacts as bits, and of its contacts.
#[derive(Clone, Debug)]
pub(super) struct FamilyNames {
    pub(super) members: Vec<(String, u32)>,
    pub(super) contacts: Vec<String>,
}

#[derive(Clone, Debug)]
pub(super) struct Configurations<'a> {
    contacts: &'a [RigidContact],
    modes: Vec<WrittenMode>,
}

impl<'a> Configurations<'a> {
    pub(super) fn of(tree: &TomlNode, contacts: &'a [RigidContact], modes: &[TomlEntry]) -> Self {
        let names = |table: &str| tree.get(table).and_then(|it| it.node.entries()).unwrap_or(&[]);
        let rated = names("rates").len();
        let speeds = (names("coordinates").len() + names("speeds").len()).saturating_sub(rated);
        let constraints: Vec<_> =
            names("constraints").iter().map(|it| of_name(&it.name, it.place)).collect();
        let one = |entry: &TomlEntry| {
            let left_out = entry.node.get("without").map_or(Vec::new(), |it| names_in(&it.node));
            let can_close =
                |number: &usize| !left_out.iter().any(|name| *name == contacts[*number].name);
            let own = entry.node.get("constraints").map(|it| list_of(&it.node));
            let constraints = own.unwrap_or_else(|| constraints.clone());
            WrittenMode {
                entry: entry.clone(),
                contacts: (0..contacts.len()).filter(can_close).collect(),
                most: speeds.saturating_sub(constraints.len()),
                constraints,
            }
        };
        Self { contacts, modes: modes.iter().map(one).collect() }
    }

    pub(super) fn keep_open(&mut self) {
        self.modes.iter_mut().for_each(|mode| mode.most = 0);
    }

    pub(super) fn count(&self) -> usize {
        self.modes.iter().fold(0, |all: usize, mode| all.saturating_add(mode.count()))
    }

    /// Returns all modes: the written ones first, then those with closed contacts.
    pub(super) fn modes(&self) -> Vec<TomlEntry> {
        let mut sets: Vec<(&WrittenMode, Vec<usize>)> = Vec::new();
        sets.extend(self.modes.iter().map(|mode| (mode, Vec::new())));
        for mode in &self.modes {
            sets.extend(mode.sets().into_iter().map(|closed| (mode, closed)));
        }
        sets.iter().map(|(mode, closed)| self.mode(mode, closed)).collect()
    }

    /// Returns the families in which several contacts can close.
    pub(super) fn families(&self) -> Vec<FamilyNames> {
        let several = self.modes.iter().filter(|mode| mode.contacts.len() > 1 && mode.most > 0);
        several.map(|mode| self.family(mode)).collect()
    }

    fn family(&self, mode: &WrittenMode) -> FamilyNames {
        let member = |closed: &[usize]| {
            let own = mode.contacts.iter().enumerate().filter(|(_, it)| closed.contains(it));
            (self.name(&mode.entry.name, closed), own.fold(0, |all, (at, _)| all | 1 << at))
        };
        let sets = mode.sets();
        FamilyNames {
            members: std::iter::once(member(&[])).chain(sets.iter().map(|it| member(it))).collect(),
            contacts: mode.contacts.iter().map(|it| self.contacts[*it].name.clone()).collect(),
        }
    }

    fn mode(&self, mode: &WrittenMode, closed: &[usize]) -> TomlEntry {
        let place = mode.entry.place;
        let mut keys: Vec<TomlEntry> = mode.entry.node.entries().unwrap_or(&[]).to_vec();
        let replaced = |key: &TomlEntry| {
            !matches!(key.name.as_str(), "constraints" | "without" | "guards")
                && (closed.is_empty() || key.name != "independent")
        };
        let mut guards =
            keys.iter().find(|key| key.name == "guards").map_or(Vec::new(), |it| list_of(&it.node));
        let without = keys.iter().find(|key| key.name == "without");
        let mut rest = without.map_or(Vec::new(), |it| list_of(&it.node));
        let is_rigid =
            |node: &TomlNode| self.contacts.iter().any(|it| node.text() == Some(&it.name));
        rest.retain(|node| !is_rigid(node));
        let open = self.contacts.iter().enumerate().filter(|(it, _)| !closed.contains(it));
        let idle = open.filter_map(|(_, contact)| contact.friction_name());
        rest.extend(idle.map(|name| of_name(&name, place)));
        keys.retain(replaced);
        keys.push(entry("without", place, TomlKind::List(rest)));
        for guard in &mut guards {
            self.lead(guard, closed);
        }
        guards.extend(closed.iter().map(|contact| self.opening(mode, closed, *contact)));
        let open = mode.contacts.iter().filter(|contact| !closed.contains(contact));
        guards.extend(open.map(|contact| self.closing(mode, closed, *contact)));
        let held = closed.iter().map(|it| of_name(&self.contacts[*it].name, place));
        let constraints = mode.constraints.iter().cloned().chain(held).collect();
        keys.push(entry("constraints", place, TomlKind::List(constraints)));
        keys.push(entry("guards", place, TomlKind::List(guards)));
        let name = self.name(&mode.entry.name, closed);
        let node = TomlNode { place, kind: TomlKind::Table(keys) };
        TomlEntry { name, place, node }
    }

    /// Returns a name like `free+stop`, with the contacts in the order of the file.
    fn name(&self, mode: &str, closed: &[usize]) -> String {
        closed
            .iter()
            .fold(mode.to_owned(), |name, it| format!("{name}{JOINT}{}", self.contacts[*it].name))
    }

    /// Returns the guard that opens a contact: its reaction would pull.
    fn opening(&self, mode: &WrittenMode, closed: &[usize], contact: usize) -> TomlNode {
        let RigidContact { name, place, .. } = &self.contacts[contact];
        let left: Vec<_> = closed.iter().copied().filter(|it| *it != contact).collect();
        let to = self.name(&mode.entry.name, &left);
        table(
            *place,
            vec![
                text("name", *place, &format!("{name}_opens")),
                text("positive", *place, &format!("reaction({name})")),
                text("to", *place, &to),
            ],
        )
    }

    /// Returns the guard that closes a contact: with a rebound, or without.
    fn closing(&self, mode: &WrittenMode, closed: &[usize], contact: usize) -> TomlNode {
        let RigidContact { name, place, gap, restitution, extras, .. } = &self.contacts[contact];
        let mut together: Vec<_> = closed.iter().copied().chain([contact]).collect();
        together.sort_unstable();
        let own = self.name(&mode.entry.name, closed);
        let mut impact =
            vec![TomlEntry { name: "along".to_owned(), place: *place, node: gap.clone() }];
        impact.extend(restitution.clone());
        if mode.sets().contains(&together) {
            impact.push(text("settles", *place, &self.name(&mode.entry.name, &together)));
        }
        let mut keys = vec![
            text("name", *place, name),
            TomlEntry { name: "positive".to_owned(), place: *place, node: gap.clone() },
            text("to", *place, &own),
            entry("impact", *place, TomlKind::Table(impact)),
        ];
        keys.extend(extras.iter().cloned());
        table(*place, keys)
    }

    /// Redirects a guard to the modes with equal closed contacts, where these exist.
    fn lead(&self, guard: &mut TomlNode, closed: &[usize]) {
        let TomlKind::Table(keys) = &mut guard.kind else { return };
        for key in keys {
            match (key.name.as_str(), &mut key.node.kind) {
                ("to" | "mode" | "within" | "settles", TomlKind::Text(name, _)) => {
                    *name = self.next(name, closed);
                }
                ("to", TomlKind::List(ways)) => self.lead_each(ways, closed),
                ("to" | "impact", TomlKind::Table(_)) => self.lead(&mut key.node, closed),
                _ => {}
            }
        }
    }

    fn lead_each(&self, ways: &mut [TomlNode], closed: &[usize]) {
        for way in ways {
            self.lead(way, closed);
        }
    }

    /// Returns the mode `name` with the contacts `closed`, or without them where they cannot close.
    fn next(&self, name: &str, closed: &[usize]) -> String {
        let mode = self.modes.iter().find(|it| it.entry.name == name);
        let is_one = mode.is_some_and(|mode| mode.sets().iter().any(|set| set == closed));
        if is_one { self.name(name, closed) } else { name.to_owned() }
    }

    pub(super) fn name_where(&self, entry: &mut TomlEntry) {
        match entry.name.as_str() {
            "outputs" => each(&mut entry.node, &mut |output| {
                key_of(output, "in", &mut |modes| self.name_entries(modes));
            }),
            "drawing" => each(&mut entry.node, &mut |table| {
                each(table, &mut |item| {
                    key_of(item, "in", &mut |modes| self.name_entries(modes));
                    self.name_shown(item);
                });
            }),
            _ => {}
        }
    }

    /// Adds the configurations to the modes of an outline or spring, or of those in a list.
    fn name_shown(&self, item: &mut TomlNode) {
        key_of(item, "modes", &mut |modes| self.name_items(modes));
        if let TomlKind::List(items) = &mut item.kind {
            for item in items {
                self.name_shown(item);
            }
        }
    }

    fn configurations_of(&self, name: &str) -> Vec<String> {
        let mode = self.modes.iter().find(|it| it.entry.name == name);
        let sets = mode.map_or(Vec::new(), WrittenMode::sets);
        sets.iter().map(|closed| self.name(name, closed)).collect()
    }

    fn name_entries(&self, table: &mut TomlNode) {
        let TomlKind::Table(entries) = &mut table.kind else { return };
        for entry in entries.clone() {
            let known = |name: &String| entries.iter().any(|it| it.name == *name);
            let mut names = self.configurations_of(&entry.name);
            names.retain(|name| !known(name));
            entries.extend(names.into_iter().map(|name| TomlEntry { name, ..entry.clone() }));
        }
    }

    fn name_items(&self, list: &mut TomlNode) {
        let all = list_of(list);
        let more = all.iter().flat_map(|item| {
            let names = self.configurations_of(item.text().unwrap_or(""));
            names.into_iter().map(|name| of_name(&name, item.place)).collect::<Vec<_>>()
        });
        list.kind = TomlKind::List(all.iter().cloned().chain(more).collect());
    }
}

impl WrittenMode {
    fn count(&self) -> usize {
        let n = self.contacts.len();
        let mut ways: usize = 1;
        let mut all: usize = 1;
        for k in 1..=self.most.min(n) {
            ways = ways.saturating_mul(n - k + 1) / k;
            all = all.saturating_add(ways);
        }
        all
    }

    /// Returns the non-empty sets of contacts that can be closed, the small ones first.
    fn sets(&self) -> Vec<Vec<usize>> {
        let mut all: Vec<Vec<usize>> = vec![Vec::new()];
        let mut first = 0;
        for _ in 0..self.most.min(self.contacts.len()) {
            let last = all.len();
            for index in first..last {
                let set = all[index].clone();
                let above = set.last().copied();
                let more = self.contacts.iter().filter(|it| above.is_none_or(|at| **it > at));
                all.extend(more.map(|it| set.iter().copied().chain([*it]).collect::<Vec<_>>()));
            }
            first = last;
        }
        all.remove(0);
        all
    }
}

impl RigidContact {
    pub(super) fn friction_name(&self) -> Option<String> {
        self.friction.is_some().then(|| format!("{}_friction", self.name))
    }

    pub(super) fn constraint(&self) -> TomlEntry {
        let zero = TomlEntry { name: "zero".to_owned(), place: self.place, node: self.gap.clone() };
        entry(&self.name, self.place, TomlKind::Table(vec![zero]))
    }
}
