//! Names of the keys in messages.

use keyboard::KeyIndex;

/// Returns the name of `key`, 0 (A0) to 87 (C8), with sharps: `C#4`; else `key 255`.
pub fn key_name(key: u32) -> String {
    let index = u8::try_from(key).ok().and_then(KeyIndex::new);
    index.map_or_else(|| format!("key {key}"), |index| index.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_key_says_so() {
        for foreign in [88, 255, u32::MAX] {
            assert_eq!(key_name(foreign), format!("key {foreign}"));
        }
    }
}
