use core::{fmt, ops::RangeInclusive};

use crate::{KeyIndex, NoteError};

/// Keys from `first` to `last`, both included.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct KeyRange {
    first: KeyIndex,
    last: KeyIndex,
}

/// Reason why a text is no range of keys; displayed as a sentence with the remedy.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RangeError<'a> {
    NotANote(&'a str),
    /// The note lies outside A0 to C8.
    OffKeyboard(&'a str),
    Backwards(&'a str),
}

impl KeyRange {
    pub const ALL: Self = Self { first: KeyIndex::LOWEST, last: KeyIndex::HIGHEST };

    pub fn new(first: KeyIndex, last: KeyIndex) -> Option<Self> {
        (first <= last).then_some(Self { first, last })
    }

    /// Parses `"A0..C8"`, `"21..108"` or a single note; an error contains the invalid piece.
    pub fn parse(text: &str) -> Result<Self, RangeError<'_>> {
        let (first, last) = text.split_once("..").unwrap_or((text, text));
        Self::new(read(first)?, read(last)?).ok_or(RangeError::Backwards(text))
    }

    pub const fn first(self) -> KeyIndex {
        self.first
    }

    pub const fn last(self) -> KeyIndex {
        self.last
    }

    pub const fn numbers(self) -> RangeInclusive<u8> {
        self.first.number()..=self.last.number()
    }

    #[must_use]
    pub fn intersection(self, other: Self) -> Option<Self> {
        Self::new(self.first.max(other.first), self.last.min(other.last))
    }
}

fn read(text: &str) -> Result<KeyIndex, RangeError<'_>> {
    let text = text.trim();
    text.parse().map_err(|error| match error {
        NoteError::NotANote => RangeError::NotANote(text),
        NoteError::OffKeyboard => RangeError::OffKeyboard(text),
    })
}

impl fmt::Display for KeyRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.first)?;
        if self.first < self.last {
            write!(f, " to {}", self.last)?;
        }
        Ok(())
    }
}

impl fmt::Display for RangeError<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotANote(note) => write!(f, "\"{note}\" is no note: write C4..B5 or 60..83"),
            Self::OffKeyboard(note) => write!(f, "\"{note}\" is not on the keyboard, A0 to C8"),
            Self::Backwards(range) => {
                write!(f, "\"{range}\" goes backwards: write the lower note first")
            }
        }
    }
}

impl core::error::Error for RangeError<'_> {}

#[cfg(test)]
mod tests {
    use std::string::ToString as _;

    use super::*;

    #[track_caller]
    fn check(text: &str, first: u8, last: u8) {
        let range = KeyRange::parse(text).unwrap();
        assert_eq!(range.numbers(), first..=last, "{text}");
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
    }

    #[test]
    fn what_is_no_range_is_refused_with_the_reason() {
        let check = |text, error| assert_eq!(KeyRange::parse(text), Err(error), "{text}");
        check("C4..B3", RangeError::Backwards("C4..B3"));
        check("G0..C8", RangeError::OffKeyboard("G0"));
        check("21..109", RangeError::OffKeyboard("109"));
        check("C99999", RangeError::NotANote("C99999"));
        check("H2", RangeError::NotANote("H2"));
        check("A0-C8", RangeError::NotANote("A0-C8"));
        check("", RangeError::NotANote(""));
        check("A0..", RangeError::NotANote(""));
    }

    #[test]
    fn a_range_is_shown_by_its_notes() {
        for text in ["A0 to C8", "A#0 to C1", "F#4"] {
            let range = KeyRange::parse(&text.replace(" to ", "..")).unwrap();
            assert_eq!(range.to_string(), text);
        }
    }

    #[test]
    fn an_intersection_is_what_both_ranges_have() {
        let range = |text| KeyRange::parse(text).unwrap();
        assert_eq!(range("A0..C4").intersection(range("C3..C8")), Some(range("C3..C4")));
        assert_eq!(range("A0..B3").intersection(range("C4..C8")), None);
    }
}
