//! `fidelity`: computed fraction of an instrument's action, set by a scene or chosen at start.
//!
//! An instrument's file names others that render the same action with less work.

use keyboard::KeyRange;

use super::embedded::INSTRUMENTS;
use super::quantity::Quantity;
use super::read::TableReader;
use super::source::{SourceError, SourceText};
use super::voicing::Voicing;
use documents::toml::{FindingList, SourcePlace};

/// Share of each lane's time.
const BUDGET: Quantity = Quantity { unit: "1", range: (1e-3, 1.0) };
const DEFAULT_BUDGET: f64 = 0.5;

/// Computed fraction of an action, the largest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Fidelity {
    Full,
    Reduced,
    /// Key and hammer on two springs: the paper's model B.
    Springs,
    /// Force for each depth of the key.
    Map,
}

impl Fidelity {
    const ALL: [Self; 4] = [Self::Full, Self::Reduced, Self::Springs, Self::Map];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Reduced => "reduced",
            Self::Springs => "springs",
            Self::Map => "map",
        }
    }
}

/// Instrument at one fidelity, with its voicing.
#[derive(Clone, Debug)]
pub struct FidelityLevel {
    pub fidelity: Fidelity,
    pub instrument: String,
    pub voicing: Voicing,
}

/// Keys with a fidelity that is chosen when a run begins; until then they have the first level.
#[derive(Clone, Debug)]
pub struct AutoFidelity {
    pub keys: KeyRange,
    /// All levels, the most faithful first; never empty.
    pub levels: Vec<FidelityLevel>,
}

/// Choice of fidelity that a scene leaves to the host.
#[derive(Clone, Debug)]
pub struct FidelityChoice {
    /// Key ranges whose fidelity is chosen when a run begins.
    pub ranges: Vec<AutoFidelity>,
    /// Share of each lane's time that all keys may take when they move at once.
    pub budget: f64,
}

/// What a scene says of a range's fidelity.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum WantedFidelity {
    Level(Fidelity),
    Auto,
}

/// Reads the share of each lane's time that all keys together may use in simultaneous motion.
pub(super) fn read_budget(report: &mut FindingList, scene: &mut TableReader<'_>) -> f64 {
    scene.number(report, "budget", BUDGET).unwrap_or(DEFAULT_BUDGET)
}

pub(super) fn read_levels(
    report: &mut FindingList,
    instrument: &mut TableReader<'_>,
) -> Vec<(Fidelity, String)> {
    let Some(mut reader) = instrument.table(report, "fidelity") else { return Vec::new() };
    let mut levels = Vec::new();
    for fidelity in Fidelity::ALL.into_iter().skip(1) {
        let Some((name, place)) = reader.text(report, fidelity.name()) else { continue };
        levels.extend(known_instrument(report, place, &name).map(|known| (fidelity, known)));
    }
    reader.finish(report);
    levels
}

/// Returns the name of an embedded instrument, or the path of an existing file.
pub(super) fn known_instrument(
    report: &mut FindingList,
    place: SourcePlace,
    name: &str,
) -> Option<String> {
    if INSTRUMENTS.find(name).is_some() {
        return Some(name.to_owned());
    }
    let folder = report.folder(place).to_owned();
    if let Err(SourceError::Unknown((message, help))) =
        SourceText::find(&INSTRUMENTS, name, &folder)
    {
        report.say(place, message, help);
        return None;
    }
    let path = folder.join(name);
    Some(std::path::absolute(&path).unwrap_or(path).to_string_lossy().into_owned())
}

pub(super) fn read_wanted(report: &mut FindingList, range: &mut TableReader<'_>) -> WantedFidelity {
    let named = Fidelity::ALL.map(|it| (it.name(), WantedFidelity::Level(it)));
    let all: Vec<_> = named.into_iter().chain([("auto", WantedFidelity::Auto)]).collect();
    let wanted = range.choice(report, "fidelity", "there is no fidelity", &all);
    wanted.unwrap_or(WantedFidelity::Level(Fidelity::Full))
}
