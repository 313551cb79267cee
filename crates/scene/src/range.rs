//! Ranges of keys: note names (C4 is 60) or MIDI numbers, from and to.

use std::fmt;

use firmware_protocol::key::KeyIndex;
use midi::Note;

/// Keys from `first` to `last`, both included.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct KeyRange {
    /// 0 (A0) ..= 87 (C8).
    pub(super) first: u8,
    /// `first` ..= 87 (C8).
    pub(super) last: u8,
}

/// Why text is no range of keys.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum RangeError {
    /// This is neither a note's name nor a number.
    NoNote(String),
    /// This note is not on the keyboard.
    OffKeyboard(String),
    /// The last note is below the first.
    Backwards,
}

impl KeyRange {
    /// Reads `"A0..C8"`, `"21..108"` or a single note.
    pub(super) fn parse(text: &str) -> Result<Self, RangeError> {
        let (first, last) = text.split_once("..").unwrap_or((text, text));
        let range = Self { first: key(first)?, last: key(last)? };
        if range.first <= range.last { Ok(range) } else { Err(RangeError::Backwards) }
    }

    /// The keys of both, if there are any.
    pub(super) fn shared(self, other: Self) -> Option<Self> {
        let (first, last) = (self.first.max(other.first), self.last.min(other.last));
        (first <= last).then_some(Self { first, last })
    }
}

/// The keys that `text` names, as 0 (A0) ..= 87 (C8).
///
/// # Errors
///
/// What is wrong with it, in a sentence.
pub fn keys_named(text: &str) -> Result<std::ops::RangeInclusive<u8>, String> {
    let range = KeyRange::parse(text).map_err(|refusal| match refusal {
        RangeError::NoNote(note) => format!("\"{note}\" is no note: write C4..B5 or 60..83"),
        RangeError::OffKeyboard(note) => format!("\"{note}\" is not on the keyboard, A0 to C8"),
        RangeError::Backwards => format!("\"{text}\" goes backwards: write the lower note first"),
    })?;
    Ok(range.first..=range.last)
}

impl fmt::Display for KeyRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_note(f, self.first)?;
        if self.first < self.last {
            f.write_str(" to ")?;
            write_note(f, self.last)?;
        }
        Ok(())
    }
}

/// The key, 0 (A0) ..= 87 (C8), as musicians call it.
pub(super) fn name(key: u8) -> String {
    KeyIndex::new(key).map_or_else(String::new, |key| key.to_string())
}

fn write_note(f: &mut fmt::Formatter<'_>, key: u8) -> fmt::Result {
    KeyIndex::new(key).map_or(Ok(()), |key| write!(f, "{key}"))
}

/// The key of a note's name or MIDI number.
fn key(text: &str) -> Result<u8, RangeError> {
    let text = text.trim();
    let number = match text.parse::<i64>() {
        Ok(number) => number,
        Err(_no_number) => named(text).ok_or_else(|| RangeError::NoNote(text.to_owned()))?,
    };
    let note = u8::try_from(number).ok().and_then(Note::from_number);
    note.map(Note::key).ok_or_else(|| RangeError::OffKeyboard(text.to_owned()))
}

/// MIDI number of a note's name, wherever it lies.
fn named(name: &str) -> Option<i64> {
    let mut characters = name.chars();
    let step = match characters.next()?.to_ascii_uppercase() {
        'C' => 0,
        'D' => 2,
        'E' => 4,
        'F' => 5,
        'G' => 7,
        'A' => 9,
        'B' => 11,
        _ => return None,
    };
    let rest = characters.as_str();
    let (sign, octave) = if let Some(octave) = rest.strip_prefix(['#', '♯']) {
        (1, octave)
    } else if let Some(octave) = rest.strip_prefix(['b', '♭']) {
        (-1, octave)
    } else {
        (0, rest)
    };
    let octave = i64::from(octave.parse::<i8>().ok()?);
    Some(12 * (octave + 1) + step + sign)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, first: u8, last: u8) {
        assert_eq!(KeyRange::parse(text), Ok(KeyRange { first, last }), "{text}");
    }

    #[test]
    fn names_and_numbers_mean_the_same_keys() {
        check("A0..C8", 0, 87);
        check("21..108", 0, 87);
        check(" a0 .. 108 ", 0, 87);
        check("C4", 39, 39);
        check("60", 39, 39);
        check("C#4..D4", 40, 41);
        check("Db4..D♯4", 40, 42);
        check("Cb4", 38, 38);
        check("B#3", 39, 39);
    }

    #[test]
    fn what_is_no_range_is_refused_with_the_reason() {
        let check = |text, refusal| assert_eq!(KeyRange::parse(text), Err(refusal), "{text}");
        check("C4..B3", RangeError::Backwards);
        check("G0..C8", RangeError::OffKeyboard("G0".to_owned()));
        check("21..109", RangeError::OffKeyboard("109".to_owned()));
        check("C99999", RangeError::NoNote("C99999".to_owned()));
        check("H2", RangeError::NoNote("H2".to_owned()));
        check("A0-C8", RangeError::NoNote("A0-C8".to_owned()));
        check("", RangeError::NoNote(String::new()));
        check("A0..", RangeError::NoNote(String::new()));
    }

    #[test]
    fn a_range_is_shown_by_its_notes() {
        for text in ["A0 to C8", "A#0 to C1", "F#4"] {
            let range = KeyRange::parse(&text.replace(" to ", "..")).unwrap();
            assert_eq!(range.to_string(), text);
        }
    }
}
