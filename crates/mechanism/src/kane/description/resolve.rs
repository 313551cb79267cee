#![expect(
    clippy::wildcard_enum_match_arm,
    reason = "TOML has many kinds of values, and each place takes few of them"
)]

use documents::quoted;

use super::items::{DescribedItem, FileExpression, ItemKind, LinkKind};
use super::linear::is_linear_in_speeds;
use super::names::SymbolKind;
use super::order::sorted;
use super::reader::{CONSTANT, MechanismReader, POSE, RESULT, STATE};
use crate::kane::mechanism::{Constraint, ConstraintKind};
use crate::kane::text::{Dimension, Measured, PartShape};

struct ItemIndex {
    rates: Vec<usize>,
    definitions: Vec<usize>,
    frames: Vec<usize>,
    points: Vec<usize>,
    laws: Vec<usize>,
    constraints: Vec<usize>,
}

impl ItemIndex {
    fn new(items: &[DescribedItem]) -> Self {
        let of = |wanted: fn(ItemKind) -> bool| {
            let all = items.iter().enumerate().filter(|(_, item)| wanted(item.kind));
            all.map(|(index, _)| index).collect()
        };
        Self {
            rates: of(|it| matches!(it, ItemKind::Rate(_))),
            definitions: of(|it| matches!(it, ItemKind::Definition(_))),
            frames: of(|it| matches!(it, ItemKind::Frame(..))),
            points: of(|it| matches!(it, ItemKind::Point(_))),
            laws: of(|it| matches!(it, ItemKind::Law(..))),
            constraints: of(|it| matches!(it, ItemKind::Constraint(..))),
        }
    }
}

impl MechanismReader {
    pub(super) fn resolve(&mut self) {
        let index = ItemIndex::new(&self.items);
        let needs: Vec<_> = self.items.iter().map(|item| self.needs(item, &index)).collect();
        let found = sorted(&needs);
        for circle in &found.circles {
            self.say_items_circle(circle);
        }
        let in_circles: Vec<usize> = found.circles.into_iter().flatten().collect();
        self.mechanism.forces.clear();
        for at in found.order.into_iter().filter(|it| !in_circles.contains(it)) {
            if let Some(item) = self.items.get(at).cloned() {
                self.build_item(&item);
            }
        }
        self.build_frictions();
        self.collect_built();
    }

    fn say_items_circle(&mut self, circle: &[usize]) {
        let name = |index: &usize| self.items.get(*index).map_or("", |it| &it.name);
        let path: Vec<_> = circle.iter().chain(circle.first()).map(name).collect();
        let place = circle.first().and_then(|it| self.items.get(*it)).map(|it| it.place);
        let message = format!("these are made of each other: {}", path.join(" → "));
        self.report.say(place.unwrap_or_default(), message, "take one of them out of another");
    }

    fn needs(&self, item: &DescribedItem, index: &ItemIndex) -> Vec<usize> {
        let mut needs = Vec::new();
        if matches!(item.kind, ItemKind::Law(..) | ItemKind::Constraint(..)) {
            needs.extend(&index.rates);
        }
        for link in &item.links {
            needs.extend(self.linked(link.kind, &link.name, index));
        }
        let fields = item.fields.iter().map(|(_, field)| field);
        for field in fields.chain(self.slip_text(item.kind)) {
            for part in &field.expression.parts {
                self.part_needs(&part.shape, index, &mut needs);
            }
        }
        needs.sort_unstable();
        needs.dedup();
        needs
    }

    fn linked(&self, kind: LinkKind, name: &str, index: &ItemIndex) -> Option<usize> {
        match kind {
            LinkKind::Frame => {
                let frame = self.names.frames.index(name)?.checked_sub(1)?;
                index.frames.get(frame).copied()
            }
            LinkKind::Point => index.points.get(self.names.points.index(name)?).copied(),
        }
    }

    fn part_needs(&self, shape: &PartShape, index: &ItemIndex, needs: &mut Vec<usize>) {
        match shape {
            PartShape::Name { name, primes } => {
                let symbol = self.names.symbols.get(name).map(|(kind, _)| *kind);
                if let Some(SymbolKind::Definition(at)) = symbol {
                    needs.extend(index.definitions.get(at));
                }
                if *primes > 0 && symbol != Some(SymbolKind::Input) {
                    needs.extend(&index.rates);
                }
            }
            PartShape::Call { function, .. } if function == "rate" => needs.extend(&index.rates),
            PartShape::Named { function, names } => {
                for (name, _) in names {
                    needs.extend(self.named_need(function, name, index));
                }
            }
            _ => {}
        }
    }

