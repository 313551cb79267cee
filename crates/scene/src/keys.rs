use std::sync::Arc;

use instruments::{LoadedModel, ModelEntry};
use keyboard::{KEYS, KeyRange, RangeError};

use super::embedded::INSTRUMENTS;
use super::fidelity::{AutoFidelity, Fidelity, FidelityLevel, WantedFidelity, read_wanted};
use super::instrument::{Instrument, known_as};
use super::kind::describes_model;
use super::needs::{LoopSettings, Unmet};
use super::read::{self, TableReader};
use super::source::{SourceError, SourceText};
use super::voicing::{InstrumentFile, Voicing};
use documents::quoted;
use documents::toml::{FindingList, SourcePlace, TomlKind, TomlNode};
use mechanism::Library;

/// Model with its values for one key.
#[derive(Clone, Debug)]
pub struct KeyVoice {
    pub model: Arc<LoadedModel>,
    /// One value per parameter of the model, in its unit.
    pub values: Vec<f64>,
    /// File of the instrument, if it is no part of the program.
    pub file: Option<Arc<InstrumentFile>>,
}

impl KeyVoice {
    pub fn new(voicing: &Voicing, key: u8) -> Self {
        let (model, file) = (Arc::clone(&voicing.model), voicing.file.clone());
        Self { model, values: voicing.values(key), file }
    }
}

pub(super) struct ReadKeys {
    pub(super) voicings: Vec<Option<Voicing>>,
    pub(super) ranges: Vec<KeyRange>,
    pub(super) auto: Vec<AutoFidelity>,
}

#[derive(Clone, Copy)]
pub(super) struct KeyReading<'a> {
    pub(super) library: &'a Library,
    pub(super) in_loop: Option<LoopSettings<'a>>,
}

/// Reads the key ranges. Rejects instruments that are not stable `in_loop`, if there is one, and
/// values that contradict each other.
pub(super) fn read(
    report: &mut FindingList,
    reader: &mut TableReader<'_>,
    reading: KeyReading<'_>,
) -> ReadKeys {
    let mut read = ReadKeys { voicings: vec![None; KEYS], ranges: Vec::new(), auto: Vec::new() };
    let Some(entry) = reader.take("keys") else {
        let help = "add [[keys]] with a range and an instrument";
        report.miss(reader.place, "the scene has no keys", help);
        return read;
    };
    let TomlKind::List(ranges) = &entry.node.kind else {
        read::wrong_kind(report, "keys", &entry.node, "a list", "write it as [[keys]]");
        return read;
    };
    if ranges.is_empty() {
        let help = "add [[keys]] with a range and an instrument";
        report.miss(entry.place, "the scene has no keys", help);
    }
    let mut taken = Vec::new();
    let mut models: Vec<Arc<LoadedModel>> = Vec::new();
    for node in ranges {
        let found = read_range(report, node, &mut taken, reading);
        let Some((range, RangeVoicing { voicing, levels })) = found else { continue };
        refuse_namesake(report, node.place, &voicing.model, &models);
        models.push(Arc::clone(&voicing.model));
        if reading.in_loop.is_some() {
            voicing.refuse_unmet(report, node.place, range);
        }
        for key in range.numbers() {
            read.voicings[usize::from(key)] = Some(voicing.clone());
        }
        read.ranges.push(range);
        read.auto.extend(levels.map(|levels| AutoFidelity { keys: range, levels }));
    }
    read
}

/// Reports a model at `place` with the name of another one of the scene.
fn refuse_namesake(
    report: &mut FindingList,
    place: SourcePlace,
    model: &ModelEntry,
    others: &[Arc<LoadedModel>],
) {
    if others.iter().any(|other| other.name == model.name && !other.is(model)) {
        let message = format!("two models of the scene are called {}", quoted(model.name));
        report.say(place, message, "give the description of one of them another name");
    }
}

struct RangeVoicing {
    voicing: Voicing,
    levels: Option<Vec<FidelityLevel>>,
}

impl From<Voicing> for RangeVoicing {
    fn from(voicing: Voicing) -> Self {
        Self { voicing, levels: None }
    }
}

