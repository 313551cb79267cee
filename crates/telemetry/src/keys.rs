//! Keys of a full compass, and what they are called.

/// Keys of a full compass: A0 to C8.
pub const KEYS: usize = 88;

/// Semitones from C on.
const NAMES: [&str; 12] = ["C", "C#", "D", "D#", "E", "F", "F#", "G", "G#", "A", "A#", "B"];

/// Semitones of A0, the lowest key, above C0.
const LOWEST: usize = 9;

/// The name of `key`, 0 (A0) to 87 (C8), in scientific pitch notation with sharps: `C#4`.
///
/// A number beyond the compass is no key and says so, as `key 255`.
pub fn key_name(key: u32) -> String {
    match usize::try_from(key) {
        Ok(key) if key < KEYS => {
            let semitone = key + LOWEST;
            format!("{}{}", NAMES[semitone % NAMES.len()], semitone / NAMES.len())
        }
        Ok(_) | Err(_) => format!("key {key}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_have_their_names() {
        for (key, name) in [(0, "A0"), (3, "C1"), (39, "C4"), (40, "C#4"), (48, "A4"), (87, "C8")] {
            assert_eq!(key_name(key), name);
        }
    }

    #[test]
    fn what_is_no_key_says_so() {
        for foreign in [88, 255, u32::MAX] {
            assert_eq!(key_name(foreign), format!("key {foreign}"));
        }
    }
}
