//! Collects every name of a description with its expressions.

use documents::quoted;
use documents::toml::{KeyReader, SourcePlace, TomlEntry, TomlKind, list, text};

use super::items::{DescribedItem, FileExpression, ItemKind, ItemLink, LinkKind};
use super::names::{SymbolKind, number};
use super::reader::MechanismReader;
use crate::kane::graph::{Graph, Place};
use crate::kane::mechanism::{Coordinate, InputSpec, Speed};
use crate::kane::text::{Dependence, Dimension, Measured};

pub(super) const ORIGIN: [&str; 3] = ["origin", "origin y", "origin z"];
pub(super) const AT: [&str; 3] = ["at", "at y", "at z"];

impl MechanismReader {
    pub(super) fn declare(&mut self, root: &mut KeyReader<'_>) {
        self.declare_input(root);
        self.declare_parameters(root);
        self.declare_coordinates(root);
        self.declare_rates(root);
        for entry in root.table(&mut self.report, "definitions") {
            let kind = SymbolKind::Definition(self.names.definitions.len());
            if self.is_name(entry) && self.symbol(entry, kind) {
                let index = self.names.definitions.len();
                self.names.definitions.push(None);
                let value = self.written(&entry.name, &entry.node);
                self.item(ItemKind::Definition(index), entry, [("value", value)], Vec::new());
            }
        }
        self.declare_frames(root);
        self.declare_points(root);
        self.declare_laws(root);
        self.declare_constraints(root);
        self.presets(root);
    }

    /// Declares a name that expressions can use; returns `false` if it is taken.
    pub(super) fn symbol(&mut self, entry: &TomlEntry, kind: SymbolKind) -> bool {
        if let Some((_, first)) = self.names.symbols.get(&entry.name).copied() {
            self.twice(entry, first);
            return false;
        }
        self.names.symbols.insert(entry.name.clone(), (kind, entry.place));
        true
    }

