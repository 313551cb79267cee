//! Reader of a calibration file, which reports all of its faults.

use std::{fmt, path::Path};

use documents::shown;
use firmware_protocol::key::{MOST_KEYS, PerKey};
use firmware_protocol::quantity::Counts;
use toml_edit::{Document, Item, Table};

use super::CalibrationSheet;
use crate::{calibration::KeyCalibration, identity::Uid};

/// Readings of 24 bits (counts).
const READINGS: (f64, f64) = (Counts::MIN.get() as f64, Counts::MAX.get() as f64);
/// Possible displacements per count (m).
const QUANTA: (f64, f64) = (1e-9, 1e-3);
/// Possible friction of a key (N).
const FRICTIONS: (f64, f64) = (0.0, 5.0);
/// Possible motor gains (1).
const GAINS: (f64, f64) = (0.1, 10.0);
/// Possible travels of a key (m).
const TRAVELS: (f64, f64) = (5e-3, 20e-3);

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum WantedKeys {
    All,
    Any,
}

/// Reads the complete file of a board of `n_keys` keys; `None` if there is none.
///
/// # Errors
/// All faults of the file, a sentence on each line.
pub fn load(path: &Path, uid: Uid, n_keys: usize) -> Result<Option<CalibrationSheet>, String> {
    load_wanted(path, uid, n_keys, WantedKeys::All)
}

/// Like [`load`], but accepts a file without some of the board's keys.
pub fn load_partial(
    path: &Path,
    uid: Uid,
    n_keys: usize,
) -> Result<Option<CalibrationSheet>, String> {
    load_wanted(path, uid, n_keys, WantedKeys::Any)
}

fn load_wanted(
    path: &Path,
    uid: Uid,
    n_keys: usize,
    wanted: WantedKeys,
) -> Result<Option<CalibrationSheet>, String> {
    let bytes = match std::fs::read(path) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(format!("{} cannot be read: {error}", shown(path))),
    };
    parse(&shown(path), &bytes, uid, (n_keys, wanted)).map(Some)
}

pub(super) fn parse(
    file: &str,
    bytes: &[u8],
    uid: Uid,
    (n_keys, wanted): (usize, WantedKeys),
) -> Result<CalibrationSheet, String> {
    let mut reader = CalibrationReader { file, wanted, mistakes: Vec::new() };
    let sheet = reader.read(bytes, uid, n_keys);
    match sheet {
        Some(sheet) if reader.mistakes.is_empty() => Ok(sheet),
        Some(_) | None => Err(reader.mistakes.join("\n")),
    }
}

struct CalibrationReader<'a> {
    file: &'a str,
    wanted: WantedKeys,
    mistakes: Vec<String>,
}

