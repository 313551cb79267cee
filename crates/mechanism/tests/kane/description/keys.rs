//! README.md names every accepted key and every function, and no other.
//!
//! Accepted keys are those that the reader offers for an unknown key: a description with each kind
//! of table has a foreign key in each of them.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use super::mistakes_of;

const README: &str = include_str!("../../../LANGUAGE.md");

/// Keys that are read first, where the bases are merged.
const FIRST: [&str; 2] = ["base", "remove"];

/// Words beside the keys in the README's cells: placeholders for other names and values.
const OTHER_WORDS: [&str; 8] = ["ground", "motion", "q", "key", "u", "y", "x", "rigid"];

const COORDINATES: [&str; 4] = ["y", "h", "h'", "v"];

/// Each kind of table; `@name` becomes a foreign key in the README's row `name`.
const EVERYTHING: &str = r#"
name = "everything"
@top = 1

[input]
name = "s"
unit = "m"
per_metre = "1"
@input = 1

[parameters]
m = { value = "1 kg", range = ["1 g", "10 kg"], doc = "mass", @parameters = 1, reading = { at = "1 kg", is = "2 kg", per = 1, @parameters = 1 } }

[presets.light]
@presets = 1

[coordinates]
y = { unit = "m", range = [-1, 1], @coordinates = 1 }
h = { unit = "m", range = [-1, 1], speed_range = [-9, 9], @coordinates = 1 }

[speeds]
v = { unit = "m/s", range = [-9, 9], @speeds = 1 }

[rates]
y = "v"

[frames]
W = { origin = ["0 m", "y"], @frames = 1 }

[points]
P = { in = "W", @points = 1 }
Q = { in = "ground", @points = 1 }

[bodies]
weight = { frame = "W", mass = "m", @bodies = 1 }

[springs]
spring = { between = ["P", "Q"], length = "1 m", stiffness = "1 N/m", @springs = 1 }

[felts]
felt = { compression = "-y", stiffness = "1 N/m", @felts = 1 }

[forces]
force = { stretch = "y", force = "1 N", energy = "1 N*y", @forces = 1 }

[contacts]
contact = { gap = "y", stiffness = "1 N/m", @contacts = 1, friction = { slip = "v", stiction = "1 N", kinetic = "1 N", @contacts = 1 } }
stop = { gap = "h", rigid = true, restitution = 0.5, @contacts = 1, friction = { slip = "v", coefficient = 1, kinetic = 1, @contacts = 1 } }

[frictions]
bearing = { slip = "v", stiction = "1 N", kinetic = "1 N", @frictions = 1 }

[constraints]
floor = { zero = "y", @constraints = 1 }

[modes.free]
constraints = []
@mode = 1
[[modes.free.guards]]
name = "floor"
positive = "y"
@guard = 1
to = [{ mode = "free", @guard = 1, impact = { along = "y", @guard = 1 } }]

[outputs]
height = { unit = "m", value = "y", @outputs = 1 }

[rest]
mode = [{ when = "m > 1 kg", mode = "free", @rest = 1 }, { mode = "free" }]
@rest = 1

[damper]
lift = "5 mm"
fall = "4 mm"
softest_tone = "1 m/s"
@damper = 1

[midi]
velocity = 64
speeds = ["0.1 m/s", "1 m/s"]
pressure = "key"
pressure_range = ["5 N", "15 N"]
@midi = 1

[drawing]
@drawing = 1
[drawing.frames]
other = { frame = "ground", @drawing.frames = 1 }
[[drawing.outlines]]
@drawing.outlines = 1
[[drawing.springs]]
from = { frame = "ground", @drawing.springs = 1 }
@drawing.springs = 1
"#;

fn read_keys() -> BTreeMap<&'static str, BTreeSet<String>> {
    let mut rows = Vec::new();
    let mut pieces = EVERYTHING.split('@');
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (row, rest) = piece.split_once(" = 1").expect("a foreign key");
        write!(text, "qq{}qq = 1{rest}", rows.len()).expect("text grows");
        rows.push(row);
    }
    let mistakes = mistakes_of(&text, &());
    let mut keys = BTreeMap::<_, BTreeSet<String>>::new();
    for (number, row) in rows.iter().enumerate() {
        let key = format!("\"qq{number}qq\"");
        let said = mistakes.iter().find(|it| it.contains(&key));
        let offered = said.and_then(|it| it.split_once("; use "));
        let (_, offered) = offered.unwrap_or_else(|| panic!("{row} is not read: {mistakes:#?}"));
        let words = offered.trim_start_matches("one of ").split([',', ' ']);
        let words = words.map(|it| it.trim_matches('"').to_owned()).filter(|it| !it.is_empty());
        // In the rest pose coordinates and speeds are listed beside the keys.
        keys.entry(*row)
            .or_default()
            .extend(words.filter(|it| !COORDINATES.contains(&it.as_str())));
    }
    keys
}

