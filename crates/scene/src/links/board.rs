//! `[[links.bus.board]]`: a board that must be there, and its keys.

use firmware_protocol::key::MOST_KEYS;
use keyboard::KeyRange;

use crate::quantity::Quantity;
use crate::read::{self, TableReader};
use documents::toml::{FindingList, SourcePlace, TomlNode};

const NUMBER: Quantity = Quantity { unit: "1", range: (0.0, 14.0) };

#[derive(Clone, Copy, Debug)]
pub(super) struct Listed {
    place: SourcePlace,
    number: Option<(u8, SourcePlace)>,
    keys: Option<(KeyRange, SourcePlace)>,
}

impl Listed {
    pub(super) fn checked(&self) -> Option<(u8, KeyRange)> {
        let ((number, _), (keys, _)) = (self.number?, self.keys?);
        Some((number, keys))
    }
}

pub(super) fn read_all(report: &mut FindingList, node: &TomlNode) -> Vec<Listed> {
    let mut boards = Vec::new();
    for node in read::tables(report, "links.bus.board", node) {
        let Some(mut reader) = TableReader::new(report, "links.bus.board", node) else { continue };
        boards.push(read(report, &mut reader));
        reader.finish(report);
    }
    boards
}

fn read(report: &mut FindingList, reader: &mut TableReader<'_>) -> Listed {
    let number = reader.whole(report, "number", NUMBER).and_then(|it| u8::try_from(it).ok());
    let number = number.zip(reader.take("number").map(|entry| entry.node.place));
    let keys = reader.text(report, "keys");
    if reader.take("number").is_none() || reader.take("keys").is_none() {
        let message = "a board has a number and keys";
        report.miss(reader.place, message, "as number = 3, keys = \"F#3..E4\"");
    }
    let keys = keys.and_then(|(keys, place)| Some((read_keys(report, &keys, place)?, place)));
    Listed { place: reader.place, number, keys }
}

/// Returns the keys of a board, if it can have so many.
fn read_keys(report: &mut FindingList, text: &str, place: SourcePlace) -> Option<KeyRange> {
    match KeyRange::parse(text) {
        Ok(keys) if keys.numbers().len() <= MOST_KEYS => Some(keys),
        Ok(keys) => {
            let n = keys.numbers().len();
            let message = format!("these are {n} keys, and a board has {MOST_KEYS}");
            report.say(place, message, "give each board its own, as F#3..E4");
            None
        }
        Err(error) => {
            let help = "write the first and the last key, as F#3..E4";
            report.say(place, error.to_string(), help);
            None
        }
    }
}

pub(super) fn refuse_shared_numbers(report: &mut FindingList, boards: &[Listed]) {
    for (n, board) in boards.iter().enumerate() {
        let Some((number, place)) = board.number else { continue };
        let is_it = |other: &&Listed| other.number.is_some_and(|(it, _)| it == number);
        if let Some(first) = boards.iter().take(n).find(is_it) {
            let there = report.line(first.place);
            let message = format!("{number} is already the number of the board of {there}");
            report.say(place, message, "give each board on a bus its own");
        }
    }
}

pub(super) fn refuse_shared_keys(report: &mut FindingList, boards: &[Listed]) {
    for (n, board) in boards.iter().enumerate() {
        let Some((keys, place)) = board.keys else { continue };
        let shared = boards.iter().take(n).find_map(|other| {
            other.keys.and_then(|(its, _)| its.intersection(keys)).map(|shared| (other, shared))
        });
        if let Some((first, shared)) = shared {
            let message =
                format!("{shared} already belongs to the board of {}", report.line(first.place));
            report.say(place, message, "let every key be on one board only");
        }
    }
}