    fn named_need(&self, function: &str, name: &str, index: &ItemIndex) -> Option<usize> {
        let (list, at) = match function {
            "force" | "friction" => (&index.laws, self.names.laws.index(name)?),
            "reaction" => (&index.constraints, self.names.constraints.index(name)?),
            _ => (&index.points, self.names.points.index(name)?),
        };
        list.get(at).copied()
    }

    fn build_item(&mut self, item: &DescribedItem) {
        match item.kind {
            ItemKind::Input => self.build_input(item),
            ItemKind::Rate(index) => self.build_rate(item, index),
            ItemKind::Definition(index) => {
                let value = item.field("value").and_then(|it| self.value(it, RESULT));
                if let Some(slot) = self.names.definitions.get_mut(index) {
                    *slot = value;
                }
            }
            ItemKind::Frame(index, axis) => self.build_frame(item, index, axis),
            ItemKind::Point(index) => self.build_point(item, index),
            ItemKind::Law(index, kind) => self.build_law(item, index, kind),
            ItemKind::Constraint(index, kind) => self.build_constraint(item, index, kind),
        }
    }

    fn build_input(&mut self, item: &DescribedItem) {
        let dimension = self.names.input.over(Dimension::LENGTH);
        let Some(file) = item.field("per_metre") else { return };
        self.mechanism.input.per_metre = self.node("per_metre", file, CONSTANT, dimension);
    }

    fn build_rate(&mut self, item: &DescribedItem, index: usize) {
        let Some(file) = item.field("value") else { return };
        let Some(value) = self.value(file, STATE) else { return };
        let of = self.names.coordinates.get(index).copied().unwrap_or_default();
        if !self.fits(&item.name, file, value, of.over(Dimension::TIME)) {
            return;
        }
        if let Some(slot) = self.names.rates.get_mut(index) {
            *slot = Some(value);
        }
        if let Some(coordinate) = self.mechanism.coordinates.get_mut(index) {
            coordinate.rate = value.node;
        }
    }

    fn build_constraint(&mut self, item: &DescribedItem, index: usize, kind: ConstraintKind) {
        let Some(file) = item.field("zero") else { return };
        let is_holonomic = kind == ConstraintKind::Holonomic;
        let Some(zero) = self.value(file, if is_holonomic { POSE } else { STATE }) else { return };
        let rate = if is_holonomic { self.rate_of(file, zero) } else { Some(zero) };
        let Some(rate) = rate else { return };
        if !is_holonomic && !is_linear_in_speeds(&self.graph, zero.node) {
            let message = format!("{} is not linear in the speeds", quoted(&item.name));
            let help = "write it as a sum of speeds, each times a value without speeds";
            self.report.say(file.place, message, help);
            return;
        }
        // Power is reaction times rate.
        self.names.constraints.set(index, Dimension::POWER.over(rate.dimension));
        self.watch(file, zero, None);
        let name = item.name.clone();
        self.built
            .constraints
            .push((index, Constraint { name, kind, zero: zero.node, rate: rate.node }));
    }

    pub(super) fn rate_of(&mut self, file: &FileExpression, value: Measured) -> Option<Measured> {
        match self.names.total_rate(&mut self.graph, value) {
            Ok(rate) => {
                self.weigh(file.place);
                Some(rate)
            }
            Err(error) => {
                self.report.say(file.place, error.message, error.help);
                None
            }
        }
    }

    fn collect_built(&mut self) {
        self.built.constraints.sort_by_key(|(index, _)| *index);
        self.mechanism.constraints =
            self.built.constraints.iter().map(|(_, it)| it.clone()).collect();
        self.built.forces.sort_by_key(|(index, _)| *index);
        self.mechanism.forces = self.built.forces.iter().map(|(_, it)| it.clone()).collect();
        self.built.contacts.sort_by_key(|(index, _)| *index);
        self.mechanism.contacts = self.built.contacts.iter().map(|(_, it)| it.clone()).collect();
    }
}
