//! Any input: no panic, and consistent values or mistakes with a place.

use mechanism::Library;
use std::path::Path;

use proptest::prelude::*;
use proptest::sample::{Index, select};

use super::super::embedded::{EmbeddedFiles, INSTRUMENTS, SCENES};
use super::super::{checked_file, quantity};
use super::*;

fn read(bytes: &[u8], overrides: &[Override]) {
    let Ok(source) = SourceText::from_bytes(Path::new("any.toml"), bytes.to_vec()) else { return };
    match Scene::check(&Library::default(), &source, overrides) {
        Ok(scene) => {
            assert_eq!(scene.keys.len(), 88);
            let mut values = scene.keys.iter().flatten().flat_map(|voice| &voice.values);
            assert!(values.all(|value| value.is_finite()));
        }
        Err(all) => check_places(&all, source.text.split('\n').count()),
    }
    let found = Instrument::check(&Library::default(), &source);
    let mut values =
        found.iter().flat_map(|instrument| (0..88).flat_map(|key| instrument.values(key)));
    assert!(values.all(f64::is_finite));
    drop(checked_file::check(&Library::default(), &source));
}

fn check_places(all: &Diagnostics, n_lines: usize) {
    assert!(!all.as_slice().is_empty());
    for mistake in all.as_slice() {
        assert!(mistake.line.is_none_or(|line| (1..=n_lines).contains(&line)), "{mistake}");
        assert!(!mistake.message.contains('\n'), "{mistake}");
    }
}

fn shipped() -> impl Strategy<Value = &'static str> {
    let texts = |shelf: &EmbeddedFiles| shelf.names().filter_map(|name| shelf.find(name)).collect();
    let all: [Vec<&str>; 2] = [texts(&SCENES), texts(&INSTRUMENTS)];
    select(all.concat())
}

fn fragment() -> impl Strategy<Value = String> {
    const KNOWN: [&str; 36] = [
        "[",
        "]",
        "[[",
        "]]",
        "{",
        "}",
        "=",
        ".",
        ",",
        "\"",
        "'''",
        "\"\"\"",
        "\n",
        "\r",
        "#",
        "é",
        "\u{feff}",
        "\u{0}",
        "nan",
        "-inf",
        "1e999",
        "99999999999999999999",
        "-1",
        "true",
        "1979-05-27",
        "\"20 kg\"",
        "[[keys]]\n",
        "[keys.parameters]\n",
        "keys = 1\n",
        "keys = [1]\n",
        "range = \"C4\"\n",
        "bass",
        "treble",
        "\"1e39999 N\"",
        "instrument = \"/\"\n",
        "tick_hz = 0.5\n",
    ];
    prop_oneof![select(&KNOWN[..]).prop_map(str::to_owned), ".{0,8}"]
}

fn any_override() -> impl Strategy<Value = (String, String)> {
    const STEPS: [&str; 26] = [
        "keys",
        "0",
        "1",
        "9",
        "render",
        "stepper",
        "parameters",
        "restitution",
        "instrument",
        "range",
        "model",
        "tick_hz",
        "lanes",
        "realtime",
        "policy",
        "cpus",
        "midi",
        "output",
        "",
        "title",
        "pianist",
        "performance",
        "x",
        "links",
        "bus",
        "bit_rate",
    ];
    let steps = proptest::collection::vec(select(&STEPS[..]), 0..6);
    (steps.prop_map(|steps| steps.join(".")), fragment())
}

fn any_overrides() -> impl Strategy<Value = Vec<Override>> {
    proptest::collection::vec(any_override().prop_map(Override::from), 0..4)
}

proptest! {
    #[test]
    fn any_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        read(&bytes, &[]);
    }

    #[test]
    fn any_text(
        text in proptest::collection::vec(fragment(), 0..40),
        overrides in any_overrides(),
    ) {
        read(text.concat().as_bytes(), &overrides);
    }

    #[test]
    fn any_change_of_a_scene(
        text in shipped(),
        changes in proptest::collection::vec((any::<Index>(), 0_usize..20, fragment()), 1..4),
        overrides in any_overrides(),
    ) {
        let mut bytes = text.as_bytes().to_vec();
        for (index, removed, inserted) in changes {
            let start = index.index(bytes.len() + 1);
            let end = (start + removed).min(bytes.len());
            bytes.splice(start..end, inserted.into_bytes());
        }
        read(&bytes, &overrides);
    }

    #[test]
    fn any_override_of_a_scene(text in shipped(), overrides in any_overrides()) {
        read(text.as_bytes(), &overrides);
    }

    #[test]
    fn any_quantity(text in ".{0,50}", unit in ".{0,8}") {
        drop(quantity::parse(&text, &unit));
    }
}

#[test]
fn a_document_of_any_depth() {
    let steps = "a.".repeat(100_000);
    read("[".repeat(100_000).as_bytes(), &[]);
    read(format!("{steps}a = 1").as_bytes(), &[]);
    read(format!("[{steps}a]").as_bytes(), &[]);
    read(format!("a = {}", "[".repeat(100_000)).as_bytes(), &[]);
    read(format!("a = {}", "{a=".repeat(80_000)).as_bytes(), &[]);
    let deep = ("a".to_owned(), "[".repeat(100_000));
    read(MINIMAL.as_bytes(), &[(steps, String::new()).into(), deep.into()]);
}
