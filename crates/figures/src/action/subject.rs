use instruments::LoadedModel;

use super::drive::USUAL_DIP;
use super::key::{DrivenKey, Opener};

/// Travels of a key that can be measured (m): a longer one would take hours.
const DIPS: std::ops::RangeInclusive<f64> = 1e-3..=0.1;

/// An instrument with its expected figures.
#[derive(Clone, Copy)]
pub struct PianoSubject<'a> {
    pub name: &'a str,
    pub model: &'a LoadedModel,
    /// Returns one value per parameter of the model for a key, 0 (A0) ..= 87 (C8).
    pub values: &'a (dyn Fn(u8) -> Vec<f64> + Sync),
    pub expected: &'a [(String, (f64, f64))],
}

impl std::fmt::Debug for PianoSubject<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PianoSubject").field("name", &self.name).finish_non_exhaustive()
    }
}

impl PianoSubject<'_> {
    pub(super) fn open(&self, key: u8) -> Box<dyn DrivenKey> {
        let values = (self.values)(key);
        self.model.visit(Opener { values: &values })
    }

    pub(super) fn parameter(&self, name: &str, key: u8) -> Option<f64> {
        let place = self.model.parameters.iter().position(|it| it.name == name)?;
        (self.values)(key).get(place).copied()
    }

    /// Returns the travel of a key's front to its bed (m): the parameter `dip`, or a grand's.
    pub(super) fn dip(&self, key: u8) -> f64 {
        let dip = self.parameter("dip", key);
        dip.filter(|it| DIPS.contains(it)).unwrap_or(USUAL_DIP)
    }
}
