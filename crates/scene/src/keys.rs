//! `[[keys]]`: the voices of key ranges.

use keyboard::{KEYS, KeyRange, RangeError};
use models::catalogue::ModelEntry;

use super::document::{DocumentNode, TomlValue};
use super::embedded::INSTRUMENTS;
use super::instrument::{Instrument, known_as};
use super::needs::LoopSettings;
use super::read::{self, TableReader};
use super::report::{Location, MistakeList};
use super::source::{SourceError, SourceText};
use super::voicing::Voicing;
use diagnostics::quoted;

/// A model with its values for one key.
#[derive(Clone, Debug)]
pub struct KeyVoice {
    pub model: &'static ModelEntry,
    /// One value per parameter of the model, in the unit of each.
    pub values: Vec<f64>,
}

impl KeyVoice {
    /// Returns the voice of `key` that `voicing` says.
    pub fn new(voicing: &Voicing, key: u8) -> Self {
        Self { model: voicing.model, values: voicing.values(key) }
    }
}

/// Reads the key ranges; one entry per key, none where it is silent.
///
/// Refuses instruments that are not stable `in_loop`, if there is one, and values that do not go
/// together.
pub(super) fn read(
    report: &mut MistakeList<'_>,
    reader: &mut TableReader<'_>,
    in_loop: Option<LoopSettings<'_>>,
) -> Vec<Option<Voicing>> {
    let mut voices = vec![None; KEYS];
    let Some(entry) = reader.take("keys") else {
        let help = "add [[keys]] with a range and an instrument";
        report.miss(reader.place, "the scene has no keys", help);
        return voices;
    };
    let TomlValue::List(ranges) = &entry.node.value else {
        read::wrong_type(report, "keys", &entry.node, "a list", "write it as [[keys]]");
        return voices;
    };
    if ranges.is_empty() {
        let help = "add [[keys]] with a range and an instrument";
        report.miss(entry.place, "the scene has no keys", help);
    }
    let mut taken = Vec::new();
    let mut models: Vec<&ModelEntry> = Vec::new();
    for node in ranges {
        let read = read_range(report, node, &mut taken, in_loop);
        let Some((range, voicing)) = read else { continue };
        refuse_namesake(report, node.place, voicing.model, &models);
        models.push(voicing.model);
        if in_loop.is_some() {
            voicing.refuse_unmet(report, node.place, range);
        }
        for key in range.numbers() {
            voices[usize::from(key)] = Some(voicing.clone());
        }
    }
    voices
}

/// Refuses a model at `place` that is called like another one of the scene.
fn refuse_namesake(
    report: &mut MistakeList<'_>,
    place: Location,
    model: &ModelEntry,
    others: &[&ModelEntry],
) {
    if others.iter().any(|other| other.name == model.name && !other.is(model)) {
        let message = format!("two models of the scene are called {}", quoted(model.name));
        report.say(place, message, "give the description of one of them another name");
    }
}

/// A range that was read, and where.
type ReadRange = (KeyRange, Location);

/// Reads one `[[keys]]` table; all of it, even if part of it is wrong.
fn read_range(
    report: &mut MistakeList<'_>,
    node: &DocumentNode,
    taken: &mut Vec<ReadRange>,
    in_loop: Option<LoopSettings<'_>>,
) -> Option<(KeyRange, Voicing)> {
    let mut reader = TableReader::new(report, "[keys]", node)?;
    let range = read_bounds(report, &mut reader);
    if let Some(range) = range {
        refuse_overlap(report, range, taken);
        taken.push(range);
    }
    let voicing = read_voicing(report, &mut reader, in_loop);
    let voicing = if let Some(mut voicing) = voicing {
        voicing.read_parameters(report, &mut reader);
        Some(voicing)
    } else {
        reader.take("parameters");
        None
    };
    reader.finish(report);
    Some((range?.0, voicing?))
}

fn read_bounds(report: &mut MistakeList<'_>, reader: &mut TableReader<'_>) -> Option<ReadRange> {
    let Some(entry) = reader.take("range") else {
        report.miss(reader.place, "these keys have no range", "add range = \"A0..C8\"");
        return None;
    };
    let place = entry.node.place;
    let text = if let TomlValue::Integer(number) = entry.node.value {
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

fn refuse_range(report: &mut MistakeList<'_>, place: Location, refusal: RangeError<'_>) {
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

fn refuse_overlap(report: &mut MistakeList<'_>, (range, place): ReadRange, taken: &[ReadRange]) {
    for (other, other_place) in taken {
        if let Some(shared) = range.intersection(*other) {
            let first = report.describe(*other_place);
            let message = format!("{shared} already belongs to the range of {first}");
            report.say(place, message, "let every key be in one range only");
        }
    }
}

/// Reads `instrument`, or `model` and `preset`.
fn read_voicing(
    report: &mut MistakeList<'_>,
    reader: &mut TableReader<'_>,
    in_loop: Option<LoopSettings<'_>>,
) -> Option<Voicing> {
    let model = reader.take("model");
    let preset = reader.take("preset");
    let Some(entry) = reader.take("instrument") else {
        if model.is_none() {
            let help = "add instrument = \"grand-springs\", or a model and a preset";
            report.miss(reader.place, "these keys have no instrument", help);
        }
        let voicing = Voicing::read(report, reader)?;
        let named = preset.map(|_entry| voicing.preset);
        if let (Some(entry), Some(known)) = (model, known_as(voicing.model, named)) {
            refuse_unstable(report, entry.node.place, known, in_loop);
        }
        return Some(voicing);
    };
    for extra in [model, preset].into_iter().flatten() {
        let message =
            format!("{} stands beside an instrument, which has its own", quoted(&extra.name));
        report.say(extra.place, message, "keep one of the two");
    }
    let name = read::text(report, "instrument", &entry.node)?;
    read_instrument(report, entry.node.place, &name, in_loop)
}

fn read_instrument(
    report: &mut MistakeList<'_>,
    place: Location,
    name: &str,
    in_loop: Option<LoopSettings<'_>>,
) -> Option<Voicing> {
    let found = match SourceText::find(&INSTRUMENTS, name, report.folder(place)) {
        Ok(source) => Instrument::check(&source),
        Err(SourceError::Unreadable(diagnostics)) => Err(diagnostics),
        Err(SourceError::Unknown((message, help))) => {
            report.say(place, message, help);
            return None;
        }
    };
    match found {
        Ok(instrument) => {
            refuse_unstable(report, place, &instrument, in_loop);
            Some(instrument.voicing)
        }
        Err(diagnostics) => {
            report.absorb(diagnostics);
            None
        }
    }
}

/// Reports an instrument at `place` that makes energy in the scene's loop.
fn refuse_unstable(
    report: &mut MistakeList<'_>,
    place: Location,
    instrument: &Instrument,
    in_loop: Option<LoopSettings<'_>>,
) {
    let Some(LoopSettings { tick_hz, render }) = in_loop else { return };
    if let Some(unmet) = instrument.needs.unmet(&instrument.name, tick_hz, render) {
        report.say(place, unmet.lacks, unmet.help);
    }
}