type ReadRange = (KeyRange, SourcePlace);

/// Reads one `[[keys]]` table to its end, even if an entry is invalid.
fn read_range(
    report: &mut FindingList,
    node: &TomlNode,
    taken: &mut Vec<ReadRange>,
    reading: KeyReading<'_>,
) -> Option<(KeyRange, RangeVoicing)> {
    let mut reader = TableReader::new(report, "[keys]", node)?;
    let range = read_bounds(report, &mut reader);
    if let Some(range) = range {
        refuse_overlap(report, range, taken);
        taken.push(range);
    }
    let voicing = read_voicing(report, &mut reader, reading);
    let voicing = if let Some(mut voicing) = voicing {
        if voicing.levels.is_some() {
            refuse_parameters(report, &mut reader);
        } else {
            voicing.voicing.read_parameters(report, &mut reader);
        }
        Some(voicing)
    } else {
        reader.take("parameters");
        None
    };
    reader.finish(report);
    Some((range?.0, voicing?))
}

fn read_bounds(report: &mut FindingList, reader: &mut TableReader<'_>) -> Option<ReadRange> {
    let Some(entry) = reader.take("range") else {
        report.miss(reader.place, "these keys have no range", "add range = \"A0..C8\"");
        return None;
    };
    let place = entry.node.place;
    let text = if let TomlKind::Integer(number) = entry.node.kind {
        number.to_string()
    } else {
        read::text(report, "range", &entry.node)?
    };
    match KeyRange::parse(&text) {
        Ok(range) => Some((range, place)),
        Err(refusal) => {
            refuse_range(report, place, refusal);
            None
        }
    }
}

fn refuse_range(report: &mut FindingList, place: SourcePlace, refusal: RangeError<'_>) {
    let (message, help) = match refusal {
        RangeError::NotANote(note) => (
            format!("{} in the range is no note", quoted(note)),
            "write notes from A0 to C8 or MIDI numbers from 21 to 108, as \"A0..C8\"",
        ),
        RangeError::OffKeyboard(note) => (
            format!("{} is not on the keyboard", quoted(note)),
            "stay within A0..C8, which is 21..108",
        ),
        RangeError::Backwards(text) => {
            (format!("the range {} runs backwards", quoted(text)), "put the lower note first")
        }
    };
    report.say(place, message, help);
}

fn refuse_overlap(report: &mut FindingList, (range, place): ReadRange, taken: &[ReadRange]) {
    for (other, other_place) in taken {
        if let Some(shared) = range.intersection(*other) {
            let first = report.line(*other_place);
            let message = format!("{shared} already belongs to the range of {first}");
            report.say(place, message, "let every key be in one range only");
        }
    }
}

fn refuse_parameters(report: &mut FindingList, reader: &mut TableReader<'_>) {
    if let Some(entry) = reader.take("parameters") {
        let message = "parameters stand beside fidelity \"auto\", which chooses their model";
        report.say(entry.place, message, "name the fidelity to which they belong");
    }
}

fn read_voicing(
    report: &mut FindingList,
    reader: &mut TableReader<'_>,
    reading: KeyReading<'_>,
) -> Option<RangeVoicing> {
    let model = reader.take("model");
    let preset = reader.take("preset");
    let Some(entry) = reader.take("instrument") else {
        if model.is_none() {
            let help = "add instrument = \"grand-springs\", or a model and a preset";
            report.miss(reader.place, "these keys have no instrument", help);
        }
        let voicing = Voicing::read(report, reader, reading.library)?;
        let named = preset.map(|_entry| voicing.preset());
        if let (Some(entry), Some(known)) = (model, known_as(&voicing.model, named)) {
            refuse_unstable(report, entry.node.place, &known, reading);
        }
        if let Some(entry) = reader.take("fidelity") {
            let message = "\"fidelity\" stands beside a model, which is one fidelity";
            report.say(entry.place, message, "leave it out, or name an instrument");
        }
        return Some(voicing.into());
    };
    for extra in [model, preset].into_iter().flatten() {
        let message =
            format!("{} stands beside an instrument, which has its own", quoted(&extra.name));
        report.say(extra.place, message, "keep one of the two");
    }
    let name = read::text(report, "instrument", &entry.node)?;
    let place = entry.node.place;
    let wanted = read_wanted(report, reader);
    let instrument = read_instrument(report, place, &name, reading.library)?;
    match wanted {
        WantedFidelity::Level(Fidelity::Full) => {
            refuse_unstable(report, place, &instrument, reading);
            Some(instrument.voicing.into())
        }
        WantedFidelity::Level(fidelity) => {
            let level = read_level(report, place, &instrument, fidelity, reading.library)?;
            refuse_unstable(report, place, &level, reading);
            Some(level.voicing.into())
        }
        WantedFidelity::Auto => auto(report, place, &instrument, reading),
    }
}

