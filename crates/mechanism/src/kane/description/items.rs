//! Unresolved contents of a description: names, places and expressions.

use documents::toml::SourcePlace;

use crate::kane::graph::Node;
use crate::kane::mechanism::ConstraintKind;
use crate::kane::text::{Dimension, ParsedExpression};

#[derive(Clone, PartialEq, Debug)]
pub(super) struct FileExpression {
    pub(super) place: SourcePlace,
    pub(super) origin: TextOrigin,
    pub(super) expression: ParsedExpression,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct TextOrigin {
    pub(super) place: SourcePlace,
    /// `true` if its bytes are those of the file from there on.
    pub(super) is_exact: bool,
}

impl TextOrigin {
    pub(super) fn at(&self, offset: usize) -> SourcePlace {
        if self.is_exact { self.place.after(offset) } else { self.place }
    }
}

/// Named item with expressions, which others can use.
#[derive(Clone, Debug)]
pub(super) struct DescribedItem {
    pub(super) kind: ItemKind,
    pub(super) name: String,
    pub(super) place: SourcePlace,
    pub(super) fields: Vec<(&'static str, FileExpression)>,
    pub(super) links: Vec<ItemLink>,
}

/// Kind of an item, with its number among its kind.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ItemKind {
    Input,
    Rate(usize),
    Definition(usize),
    /// Frame, and the axis of its rotation.
    Frame(usize, usize),
    Point(usize),
    Law(usize, LawKind),
    Constraint(usize, ConstraintKind),
}

/// Kind of a law, with its number among forces or among contacts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LawKind {
    Spring(usize),
    Felt(usize),
    Force(usize),
    Contact(usize),
    Bearing(usize),
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct ItemLink {
    pub(super) kind: LinkKind,
    pub(super) name: String,
    pub(super) place: SourcePlace,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LinkKind {
    Frame,
    Point,
}

impl DescribedItem {
    pub(super) fn field(&self, name: &str) -> Option<&FileExpression> {
        self.fields.iter().find(|(known, _)| *known == name).map(|(_, field)| field)
    }
}

#[derive(Clone, Debug)]
pub(super) struct FrictionText {
    pub(super) contact: usize,
    pub(super) name: String,
    pub(super) slip: Option<FileExpression>,
    pub(super) stiction: Option<FileExpression>,
    pub(super) kinetic: Option<FileExpression>,
    pub(super) scales: (f64, f64),
}

#[derive(Clone, Debug)]
pub(super) struct ParameterText {
    pub(super) value: Option<FileExpression>,
    pub(super) place: SourcePlace,
    pub(super) dimension: Dimension,
}

/// Values that are checked once the presets are read.
#[derive(Debug, Default)]
pub(super) struct PlausibleValues {
    pub(super) limits: Vec<LawLimit>,
    pub(super) impacts: Vec<GuardedImpact>,
}

#[derive(Clone, Debug)]
pub(super) struct LawLimit {
    pub(super) name: String,
    pub(super) value: Node,
    pub(super) highest: f64,
    pub(super) place: SourcePlace,
}

/// An impact, with the guard that leads to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct GuardedImpact {
    pub(super) mode: usize,
    pub(super) guard: Node,
    pub(super) rate: Node,
    pub(super) scale: f64,
    pub(super) separation: Node,
    pub(super) place: SourcePlace,
}
