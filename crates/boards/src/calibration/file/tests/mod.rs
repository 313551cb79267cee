//! Written files are read back, and no others.

use firmware_protocol::key::{MOST_KEYS, PerKey};
use firmware_protocol::quantity::Counts;
use proptest::prelude::*;

use super::read::{WantedKeys, parse as parse_wanted};
use super::{CalibrationSheet, backup, load, load_partial, read, write};
use crate::{calibration::KeyCalibration, identity::Uid};

const UID: Uid = Uid([0x53, 0x49, 0x4d, 3, 33, 0]);

fn key(n: i32) -> KeyCalibration {
    KeyCalibration {
        rest: Counts::saturating(17 - 40 * n),
        quantum: 1.25e-6,
        gain: 1.0 + 0.01 * f64::from(n),
        bottom: Counts::saturating(8_145 - 40 * n),
        friction: 0.11,
    }
}

fn parse(file: &str, bytes: &[u8], uid: Uid, n_keys: usize) -> Result<CalibrationSheet, String> {
    parse_wanted(file, bytes, uid, (n_keys, WantedKeys::All))
}

fn sheet(n_keys: i32) -> CalibrationSheet {
    CalibrationSheet {
        uid: UID,
        made: "2026-03-14 \"late\"".into(),
        by: "letoff calibrate".into(),
        keys: PerKey::collect((0..n_keys).map(key).map(Some)),
    }
}

#[track_caller]
fn said(from: &str, to: &str) -> String {
    let text = sheet(3).render();
    assert!(text.contains(from), "{from} is not in {text}");
    parse("f.toml", text.replacen(from, to, 1).as_bytes(), UID, 3).unwrap_err()
}

#[test]
fn a_file_that_was_edited_is_refused() {
    for (from, to) in
        [("rest = 17", "rest = 18"), ("friction = 0.11", "friction = 0.2"), ("late", "soon")]
    {
        let sentence = said(from, to);
        assert!(sentence.starts_with("f.toml was edited or cut"), "{sentence}");
    }
}

#[test]
fn a_value_that_is_spelled_otherwise_is_the_same_value() {
    let text = sheet(3).render().replacen("gain = 1.0\n", "gain = 1 # a motor\n", 1);
    assert_eq!(parse("f.toml", text.as_bytes(), UID, 3).unwrap(), sheet(3));
}

#[test]
fn every_mistake_is_named_with_file_and_slot() {
    let text = sheet(2).render();
    let text = text.replacen("rest = 17", "rest = 17.5", 1).replacen("gain = 1.01", "gain = 99", 1);
    let sentences = parse("f.toml", text.as_bytes(), UID, 3).unwrap_err();
    let lines: Vec<_> = sentences.lines().collect();
    assert_eq!(lines.len(), 3, "{sentences}");
    assert!(lines[0].contains("slot 0: rest is no whole number"), "{sentences}");
    assert!(lines[1].contains("slot 1: gain is 99, and 0.1 to 10 is possible"), "{sentences}");
    assert!(lines[2].contains("slot 2: it is missing"), "{sentences}");
    assert!(lines.iter().all(|line| line.starts_with("f.toml, slot ")), "{sentences}");
}

#[test]
fn what_cannot_be_is_refused_in_a_sentence() {
    let cases = [
        ("board = \"53", "board = \"54", "is of board 54494d032100, not of 53494d032100"),
        ("slot = 1", "slot = 0", "slot 0: it stands here twice"),
        ("slot = 2", "slot = 7", "slot 7: the board has slots 0 to 2"),
        ("slot = 2", "slot = -1", "has no slot"),
        ("bottom = 8145", "bottom = 3000", "slot 0: from rest to bottom it is 3.7 mm"),
        ("rest = 17", "rest = 9999999", "slot 0: rest is 9999999"),
        ("friction = 0.11", "friction = nan", "slot 0: friction is NaN"),
        ("gain = 1.0\n", "grain = 1.0\n", "slot 0: nothing is called \"grain\""),
        ("made = ", "made := ", "is not TOML"),
        ("[[key]]", "[key]", "is not TOML"),
        ("checksum = ", "# ", "checksum is missing"),
    ];
    for (from, to, expected) in cases {
        let sentence = said(from, to);
        assert!(sentence.contains(expected), "{from} → {to}: {sentence}");
    }
}