/// Returns the README's text of each row: the cell of a table, or the paragraphs about it.
fn cells() -> BTreeMap<&'static str, String> {
    let (_, keys) = README.split_once("## Every key").expect("the keys");
    let keys = keys.split("\n## ").next().unwrap_or_default();
    let mut cells = BTreeMap::<_, String>::new();
    let known = read_keys();
    for line in keys.lines() {
        let cell = line.strip_prefix("| `[").and_then(|it| it.split_once("]` |"));
        let (row, text) = match cell {
            Some((row, text)) => (row.trim_matches(['[', ']']).split(".NAME").next(), text),
            None if line.starts_with("A mode has") => (Some("mode"), line),
            None if line.starts_with("`longest_projection`") => (Some("mode"), line),
            None if line.starts_with("Plain equations") => (Some("mode"), line),
            None if line.starts_with("`longest_projection`") => (Some("mode"), line),
            None if ["A guard (", "`to` is", "`set = "].iter().any(|it| line.starts_with(it)) => {
                (Some("guard"), line)
            }
            None if !line.starts_with('|') => (Some("top"), line),
            None => continue,
        };
        let row = row.unwrap_or_default();
        if let Some((row, _)) = known.get_key_value(row) {
            cells.entry(*row).or_default().push_str(text);
        }
    }
    cells
}

fn spans(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

fn is_word(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|it| it.is_ascii_lowercase() || it == '_')
}

fn named_keys(cell: &str) -> BTreeSet<String> {
    let mut keys = BTreeSet::new();
    for span in spans(cell) {
        let pieces = span.split(['{', '}', ',', '[', ']']).map(str::trim);
        for piece in pieces {
            let (word, is_alone) = match piece.split_once('=') {
                Some((word, _)) => (word.trim(), true),
                None => (piece, piece == span || span.contains('{')),
            };
            if is_alone && is_word(word) && !OTHER_WORDS.contains(&word) {
                keys.insert(word.to_owned());
            }
        }
    }
    keys
}

fn mentions(cell: &str, key: &str) -> bool {
    spans(cell).any(|span| {
        span.split(|it: char| !it.is_ascii_alphanumeric() && it != '_').any(|word| word == key)
    })
}

fn is_table(row: &str, key: &str) -> bool {
    let heading = match row {
        "top" => format!("| `[{key}"),
        "mode" => format!("`[[modes.NAME.{key}]]`"),
        _ => format!("| `[[{row}.{key}]]`"),
    };
    README.contains(&heading)
}

#[test]
fn every_key_that_is_read_is_in_the_readme() {
    let cells = cells();
    let mut missing = Vec::new();
    for (row, keys) in read_keys() {
        for key in keys {
            let cell = cells.get(row).unwrap_or_else(|| panic!("the README has no {row}"));
            if !is_table(row, &key) && !mentions(cell, &key) {
                missing.push(format!("{row}: {key}"));
            }
        }
    }
    assert!(missing.is_empty(), "not in the README: {missing:?}");
}

#[test]
fn every_key_in_the_readme_is_read() {
    let read = read_keys();
    let mut foreign = Vec::new();
    let mut count = 0;
    for (row, cell) in cells() {
        for key in named_keys(&cell) {
            count += 1;
            let is_first = row == "top" && FIRST.contains(&key.as_str());
            if !is_first && !read[row].contains(&key) {
                foreign.push(format!("{row}: {key}"));
            }
        }
    }
    assert!(foreign.is_empty(), "in the README, but not read: {foreign:?}");
    assert!(count > 80, "{count} keys were found");
}

#[test]
fn every_table_in_the_readme_is_read() {
    let read = read_keys();
    for line in README.lines().filter_map(|it| it.strip_prefix("| `[")) {
        let table = line.trim_start_matches('[').split([']', '.']).next().unwrap_or_default();
        assert!(read["top"].contains(table), "there is no table {table}");
    }
}

/// A function is a span of the README's table that continues in parentheses.
#[test]
fn every_function_in_the_readme_is_known() {
    let (_, table) = README.split_once("| function | is |").expect("the functions");
    let table = table.split("\n\n").next().unwrap_or_default();
    let mut named: Vec<_> =
        spans(table).filter_map(|it| it.split_once('(')).map(|(name, _)| name).collect();
    named.sort_unstable();
    let mut known: Vec<_> = mechanism::kane::text::FUNCTIONS.into_iter().collect();
    known.sort_unstable();
    assert_eq!(named, known);
}
