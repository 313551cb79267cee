//! The instrument that is looked at.

use instruments::LoadedModel;

use super::drive::USUAL_DIP;
use super::key::{DrivenKey, Opener};

/// An instrument, and what is expected of it.
#[derive(Clone, Copy)]
pub struct PianoSubject<'a> {
    /// Name of the instrument, for reports.
    pub name: &'a str,
    /// The model that every key has.
    pub model: &'a LoadedModel,
    /// One value per parameter of the model for a key, 0 (A0) ..= 87 (C8).
    pub values: &'a (dyn Fn(u8) -> Vec<f64> + Sync),
    /// Figures by name, with the lowest and highest value that each should have.
    pub expected: &'a [(String, (f64, f64))],
}

impl std::fmt::Debug for PianoSubject<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PianoSubject").field("name", &self.name).finish_non_exhaustive()
    }
}

impl PianoSubject<'_> {
    /// A key at rest.
    pub(super) fn open(&self, key: u8) -> Box<dyn DrivenKey> {
        let values = (self.values)(key);
        self.model.visit(Opener { values: &values })
    }

    /// The value of the parameter called `name` on a key, if there is one.
    pub(super) fn parameter(&self, name: &str, key: u8) -> Option<f64> {
        let place = self.model.parameters.iter().position(|it| it.name == name)?;
        (self.values)(key).get(place).copied()
    }

    /// Travel of a key's front to its bed (m): the parameter `dip`, or a grand's.
    pub(super) fn dip(&self, key: u8) -> f64 {
        self.parameter("dip", key).unwrap_or(USUAL_DIP)
    }
}