    pub(super) fn item<const N: usize>(
        &mut self,
        kind: ItemKind,
        entry: &TomlEntry,
        fields: [(&'static str, Option<FileExpression>); N],
        links: Vec<ItemLink>,
    ) {
        let fields = fields.into_iter().filter_map(|(name, field)| Some((name, field?))).collect();
        let (name, place) = (entry.name.clone(), entry.place);
        self.items.push(DescribedItem { kind, name, place, fields, links });
    }

    fn declare_input(&mut self, root: &mut KeyReader<'_>) {
        let Some(entry) = root.take("input") else { return };
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        let named = keys.take("name").filter(|it| it.node.text().is_some());
        let name = keys.text(&mut self.report, "name").map_or("s", |(name, _)| name);
        let (unit, dimension) =
            self.unit(&mut keys, "unit").unwrap_or(("m".to_owned(), Dimension::LENGTH));
        let per_metre = self.field(&mut keys, "per_metre");
        keys.finish(&mut self.report);
        let place = named.map_or(entry.place, |it| it.node.place);
        let symbol = TomlEntry { name: name.to_owned(), place, node: entry.node.clone() };
        if self.is_name(&symbol) {
            self.symbol(&symbol, SymbolKind::Input);
        }
        self.names.input = dimension;
        self.mechanism.input = InputSpec { name: name.to_owned(), unit, ..InputSpec::default() };
        let fields = [("per_metre", per_metre)];
        self.item(ItemKind::Input, entry, fields, Vec::new());
    }

    fn declare_coordinates(&mut self, root: &mut KeyReader<'_>) {
        let has_rate: Vec<&str> = match root.take("rates").and_then(|it| it.node.entries()) {
            Some(entries) => entries.iter().map(|it| it.name.as_str()).collect(),
            None => Vec::new(),
        };
        for entry in root.table(&mut self.report, "coordinates") {
            if !self.is_name(entry) {
                continue;
            }
            let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { continue };
            let (unit, dimension) = self.needed_unit(&mut keys, &entry.name);
            let range = self.range(&mut keys, "range", &entry.name, dimension);
            let has_rate = has_rate.contains(&entry.name.as_str());
            let speed_range = if has_rate {
                self.refuse_speed_range(&mut keys, &entry.name);
                None
            } else {
                let rate = dimension.over(Dimension::TIME);
                self.range(&mut keys, "speed_range", &entry.name, rate)
            };
            keys.finish(&mut self.report);
            if !self.symbol(entry, SymbolKind::Coordinate(self.names.coordinates.len())) {
                continue;
            }
            if self.names.vague.contains(&entry.name) {
                self.names.vague.insert(format!("{}'", entry.name));
            }
            let rate = (!has_rate).then(|| {
                let (name, unit) = (format!("{}'", entry.name), rate_unit(&unit));
                self.enter_speed(name, unit, dimension.over(Dimension::TIME), speed_range)
            });
            self.names.coordinates.push(dimension);
            self.names.rates.push(rate);
            let zero = self.graph.constant(0.0);
            self.mechanism.coordinates.push(Coordinate {
                name: entry.name.clone(),
                unit,
                range: range.unwrap_or((-1.0, 1.0)),
                rate: rate.map_or(zero, |it| it.node),
            });
        }
        for entry in root.table(&mut self.report, "speeds") {
            if self.is_name(entry) {
                self.declare_speed(entry);
            }
        }
    }

    fn refuse_speed_range(&mut self, keys: &mut KeyReader<'_>, name: &str) {
        let Some(key) = keys.take("speed_range") else { return };
        let message = format!("{} has no speed of its own", quoted(name));
        let help = "its rate is stated in [rates]: give the range of the speed in [speeds]";
        self.report.say(key.place, message, help);
    }

    fn declare_speed(&mut self, entry: &TomlEntry) {
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        let (unit, dimension) = self.needed_unit(&mut keys, &entry.name);
        let range = self.range(&mut keys, "range", &entry.name, dimension);
        keys.finish(&mut self.report);
        if self.symbol(entry, SymbolKind::Speed(self.names.speeds.len())) {
            self.enter_speed(entry.name.clone(), unit, dimension, range);
        }
    }

    fn needed_unit(&mut self, keys: &mut KeyReader<'_>, name: &str) -> (String, Dimension) {
        if keys.take("unit").is_none() {
            let message = format!("{} has no unit", quoted(name));
            self.report.miss(keys.place, message, "write unit = \"m\", \"rad\" or \"m/s\"");
        }
        let unit = self.unit(keys, "unit");
        self.or_vague(name, unit)
    }

    fn enter_speed(
        &mut self,
        name: String,
        unit: String,
        dimension: Dimension,
        range: Option<(f64, f64)>,
    ) -> Measured {
        let node = self.graph.symbol(Place::Speed(number(self.names.speeds.len())));
        self.names.speeds.push(dimension);
        let range = range.unwrap_or((-1.0, 1.0));
        self.mechanism.speeds.push(Speed { name, unit, range });
        Measured { node, dimension, reach: Dependence::SPEEDS }
    }

    fn declare_rates(&mut self, root: &mut KeyReader<'_>) {
        for entry in root.table(&mut self.report, "rates") {
            let Some((SymbolKind::Coordinate(index), _)) = self.names.symbols.get(&entry.name)
            else {
                let known = self.mechanism.coordinates.iter().map(|it| it.name.as_str());
                let help = documents::choice(&entry.name, known);
                let message = format!("there is no coordinate {}", quoted(&entry.name));
                self.report.say(entry.place, message, help);
                continue;
            };
            let kind = ItemKind::Rate(*index);
            let value = self.written(&entry.name, &entry.node);
            self.item(kind, entry, [("value", value)], Vec::new());
        }
    }

    pub(super) fn link(
        &mut self,
        keys: &mut KeyReader<'_>,
        kind: LinkKind,
        name: &'static str,
    ) -> Option<ItemLink> {
        let (to, place) = keys.text(&mut self.report, name)?;
        Some(ItemLink { kind, name: to.to_owned(), place })
    }

    pub(super) fn triple(
        &mut self,
        keys: &mut KeyReader<'_>,
        name: &'static str,
    ) -> [Option<FileExpression>; 3] {
        let Some(entry) = keys.take(name) else { return [None, None, None] };
        let items = list(&mut self.report, name, &entry.node);
        if items.len() > 3 {
            let message = format!("{} has {} values", quoted(name), items.len());
            self.report.say(entry.place, message, "give x, y and z, or fewer");
        }
        let mut all = [None, None, None];
        for (slot, item) in all.iter_mut().zip(items) {
            *slot = self.written(name, item);
        }
        all
    }

    pub(super) fn name_list(
        &mut self,
        keys: &mut KeyReader<'_>,
        name: &'static str,
    ) -> Option<Vec<(String, SourcePlace)>> {
        let entry = keys.take(name)?;
        if let TomlKind::Text(one, _) = &entry.node.kind {
            return Some(vec![(one.clone(), entry.node.place)]);
        }
        let mut names = Vec::new();
        for item in list(&mut self.report, name, &entry.node) {
            if let Some((name, place)) = text(&mut self.report, name, item) {
                names.push((name.to_owned(), place));
            }
        }
        Some(names)
    }
}

/// Appends `/s` to a unit: `rad/s` of `rad`.
fn rate_unit(unit: &str) -> String {
    match unit.split_once('/') {
        None => format!("{unit}/s"),
        Some((above, "s")) => format!("{above}/s²"),
        Some((above, below)) => format!("{above}/({below}·s)"),
    }
}

pub(super) fn zero(graph: &mut Graph) -> Measured {
    let node = graph.constant(0.0);
    Measured { node, dimension: Dimension::NONE, reach: Dependence::NOTHING }
}
