//! Relation of an instrument to the one that it was made from.

use std::collections::BTreeMap;

use keyboard::{Difference, KEYS};

/// Differences of one parameter, key by key.
pub type CompassDifferences = [Option<Difference>; KEYS];

/// Differences of an instrument from its base, by parameter.
pub type InstrumentEdit = BTreeMap<String, CompassDifferences>;

/// Relation of a saved instrument to its base.
#[derive(Clone, Debug)]
pub struct Based {
    /// Name or path of the base.
    pub base: String,
    /// `true` if the base has had other values when the file was written.
    pub has_changed: bool,
    pub edit: InstrumentEdit,
    pub(super) values: Vec<CompassValues>,
    pub(super) present: Vec<CompassValues>,
}

pub(super) type CompassValues = [f64; KEYS];