#[test]
fn a_file_that_is_not_there_is_none_and_one_that_was_replaced_is_kept() {
    let folder = std::env::temp_dir().join(format!("letoff-sheet-{}", std::process::id()));
    let path = super::path(&folder.join("deep"), UID);
    assert_eq!(read(&path, UID, 3), Ok(None));
    write(&path, &sheet(3)).unwrap();
    let newer = CalibrationSheet { made: "later".into(), ..sheet(3) };
    write(&path, &newer).unwrap();
    assert_eq!(load(&path, UID, 3), Ok(Some(newer)));
    assert_eq!(load(&backup(&path), UID, 3), Ok(Some(sheet(3))));
    assert_eq!(std::fs::read_dir(path.parent().unwrap()).unwrap().count(), 2, "no part is left");
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_file_without_some_keys_is_no_whole_one_and_is_read_as_what_it_is() {
    let folder = std::env::temp_dir().join(format!("letoff-partial-{}", std::process::id()));
    let path = super::partial(&super::path(&folder, UID));
    let mut keys = sheet(3).keys;
    keys.as_mut_slice()[1] = None;
    let some = CalibrationSheet { keys, ..sheet(3) };
    write(&path, &some).unwrap();
    assert_eq!(load_partial(&path, UID, 3), Ok(Some(some)));
    assert!(read(&path, UID, 3).unwrap_err().contains("slot 1: it is missing"));
    std::fs::remove_dir_all(folder).unwrap();
}

fn any_key() -> impl Strategy<Value = KeyCalibration> {
    let travel = 5.1e-3..19.9e-3_f64;
    (-4_000_000..4_000_000_i32, 6e-9..1e-4_f64, 0.1..10.0_f64, travel, 0.0..5.0_f64).prop_map(
        |(rest, quantum, gain, travel, friction)| {
            let rest = Counts::saturating(rest);
            let key = KeyCalibration { rest, quantum, gain, friction, bottom: rest };
            KeyCalibration { bottom: key.counts(travel), ..key }
        },
    )
}

fn any_sheet() -> impl Strategy<Value = CalibrationSheet> {
    let keys = proptest::collection::vec(any_key(), 1..=MOST_KEYS);
    (any::<[u8; 6]>(), ".{0,20}", "\\PC{0,20}", keys).prop_map(|(uid, made, by, keys)| {
        CalibrationSheet {
            uid: Uid(uid),
            made,
            by,
            keys: PerKey::collect(keys.into_iter().map(Some)),
        }
    })
}

proptest! {
    #[test]
    fn what_is_written_is_read_back(sheet in any_sheet()) {
        let n = sheet.keys.as_slice().len();
        let read = parse("f.toml", sheet.render().as_bytes(), sheet.uid, n);
        prop_assert_eq!(read, Ok(sheet));
    }

    #[test]
    fn any_bytes_are_refused_without_a_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(parse("f.toml", &bytes, UID, 11).is_err());
    }

    #[test]
    fn any_toml_is_refused_without_a_panic(text in "(\\[\\[?key\\]?\\]|slot|rest|gain|=|[0-9]|-|\"|\n| ){0,60}") {
        prop_assert!(parse("f.toml", text.as_bytes(), UID, 11).is_err());
    }

    #[test]
    fn a_file_that_was_cut_is_refused(at in 0..1_000_usize) {
        let text = sheet(3).render();
        let cut = &text.as_bytes()[..at * (text.len() - 4) / 1_000];
        prop_assert!(parse("f.toml", cut, UID, 3).is_err());
    }
}

#[test]
fn each_flipped_bit_is_refused_or_changes_no_value() {
    let (sheet, bytes) = (sheet(2), sheet(2).render().into_bytes());
    let mut refused = 0;
    for place in 0..bytes.len() {
        for bit in 0..8 {
            let mut flipped = bytes.clone();
            flipped[place] ^= 1 << bit;
            match parse("f.toml", &flipped, UID, 2) {
                Ok(read) => assert_eq!(read, sheet, "bit {bit} of byte {place}"),
                Err(_) => refused += 1,
            }
        }
    }
    assert!(2_000 < refused, "{refused} of {}", 8 * bytes.len());
}
