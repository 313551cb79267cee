//! `[[keys]]`: which keys are what.

use models::catalogue::Entry;

use super::document::{Node, Value};
use super::embedded::INSTRUMENTS;
use super::instrument::{Instrument, known_as};
use super::needs::Loop;
use super::range::{KeyRange, Refusal};
use super::read::{self, Reader};
use super::report::{Place, Report};
use super::source::{Missing, Source};
use super::voicing::Voicing;
use crate::names::quoted;

/// What a key is.
#[derive(Clone, Debug)]
pub struct KeyVoice {
    /// Its model.
    pub model: &'static Entry,
    /// One value per parameter of the model, in the unit of each.
    pub values: Vec<f64>,
}

/// Number of keys, A0 to C8.
const KEYS: usize = midi::KEYS as usize;

/// Reads the key ranges; one entry per key, none where it is silent.
///
/// Refuses instruments that are not stable `in_loop`, if there is one.
pub(super) fn read(
    report: &mut Report<'_>,
    reader: &mut Reader<'_>,
    in_loop: Option<Loop<'_>>,
) -> Vec<Option<KeyVoice>> {
    let mut voices = vec![None; KEYS];
    let Some(entry) = reader.take("keys") else {
        let help = "add [[keys]] with a range and an instrument";
        report.miss(reader.place, "the scene has no keys", help);
        return voices;
    };
    let Value::List(ranges) = &entry.node.value else {
        read::wrong_type(report, "keys", &entry.node, "a list", "write it as [[keys]]");
        return voices;
    };
    if ranges.is_empty() {
        let help = "add [[keys]] with a range and an instrument";
        report.miss(entry.place, "the scene has no keys", help);
    }
    let mut taken = Vec::new();
    for node in ranges {
        let read = read_range(report, node, &mut taken, in_loop);
        let Some((range, voicing)) = read else { continue };
        for key in range.first..=range.last {
            let voice = KeyVoice { model: voicing.model, values: voicing.values(key) };
            voices[usize::from(key)] = Some(voice);
        }
    }
    voices
}

/// A range that was read, and where.
type Taken = (KeyRange, Place);

/// Reads one `[[keys]]` table; all of it, even if part of it is wrong.
fn read_range(
    report: &mut Report<'_>,
    node: &Node,
    taken: &mut Vec<Taken>,
    in_loop: Option<Loop<'_>>,
) -> Option<(KeyRange, Voicing)> {
    let mut reader = Reader::new(report, "[keys]", node)?;
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

fn read_bounds(report: &mut Report<'_>, reader: &mut Reader<'_>) -> Option<Taken> {
    let Some(entry) = reader.take("range") else {
        report.miss(reader.place, "these keys have no range", "add range = \"A0..C8\"");
        return None;
    };
    let place = entry.node.place;
    let text = if let Value::Integer(number) = entry.node.value {
        number.to_string()
    } else {
        read::text(report, "range", &entry.node)?
    };
    match KeyRange::parse(&text) {
        Ok(range) => Some((range, place)),
        Err(refusal) => {
            refuse_range(report, place, &text, &refusal);
            None
        }
    }
}

fn refuse_range(report: &mut Report<'_>, place: Place, text: &str, refusal: &Refusal) {
    let (message, help) = match refusal {
        Refusal::NoNote(note) => (
            format!("{} in the range is no note", quoted(note)),
            "write notes from A0 to C8 or MIDI numbers from 21 to 108, as \"A0..C8\"",
        ),
        Refusal::OffKeyboard(note) => (
            format!("{} is not on the keyboard", quoted(note)),
            "stay within A0..C8, which is 21..108",
        ),
        Refusal::Backwards => {
            (format!("the range {} runs backwards", quoted(text)), "put the lower note first")
        }
    };
    report.say(place, message, help);
}

fn refuse_overlap(report: &mut Report<'_>, (range, place): Taken, taken: &[Taken]) {
    for (other, other_place) in taken {
        if let Some(shared) = range.shared(*other) {
            let first = report.describe(*other_place);
            let message = format!("{shared} already belongs to the range of {first}");
            report.say(place, message, "let every key be in one range only");
        }
    }
}

/// Reads `instrument`, or `model` and `preset`.
fn read_voicing(
    report: &mut Report<'_>,
    reader: &mut Reader<'_>,
    in_loop: Option<Loop<'_>>,
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
            refuse_unstable(report, entry.node.place, &known, in_loop);
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
    report: &mut Report<'_>,
    place: Place,
    name: &str,
    in_loop: Option<Loop<'_>>,
) -> Option<Voicing> {
    let found = match Source::find(&INSTRUMENTS, name, report.folder(place)) {
        Ok(source) => Instrument::check(&source),
        Err(Missing::Unreadable(diagnostics)) => Err(diagnostics),
        Err(Missing::Unknown((message, help))) => {
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
    report: &mut Report<'_>,
    place: Place,
    instrument: &Instrument,
    in_loop: Option<Loop<'_>>,
) {
    let Some(Loop { tick_hz, render }) = in_loop else { return };
    if let Some(unmet) = instrument.needs.unmet(&instrument.name, tick_hz, render) {
        report.say(place, unmet.lacks, unmet.help);
    }
}
