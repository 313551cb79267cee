//! Instruments that are saved as differences from another one.

use std::fs;
use std::path::Path;

use keyboard::{Difference, KEYS};
use mechanism::Library;

use super::super::based::{CompassDifferences, InstrumentEdit};
use super::super::embedded::INSTRUMENTS;
use super::super::instrument::{Instrument, instruments};
use super::super::source::SourceText;
use super::Folder;

fn loaded(text: &str, folder: &Path) -> Result<Instrument, String> {
    let path = folder.join("mine.toml");
    let source = SourceText::from_bytes(&path, text.as_bytes().to_vec()).expect("a text");
    Instrument::check(&Library::default(), &source).map_err(|it| it.to_string())
}

/// A small change of each kind on some keys of every parameter, within its range.
fn edit_of(base: &Instrument, seed: usize) -> InstrumentEdit {
    let all: Vec<_> = (0..88).map(|key| base.values(key)).collect();
    let mut edit = InstrumentEdit::new();
    for (index, parameter) in base.model().parameters.iter().enumerate() {
        let difference = |key: usize| {
            let (value, (low, high)) = (all[key][index], parameter.range);
            let share = (key * 37 + index * 11 + seed) % 101;
            let share = share as f64 / 1000.0;
            let wanted = match (key / 8 + index + seed) % 4 {
                0 => return None,
                1 => Difference::Offset(value * share),
                2 => Difference::Factor(1.0 - share),
                _ => Difference::Value(value * (1.0 + 0.1 * share)),
            };
            Some(wanted).filter(|it| (low..=high).contains(&it.applied_to(value)))
        };
        let differences: CompassDifferences = std::array::from_fn(difference);
        if differences.iter().any(Option::is_some) {
            edit.insert(parameter.name.to_owned(), differences);
        }
    }
    edit
}

fn expected(base: &Instrument, edits: &[&InstrumentEdit]) -> Vec<Vec<u64>> {
    let of_key = |key: u8| {
        let mut values = base.values(key);
        for edit in edits {
            for (value, parameter) in values.iter_mut().zip(&base.model().parameters) {
                let of_parameter = edit.get(parameter.name);
                let difference = of_parameter.and_then(|it| it[usize::from(key)]);
                *value = difference.map_or(*value, |it| it.applied_to(*value));
            }
        }
        values.iter().map(|it| it.to_bits()).collect()
    };
    (0..88).map(of_key).collect()
}

#[test]
fn every_instrument_is_saved_and_loaded_to_the_last_bit() {
    assert_eq!(instruments().len(), INSTRUMENTS.names().count());
    for info in instruments() {
        let base = Instrument::load(&Library::default(), &info.name).expect("an instrument");
        assert_eq!((&info.title, &info.needs), (&base.title, &base.needs.summary()));
        assert_eq!(info.model, base.model().name);
        assert_eq!(info.preset, base.voicing.preset().name);
        for edit in [InstrumentEdit::new(), edit_of(&base, 1)] {
            let text = base.edited(&info.name, "Mine", &edit);
            let mine = loaded(&text, Path::new("")).unwrap_or_else(|it| panic!("{it}\n{text}"));
            assert_eq!(expected(&mine, &[]), expected(&base, &[&edit]), "{}", info.name);
            assert_eq!((mine.title.as_str(), mine.program), ("Mine", base.program));
            assert_eq!(mine.figures, base.figures);
            assert!(mine.based.is_some_and(|it| !it.has_changed && it.base == info.name));
        }
    }
}

#[test]
fn a_saved_instrument_that_is_changed_is_saved_over_the_first_base() {
    let base = Instrument::load(&Library::default(), "grand-springs").expect("an instrument");
    let first = edit_of(&base, 0);
    let mine = loaded(&base.edited("grand-springs", "Mine", &first), Path::new("")).expect("saved");
    let second = edit_of(&mine, 2);
    let text = mine.edited("elsewhere/mine.toml", "Ours", &second);
    let ours = loaded(&text, Path::new("")).unwrap_or_else(|it| panic!("{it}\n{text}"));
    assert_eq!(expected(&ours, &[]), expected(&base, &[&first, &second]));
    assert_eq!(ours.based.map(|it| it.base).as_deref(), Some("grand-springs"));
}

#[test]
fn a_line_over_the_compass_takes_few_points() {
    let base = Instrument::load(&Library::default(), "spring").expect("an instrument");
    let name = base.model().parameters[0].name.to_owned();
    let line = std::array::from_fn(|key| Some(Difference::Factor(1.0 + 0.25 * key as f64)));
    let text = base.edited("spring", "Mine", &InstrumentEdit::from([(name, line)]));
    // Where rounding would leave the line by a bit, it has a point more.
    let points = text.matches("[\"").count();
    assert!((2..=4).contains(&points), "{text}");
}

#[test]
fn a_base_that_changed_is_noticed_and_followed_only_when_asked() {
    let Folder(folder) = &Folder::new("edited");
    let file = folder.join("base.toml");
    let base = |stiffness: &str| {
        let text = format!("model = \"key-hammer-springs\"\n[parameters]\nk2 = {stiffness}\n");
        fs::write(&file, text).expect("a file");
        Instrument::load(&Library::default(), &file.to_string_lossy()).expect("an instrument")
    };
    let first = base("5000");
    let mut more = [None; KEYS];
    more[40] = Some(Difference::Factor(2.0));
    let edit = InstrumentEdit::from([("k2".to_owned(), more)]);
    let text = first.edited("base.toml", "Mine", &edit);
    let second = base("6000");
    let mine = loaded(&text, folder).expect("a saved instrument");
    assert_eq!(expected(&mine, &[]), expected(&first, &[&edit]));
    assert!(mine.based.as_ref().is_some_and(|it| it.has_changed));
    let followed = mine.on_present_base().expect("values in range");
    assert_eq!(expected(&followed, &[]), expected(&second, &[&edit]));
    // Base values edited by hand no longer match the hash.
    let damaged = text.replace("k2 = 5000.0", "k2 = 5001.0");
    assert!(damaged != text);
    let refused = loaded(&damaged, folder).expect_err("another hash");
    assert!(refused.contains("base values are not those that were saved"), "{refused}");
}

#[test]
fn mistakes_in_differences_are_reported_with_their_remedy() {
    for (line, message) in [
        ("kk = { factor = [[\"C4\", 2]] }", "the base has no parameter \"kk\""),
        ("k2 = { times = [[\"C4\", 2]] }", "write { offset"),
        ("k2 = { factor = [[\"H4\", 2]] }", "write { offset"),
        ("k2 = { factor = [[\"C4\", 2], [\"A0\", 2]] }", "A0 comes too early"),
        ("k2 = { factor = [[\"C4\", -1]] }", "\"k2\" becomes"),
        ("k2 = { factor = [] }", "write { offset"),
        ("k2 = 3", "write { offset"),
    ] {
        let text = format!("base = \"grand-springs\"\n[differences]\n{line}\n");
        let refused = loaded(&text, Path::new("")).expect_err(line);
        assert!(refused.contains(message), "{line}: {refused}");
    }
    let folder = Folder::new("based");
    let own = folder.write("mine.toml", b"base = \"grand-springs\"\n[differences]\n");
    let text = format!("base = {own:?}\n[differences]\n");
    let refused = loaded(&text, Path::new("")).expect_err("a base with a base");
    assert!(refused.contains("has a base itself"), "{refused}");
}
