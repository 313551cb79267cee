//! Names of a description as Rust identifiers, each once.

use std::collections::HashSet;

/// The longest identifier made from a name of a description.
const LONGEST: usize = 20;

/// Words that Rust keeps for itself.
const KEPT: [&str; 52] = [
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if",
    "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
    "ref", "return", "self", "static", "struct", "super", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Words that the emitted code uses itself.
const USED: [&str; 13] = [
    "given",
    "out",
    "math",
    "functions",
    "constants",
    "state",
    "input",
    "extra",
    "core",
    "f64",
    "Some",
    "None",
    "call",
];

/// Identifiers that are taken in one scope.
#[derive(Clone, Debug)]
pub(super) struct Identifiers {
    taken: HashSet<String>,
}

impl Identifiers {
    pub(super) fn new() -> Self {
        Self { taken: KEPT.iter().chain(&USED).map(|word| (*word).to_owned()).collect() }
    }

    /// Returns an identifier like `name` that nothing else has, and takes it.
    pub(super) fn take(&mut self, name: &str) -> String {
        self.take_long(name, LONGEST)
    }

    /// The same of at most `longest` letters before primes and numbers.
    pub(super) fn take_long(&mut self, name: &str, longest: usize) -> String {
        let plain = plain(name, longest);
        let free = if self.taken.contains(&plain) { self.numbered(&plain) } else { plain };
        self.taken.insert(free.clone());
        free
    }

    fn numbered(&self, name: &str) -> String {
        // As many as there are names would do.
        (2..=self.taken.len() + 2)
            .map(|number| format!("{name}_{number}"))
            .find(|it| !self.taken.contains(it))
            .unwrap_or_default()
    }
}

/// `name` with letters, digits and single underscores alone: `theta'` is `theta_rate`.
pub(super) fn plain(name: &str, longest: usize) -> String {
    let name = name.trim();
    let stem = name.trim_end_matches('\'');
    let primes = name.len() - stem.len();
    let mut text = String::new();
    for character in stem.chars() {
        let good = if character.is_ascii_alphanumeric() { character } else { '_' };
        if good != '_' || !text.ends_with('_') {
            text.push(good);
        }
    }
    let mut text = text.trim_matches('_').to_owned();
    text.truncate(longest);
    // `v12` is the name of an unnamed value.
    let is_numbered = text.strip_prefix('v').is_some_and(|rest| rest.parse::<u64>().is_ok());
    if text.starts_with(|it: char| it.is_ascii_digit()) || text.is_empty() || is_numbered {
        text.insert_str(0, "x_");
    }
    match primes {
        0 => text,
        1 => format!("{text}_rate"),
        more => format!("{text}_rate{more}"),
    }
}

/// `name` as the name of a type: `key-hammer` is `KeyHammer`.
pub(super) fn type_name(name: &str) -> String {
    let mut text = String::new();
    for word in name.split(|it: char| !it.is_ascii_alphanumeric()).filter(|it| !it.is_empty()) {
        let mut letters = word.chars();
        text.extend(letters.next().map(|it| it.to_ascii_uppercase()));
        text.push_str(letters.as_str());
    }
    if text.is_empty() || text.starts_with(|it: char| it.is_ascii_digit()) {
        text.insert_str(0, "Model");
    }
    text
}
