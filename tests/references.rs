//! Every source that a comment cites by its key is in REFERENCES.md.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

#[test]
fn every_key_that_is_cited_resolves() {
    let known = entries(&read(&root().join("REFERENCES.md")));
    for (key, file) in cited() {
        assert!(
            known.contains(&key),
            "{} cites [{key}], which REFERENCES.md does not have: add it there",
            file.display()
        );
    }
}

#[test]
fn no_key_stands_for_two_sources() {
    let text = read(&root().join("REFERENCES.md"));
    let lines = text.lines().filter(|line| entry(line).is_some()).count();
    assert_eq!(lines, entries(&text).len(), "a key has two entries");
}

#[test]
fn the_references_own_tables_cite_only_what_they_list() {
    let text = read(&root().join("REFERENCES.md"));
    let known = entries(&text);
    for key in text.lines().flat_map(keys) {
        assert!(known.contains(key), "REFERENCES.md mentions [{key}] without an entry");
    }
}

#[test]
fn keys_are_initials_and_two_digits() {
    let found: Vec<_> = keys("as [GC93] eq. 12, `[Bar92]`; not [f64; N], [0], [KEY], [A1], [1993]");
    assert_eq!(found, ["GC93", "Bar92"]);
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).expect("a text file")
}

fn entries(text: &str) -> BTreeSet<String> {
    text.lines().filter_map(entry).map(String::from).collect()
}

fn entry(line: &str) -> Option<&str> {
    line.strip_prefix("- **[")?.split_once("]** ").map(|(key, _)| key).filter(|key| is_key(key))
}

fn cited() -> BTreeMap<String, PathBuf> {
    let mut found = BTreeMap::new();
    for folder in ["crates", "firmware-protocol", "benches", "configs"] {
        for file in files(&root().join(folder)) {
            let text = read(&file);
            for key in text.lines().filter_map(|line| prose(line, &file)).flat_map(keys) {
                found.insert(String::from(key), file.clone());
            }
        }
    }
    assert!(found.contains_key("GC93"), "the sources cite the paper");
    found
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten().filter_map(Result::ok) {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if comment(&path).is_some() {
                found.push(path);
            }
        }
    }
    found
}

fn prose<'a>(line: &'a str, file: &Path) -> Option<&'a str> {
    match comment(file)? {
        "" => Some(line),
        mark => line.split_once(mark).map(|(_, prose)| prose),
    }
}

/// Returns the opening of a comment in a file of this kind; empty where all is prose.
fn comment(file: &Path) -> Option<&'static str> {
    match file.extension()?.to_str()? {
        "rs" => Some("//"),
        "toml" | "md" => Some(""),
        _ => None,
    }
}

/// Returns the keys in a line: `[`, letters starting with a capital, two digits, `]`.
fn keys(line: &str) -> Vec<&str> {
    let inner = line.split('[').skip(1).filter_map(|rest| rest.split_once(']'));
    inner.map(|(inner, _)| inner).filter(|inner| is_key(inner)).collect()
}

fn is_key(word: &str) -> bool {
    let Some((letters, digits)) =
        word.len().checked_sub(2).and_then(|at| word.split_at_checked(at))
    else {
        return false;
    };
    letters.starts_with(|first: char| first.is_ascii_uppercase())
        && letters.chars().all(|letter| letter.is_ascii_alphabetic())
        && digits.chars().all(|digit| digit.is_ascii_digit())
}
