//! Scenes and instruments with mistakes in them.

use std::fs;

use crate::letoff::{check, check_words, folder, run};

/// A typo, a wrong unit, a value out of range, an unknown name, an overlap.
const MISTAKES: &str = r#"title = "Wrong in many places"
tick_hz = "4 kg"
lane = 2

[render]
stepper = "rk5"
force_limit = "250 N"

[[keys]]
range = "A0..C4"
instrument = "grand-sprigs"

[[keys]]
range = "C4..C8"
instrument = "grand-springs"
"#;

#[test]
fn all_mistakes_of_a_scene_are_reported_at_once_each_with_its_place() {
    let folder = folder("mistakes");
    fs::write(folder.join("mistakes.toml"), MISTAKES).expect("a file");
    let said = run(&folder, &["run", "mistakes.toml"]);
    assert_eq!(said.code, Some(2), "{said:?}");
    let lines = said.lines();
    let expected = [
        ("mistakes.toml:2:11: ", "kg"),
        ("mistakes.toml:3:1: ", "lanes"),
        ("mistakes.toml:6:11: ", "rk4"),
        ("mistakes.toml:7:15: ", "250"),
        ("mistakes.toml:11:14: ", "grand-springs"),
        ("mistakes.toml:14:9: ", "C4"),
    ];
    assert_eq!(lines.len(), expected.len(), "{said:?}");
    for (line, (place, word)) in lines.iter().zip(expected) {
        assert!(line.contains(place) && line.contains(word), "no {place}{word} in {line}");
        assert!(line.contains("; "), "no help in {line}");
    }
}

#[test]
fn checking_it_says_the_same_and_for_programs_too() {
    let folder = folder("checked");
    fs::write(folder.join("mistakes.toml"), MISTAKES).expect("a file");
    let said = run(&folder, &["check", "mistakes.toml"]);
    assert_eq!((said.code, said.lines().len()), (Some(2), 1 + 6 * 3), "{said:?}");
    let carets = said.lines().iter().filter(|line| line.trim() == "^").count();
    assert_eq!(carets, 6, "{said:?}");
    check_words(&said, &["1 file is wrong", "mistakes.toml:2:11: ", "mistakes.toml:14:9: "]);
    let said = run(&folder, &["check", "--json", "mistakes.toml"]);
    assert_eq!(said.code, Some(2), "{said:?}");
    let mistakes = said.report();
    assert_eq!(mistakes[0].as_array().map(Vec::len), Some(6), "{mistakes}");
    assert_eq!((&mistakes[0][0]["line"], &mistakes[0][0]["column"]), (&2.into(), &11.into()));
}

#[test]
fn a_description_in_the_place_of_an_instrument_is_called_what_it_is() {
    let folder = folder("description-as-instrument");
    let spring = include_str!("../../configs/models/spring.toml");
    fs::write(folder.join("mine.toml"), spring).expect("a file");
    let scene = "[[keys]]\nrange = \"A0..C8\"\ninstrument = \"mine.toml\"\n";
    fs::write(folder.join("scene.toml"), scene).expect("a file");
    let words = ["scene.toml:3:14: ", "description of a model", "write model = \"mine.toml\""];
    check(&folder, &["run", "scene.toml"], 2, &words);
}

#[test]
fn the_name_of_a_file_is_escaped_in_mistakes_and_in_the_report() {
    let folder = folder("escaped");
    let name = "e\u{1b}[31m\nx\u{202e}.toml";
    let escaped = r"e\u{1b}[31m\nx\u{202e}";
    fs::write(folder.join(name), "title = \"half of it\"\n[[keys").expect("a file");
    check(&folder, &["run", name], 2, &[escaped, "not TOML"]);
    fs::write(folder.join(name), include_str!("../../configs/scenes/springs.toml"))
        .expect("a file");
    let said = run(&folder, &["check", name]);
    assert_eq!(
        said.out.lines().next(),
        Some(&*format!("{escaped}.toml: a good scene")),
        "{said:?}"
    );
    let said = run(&folder, &["run", name, "--virtual-time", "--duration", "0.1"]);
    assert!(said.out.starts_with(&format!("{escaped}: 88 voices")), "{said:?}");
}

#[test]
fn a_folder_is_no_scene() {
    let folder = folder("folder-as-scene");
    fs::create_dir_all(folder.join("scene.toml")).expect("a folder");
    check(&folder, &["run", "scene.toml"], 2, &["scene.toml"]);
}
