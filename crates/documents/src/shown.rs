//! Names of files in messages.

use std::path::Path;

/// Returns `path` for messages: see [`escaped`].
pub fn shown(path: &Path) -> String {
    escaped(&path.to_string_lossy())
}

/// Returns `text` on one line, with each character escaped that [`is_unprintable`].
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        if is_unprintable(character) {
            out.extend(character.escape_default());
        } else {
            out.push(character);
        }
    }
    out
}

/// Returns `true` for characters that act on a terminal or on the text around them: control
/// characters, line and paragraph separators, and marks of writing direction.
pub fn is_unprintable(character: char) -> bool {
    character.is_control()
        || matches!(
            character,
            '\u{061c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_changes_neither_the_terminal_nor_the_text_around_it() {
        assert_eq!(shown(Path::new("e\u{1b}[31m\nx.toml")), r"e\u{1b}[31m\nx.toml");
        assert_eq!(
            escaped("a\u{202e}b\u{2069}\u{200f}\u{61c}"),
            r"a\u{202e}b\u{2069}\u{200f}\u{61c}"
        );
        assert_eq!(escaped("Übung 1 ä/é.toml"), "Übung 1 ä/é.toml");
        assert_eq!(crate::quoted("a\u{202e}\n"), r#""a\u{202e}\n""#);
    }
}
