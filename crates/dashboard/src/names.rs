//! Names of keys and parameters: A0 is key 0, C8 is key 87.

use std::ops::RangeInclusive;

use telemetry::{KeyIndex, Parameter};

/// Number of the last key, C8.
pub const LAST: u8 = KeyIndex::HIGHEST.number();

/// Returns the name of `key`, as `C#4`.
pub fn name(key: u8) -> String {
    telemetry::key_name(key.into())
}

/// Returns the technician's term of a parameter, or else its name.
pub fn title(parameter: &Parameter) -> &str {
    if parameter.title.is_empty() { &parameter.name } else { &parameter.title }
}

pub fn is_black(key: u8) -> bool {
    let semitone = key.saturating_add(KeyIndex::LOWEST.midi()) % 12;
    matches!(semitone, 1 | 3 | 6 | 8 | 10)
}

pub fn whites_below(key: u8) -> usize {
    (0..key).filter(|key| !is_black(*key)).count()
}

/// Parses a note's name, with sharps or flats, or a MIDI number.
pub fn key(name: &str) -> Option<u8> {
    name.parse().ok().map(KeyIndex::number)
}

/// Returns the range's name, as `C4..B5`; a single key's own.
pub fn range_name(range: &RangeInclusive<u8>) -> String {
    if range.start() == range.end() {
        name(*range.start())
    } else {
        format!("{}..{}", name(*range.start()), name(*range.end()))
    }
}

/// Parses a range: `C4..B5`, `C4` or `all`.
pub fn range(text: &str) -> Option<RangeInclusive<u8>> {
    let text = text.trim();
    if text.is_empty() || text.eq_ignore_ascii_case("all") {
        return Some(0..=LAST);
    }
    let Some((low, high)) = text.split_once("..") else {
        return key(text).map(|key| key..=key);
    };
    let (low, high) = (key(low)?, key(high)?);
    (low <= high).then_some(low..=high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_is_found_by_its_name() {
        for key in 0..=LAST {
            assert_eq!(super::key(&name(key)), Some(key), "{}", name(key));
        }
        assert_eq!(name(0), "A0");
        assert_eq!(name(39), "C4");
        assert_eq!(name(87), "C8");
        assert_eq!(key("Bb3"), key("A#3"));
    }

    #[test]
    fn ranges_are_read_as_they_are_written() {
        for range in [0..=87, 39..=50, 12..=12] {
            assert_eq!(super::range(&range_name(&range)), Some(range));
        }
        assert_eq!(range("all"), Some(0..=87));
        for foreign in ["B5..C4", "H2", "C9", "G0", "..", "C4...C5", "-C4"] {
            assert_eq!(range(foreign), None, "{foreign}");
        }
    }

    #[test]
    fn fifty_two_keys_are_white() {
        assert_eq!((0..=LAST).filter(|key| !is_black(*key)).count(), 52);
        assert_eq!(whites_below(LAST), 51);
    }
}