fn read_instrument(
    report: &mut FindingList,
    place: SourcePlace,
    name: &str,
    library: &Library,
) -> Option<Instrument> {
    let found = match SourceText::find(&INSTRUMENTS, name, report.folder(place)) {
        Ok(source) if describes_model(&source) => {
            let message =
                format!("{} is the description of a model, not an instrument", quoted(name));
            report.say(place, message, format!("write model = {} instead", quoted(name)));
            return None;
        }
        Ok(source) => Instrument::check(library, &source),
        Err(SourceError::Unreadable(diagnostics)) => Err(diagnostics),
        Err(SourceError::Unknown((message, help))) => {
            report.say(place, message, help);
            return None;
        }
    };
    found.map_err(|diagnostics| report.absorb(diagnostics)).ok()
}

/// Reads the instrument that renders `instrument` at a lower `fidelity`.
fn read_level(
    report: &mut FindingList,
    place: SourcePlace,
    instrument: &Instrument,
    fidelity: Fidelity,
    library: &Library,
) -> Option<Instrument> {
    let found = instrument.levels.iter().find(|(known, _name)| *known == fidelity);
    let Some((_fidelity, name)) = found else {
        let known = instrument.levels.iter().map(|(known, _name)| known.name());
        let known = known.chain([Fidelity::Full.name()]);
        let refusal = format!("{} has no fidelity", instrument.name);
        read::unknown(report, place, &refusal, fidelity.name(), known);
        return None;
    };
    Instrument::load(library, name).map_err(|diagnostics| report.absorb(diagnostics)).ok()
}

/// Returns all levels of `instrument` that are stable `in_loop`, for a choice at start.
fn auto(
    report: &mut FindingList,
    place: SourcePlace,
    instrument: &Instrument,
    reading: KeyReading<'_>,
) -> Option<RangeVoicing> {
    let mut levels = Vec::new();
    let lower = instrument.levels.iter().map(|(fidelity, _name)| *fidelity);
    for fidelity in std::iter::once(Fidelity::Full).chain(lower) {
        let level = if fidelity == Fidelity::Full {
            instrument.clone()
        } else {
            read_level(report, place, instrument, fidelity, reading.library)?
        };
        if unmet(&level, reading).is_none() {
            let Instrument { name, voicing, .. } = level;
            levels.push(FidelityLevel { fidelity, instrument: name, voicing });
        }
    }
    let Some(first) = levels.first() else {
        refuse_unstable(report, place, instrument, reading);
        return None;
    };
    Some(RangeVoicing { voicing: first.voicing.clone(), levels: Some(levels) })
}

fn refuse_unstable(
    report: &mut FindingList,
    place: SourcePlace,
    instrument: &Instrument,
    reading: KeyReading<'_>,
) {
    if let Some(unmet) = unmet(instrument, reading) {
        report.say(place, unmet.lacks, unmet.help);
    }
}

/// Returns the unmet need of an instrument in the loop, if any.
fn unmet(instrument: &Instrument, reading: KeyReading<'_>) -> Option<Unmet> {
    let LoopSettings { tick_hz, render } = reading.in_loop?;
    instrument.needs.unmet(&instrument.name, tick_hz, render)
}
