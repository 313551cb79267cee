//! Note names in scientific pitch notation: C4 is MIDI note 60.

use core::{fmt, str::FromStr};

use crate::KeyIndex;

/// Names of the twelve semitones from C on.
const SEMITONES: [&str; 12] = ["C", "C#", "D", "D#", "E", "F", "F#", "G", "G#", "A", "A#", "B"];

/// Reason why a text names no key.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NoteError {
    NotANote,
    /// The note lies outside A0 to C8.
    OffKeyboard,
}

impl fmt::Display for KeyIndex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let note = usize::from(self.midi());
        write!(f, "{}{}", SEMITONES[note % 12], note / 12 - 1)
    }
}

impl FromStr for KeyIndex {
    type Err = NoteError;

    /// Parses a note name with sharps or flats (`C#4`, `db4`), or a MIDI number (`60`).
    fn from_str(text: &str) -> Result<Self, NoteError> {
        let text = text.trim();
        let note = match text.parse::<i64>() {
            Ok(number) => number,
            Err(_no_number) => note_number(text).ok_or(NoteError::NotANote)?,
        };
        u8::try_from(note).ok().and_then(Self::from_midi).ok_or(NoteError::OffKeyboard)
    }
}

/// Returns the MIDI number of a note's name, also outside the compass.
fn note_number(name: &str) -> Option<i64> {
    let mut characters = name.chars();
    let semitone = match characters.next()?.to_ascii_uppercase() {
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
    let (accidental, octave) = if let Some(octave) = rest.strip_prefix(['#', '♯']) {
        (1, octave)
    } else if let Some(octave) = rest.strip_prefix(['b', '♭']) {
        (-1, octave)
    } else {
        (0, rest)
    };
    let octave = i64::from(octave.parse::<i8>().ok()?);
    Some(12 * (octave + 1) + semitone + accidental)
}

#[cfg(test)]
mod tests {
    use std::string::ToString as _;

    use super::*;

    #[test]
    fn keys_have_their_names() {
        for (key, name) in [(0, "A0"), (3, "C1"), (39, "C4"), (40, "C#4"), (48, "A4"), (87, "C8")] {
            assert_eq!(KeyIndex::new(key).unwrap().to_string(), name);
        }
    }

    #[test]
    fn every_name_and_number_is_read_as_its_key() {
        for key in KeyIndex::all() {
            assert_eq!(key.to_string().parse(), Ok(key));
            assert_eq!(key.midi().to_string().parse(), Ok(key));
        }
    }

    #[test]
    fn flats_and_foreign_spellings_are_read() {
        for (text, key) in [("Db4", 40), ("D♯4", 42), ("Cb4", 38), ("B#3", 39), (" a0 ", 0)] {
            assert_eq!(text.parse(), Ok(KeyIndex::new(key).unwrap()), "{text}");
        }
    }

    #[test]
    fn what_names_no_key_is_refused() {
        let read = str::parse::<KeyIndex>;
        for text in ["H2", "", "C", "C99999", "key"] {
            assert_eq!(read(text), Err(NoteError::NotANote), "{text}");
        }
        for text in ["G0", "C#8", "109", "-1", "99999999999"] {
            assert_eq!(read(text), Err(NoteError::OffKeyboard), "{text}");
        }
    }
}