impl CalibrationReader<'_> {
    fn say(&mut self, what: impl fmt::Display) {
        self.mistakes.push(format!("{}{what}", self.file));
    }

    fn read(&mut self, bytes: &[u8], uid: Uid, n_keys: usize) -> Option<CalibrationSheet> {
        let Ok(text) = std::str::from_utf8(bytes) else {
            self.say(" is no text; calibrate the board again");
            return None;
        };
        let document = match Document::parse(text) {
            Ok(document) => document,
            Err(error) => {
                let why = error.message().replace(['\n', '\r'], " ");
                self.say(format_args!(" is not TOML ({why}); calibrate the board again"));
                return None;
            }
        };
        let root = document.as_table();
        self.refuse_unknown(root, &["board", "made", "by", "checksum", "key"], "");
        let board = self.text(root, "board");
        let (made, by) = (self.text(root, "made"), self.text(root, "by"));
        let checksum = self.text(root, "checksum");
        let keys = self.keys(root, n_keys);
        if let Some(board) = &board
            && *board != uid.to_string()
        {
            self.say(format_args!(
                " is of board {board:.40}, not of {uid}; give each board its own file"
            ));
        }
        let sheet = CalibrationSheet { uid, made: made?, by: by?, keys: keys? };
        self.check(&sheet, &checksum?, &board?);
        Some(sheet)
    }

    fn check(&mut self, sheet: &CalibrationSheet, checksum: &str, board: &str) {
        // The board's own file under another name fails for that alone.
        let is_other_board = board != sheet.uid.to_string();
        if !is_other_board && checksum != format!("{:08x}", sheet.checksum()) {
            self.say(format_args!(
                " was edited or cut: its checksum is {checksum:.40}, that of its values \
                 {:08x}; calibrate the board again",
                sheet.checksum()
            ));
        }
    }

    fn refuse_unknown(&mut self, table: &Table, known: &[&str], place: &str) {
        for (name, _) in table.iter().filter(|(name, _)| !known.contains(name)) {
            self.say(format_args!("{place}: nothing is called {name:.40?}; remove it"));
        }
    }

    fn text(&mut self, table: &Table, name: &str) -> Option<String> {
        let text = table.get(name).and_then(Item::as_str);
        if text.is_none() {
            self.say(format_args!(": {name} is missing or no text; calibrate the board again"));
        }
        text.map(str::to_owned)
    }

    fn keys(&mut self, root: &Table, n_keys: usize) -> Option<PerKey<Option<KeyCalibration>>> {
        let Some(tables) = root.get("key").and_then(Item::as_array_of_tables) else {
            self.say(": there is no [[key]]; calibrate the board again");
            return None;
        };
        let before = self.mistakes.len();
        let mut slots = [None; MOST_KEYS];
        for table in tables {
            let (slot, key) = self.key(table);
            match slot.map(|slot| (slot, slots.get_mut(slot))) {
                Some((slot, Some(place))) if slot < n_keys && place.is_none() => {
                    *place = Some(key);
                }
                Some((slot, Some(Some(_)))) => {
                    self.say(format_args!(", slot {slot}: it stands here twice; remove one"));
                }
                Some((slot, _)) => self.say(format_args!(
                    ", slot {slot}: the board has slots 0 to {}; calibrate it again",
                    n_keys.saturating_sub(1)
                )),
                None => {}
            }
        }
        for (slot, _) in slots.iter().enumerate().take(n_keys).filter(|(_, it)| it.is_none()) {
            if self.wanted == WantedKeys::All {
                self.say(format_args!(", slot {slot}: it is missing; calibrate the board again"));
            }
        }
        let keys = PerKey::collect(slots.iter().take(n_keys).map(|key| key.flatten()));
        (self.mistakes.len() == before).then_some(keys)
    }

    fn key(&mut self, table: &Table) -> (Option<usize>, Option<KeyCalibration>) {
        let slot = table.get("slot").and_then(Item::as_integer);
        let slot = slot.and_then(|slot| usize::try_from(slot).ok());
        if slot.is_none() {
            self.say(": a [[key]] has no slot, a whole number from 0 on; calibrate again");
        }
        let place = slot.map_or_else(|| ", a key without a slot".into(), |n| format!(", slot {n}"));
        let known = ["slot", "rest", "bottom", "metres_per_count", "friction", "gain"];
        self.refuse_unknown(table, &known, &place);
        let rest = self.reading(table, &place, "rest");
        let bottom = self.reading(table, &place, "bottom");
        let quantum = self.number(table, &place, "metres_per_count", QUANTA);
        let friction = self.number(table, &place, "friction", FRICTIONS);
        let gain = self.number(table, &place, "gain", GAINS);
        let key = rest.zip(bottom).zip(quantum).zip(friction).zip(gain);
        let key = key.map(|((((rest, bottom), quantum), friction), gain)| KeyCalibration {
            rest,
            quantum,
            gain,
            bottom,
            friction,
        });
        let key = key.filter(|key| self.is_possible(key, &place));
        (slot, key)
    }

    fn is_possible(&mut self, key: &KeyCalibration, place: &str) -> bool {
        let (least, most) = TRAVELS;
        let is_possible = (least..=most).contains(&key.travel());
        if !is_possible {
            self.say(format_args!(
                "{place}: from rest to bottom it is {:.1} mm, and {} to {} mm is possible; \
                 calibrate the board again",
                1e3 * key.travel(),
                1e3 * least,
                1e3 * most
            ));
        }
        is_possible
    }

    fn reading(&mut self, table: &Table, place: &str, name: &str) -> Option<Counts> {
        if table.get(name).is_some_and(|it| !it.is_integer()) {
            self.say(format_args!("{place}: {name} is no whole number; calibrate again"));
            return None;
        }
        self.number(table, place, name, READINGS)?;
        let reading = table.get(name)?.as_integer()?;
        i32::try_from(reading).ok().map(Counts::saturating)
    }

    fn number(
        &mut self,
        table: &Table,
        place: &str,
        name: &str,
        (least, most): (f64, f64),
    ) -> Option<f64> {
        let item = table.get(name);
        let value =
            item.and_then(|it| it.as_float().or_else(|| it.as_integer().map(|it| it as f64)));
        let Some(value) = value else {
            self.say(format_args!("{place}: {name} is missing or no number; calibrate again"));
            return None;
        };
        if !(least..=most).contains(&value) {
            self.say(format_args!(
                "{place}: {name} is {value}, and {least} to {most} is possible; calibrate again"
            ));
            return None;
        }
        Some(value)
    }
}
