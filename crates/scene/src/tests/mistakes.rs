//! Messages about mistakes, word for word.

use mechanism::Library;
use std::path::Path;

use boards::links::address::Address;

use super::*;

/// Asserts that exactly `expected` is reported of `text`; FOLDER is the working directory.
#[track_caller]
fn check(text: &str, overrides: &[(&str, &str)], expected: &str) {
    let said = match Scene::check(&Library::default(), &source(text), &owned(overrides)) {
        Ok(_) => "nothing is wrong".to_owned(),
        Err(all) => all.to_string(),
    };
    let folder = std::env::current_dir().unwrap();
    let expected = expected.trim_end().replace("FOLDER", &folder.to_string_lossy());
    assert!(said == expected, "said:\n{said}\n\nexpected:\n{expected}");
}

#[test]
fn all_mistakes_are_said_at_once() {
    check(include_str!("golden/mistakes.toml"), &[], include_str!("golden/mistakes.txt"));
}

#[test]
fn every_mistake_of_a_play_list_is_said_at_its_piece() {
    let text = format!(
        "{TWO_RANGES}[pianist]\nperformance = [\"bach-bwv-864\", \"none\", 3, \"mine.mid\"]\n\
         repeat = 2\n"
    );
    check(&text, &[], include_str!("golden/play_list.txt"));
    let text = format!("{MINIMAL}[pianist]\nperformance = []\nrepeat = true\n");
    let expected = "scene.toml:5:15: \"performance\" is empty; name a piece, or give \"none\"";
    check(&text, &[], expected);
}

#[test]
fn a_wrong_override_is_named_instead_of_a_line() {
    let overrides = [
        ("tick_hz", "fast"),
        ("rendr.stepper", "heun"),
        ("render.steper", "heun"),
        ("render.force_limit", "20 kg"),
        ("midi", "none"),
        ("keys.parameters.restitutoin", "0.2"),
        ("keys.2.instrument", "grand-rigid"),
        ("keys.1.range", "B3..C8"),
        ("keys.0.instrument", "./nowhere/mine.toml"),
        ("..", "1"),
    ];
    check(TWO_RANGES, &overrides, include_str!("golden/overrides.txt"));
}

#[test]
fn all_mistakes_of_links_are_said_at_once() {
    check(include_str!("golden/links.toml"), &[], include_str!("golden/links.txt"));
}

#[test]
fn simulated_keys_have_nothing_of_boards() {
    let text = format!(
        "{MINIMAL}[links]\nkind = \"simulated\"\nvalid = \"20 ms\"\nsamples = \"position24\"\n\
         bus = []\n"
    );
    let help = "leave it out, or write kind = \"boards\"";
    let agreed = |place: &str, name: &str| {
        format!(
            "scene.toml:{place}: {name:?} is agreed with boards, and these keys are simulated; {help}\n"
        )
    };
    let (valid, samples) = (agreed("6:9", "valid"), agreed("7:11", "samples"));
    let bus = format!("scene.toml:8:7: a simulated keybed has no bus; {help}");
    check(&text, &[], &format!("{valid}{samples}{bus}"));
    let silent = text.replace("kind = \"simulated\"\n", "").replace("bus = []\n", "");
    let (valid, samples) = (agreed("5:9", "valid"), agreed("6:11", "samples"));
    check(&silent, &[], &format!("{valid}{samples}"));
}

#[test]
fn boards_without_a_bus_are_refused() {
    let help = "add [[links.bus]] with serial = \"/dev/ttyACM0\" or can = \"can0\"";
    let text = format!("{MINIMAL}[links]\nkind = \"boards\"\n");
    check(&text, &[], &format!("scene.toml:4:1: boards need a bus; {help}"));
    let text = format!("{text}bus = []\n");
    check(&text, &[], &format!("scene.toml:6:7: boards need a bus; {help}"));
}

#[test]
fn an_override_of_a_list_says_which_items_there_are() {
    let text = format!("{MINIMAL}[links]\nkind = \"boards\"\n[[links.bus]]\ncan = \"can0\"\n");
    check(
        &text,
        &[("links.bus.1.can", "can1"), ("links.bus.bit_rate", "500000"), ("midi.0.x", "1")],
        "--set links.bus.1.can=can1: \"links.bus\" is a list without this item; use links.bus.0, \
         the only one\n\
         --set links.bus.bit_rate=500000: \"links.bus\" is a list without this item; use \
         links.bus.0, the only one\n\
         --set midi.0.x=1: \"midi\" has no items; add one to the file first",
    );
}

#[test]
fn a_wrong_link_is_named_as_it_was_typed() {
    let can = Address::parse("can:can0").unwrap();
    let all =
        Scene::load_as_typed(&Library::default(), "springs", &link_overrides(&[can.clone(), can]))
            .unwrap_err();
    assert_eq!(
        all.to_string(),
        "--link can:can0 --link can:can0: \"can0\" stands here twice; leave one of them out"
    );
}

#[test]
fn what_is_no_toml_is_said_line_by_line() {
    check(include_str!("golden/syntax.toml"), &[], include_str!("golden/syntax.txt"));
}

#[test]
fn after_a_broken_header_nothing_is_taken_for_something_else() {
    check(
        "lanes = 2\n[render\nstepper = \"heun\"\n",
        &[],
        "scene.toml:2:8: this is not TOML, unclosed table, expected `]`; correct the line",
    );
}

#[test]
fn threads_get_what_the_kernel_knows_and_no_more() {
    let check = |table: &str, said: &str| {
        check(&format!("lanes = 2\n[realtime]\n{table}\n{MINIMAL}"), &[], said);
    };
    check("policy = \"fifo\"\ncpus = [2, 3]", "nothing is wrong");
    check(
        "policy = \"fif\"",
        "scene.toml:3:10: there is no policy \"fif\"; use \"fifo\", the nearest of auto, fifo, deadline, ordinary",
    );
    check(
        "cpus = 2",
        "scene.toml:3:8: \"cpus\" is a number, not a list; write the processors' numbers, as [2, 3]",
    );
    check("cpus = [-1]", "scene.toml:3:9: \"cpus\" is -1, out of range; give 0 to 1023");
    check(
        "policy = \"deadline\"\ncpus = [0]",
        "scene.toml:2:1: \"cpus\" is set, and \"deadline\" runs on any processor; leave cpus out, or \
         give policy = \"fifo\"\n\
         scene.toml:2:1: \"deadline\" is for one lane, and \"lanes\" is 2; give lanes = 1, or policy = \
         \"fifo\"",
    );
}

#[test]
fn a_scene_without_keys_is_refused() {
    let said = "scene.toml:1:1: the scene has no keys; add [[keys]] with a range and an instrument";
    check("", &[], said);
    check("keys = []\n", &[], said);
}

#[test]
fn a_step_that_no_tick_can_afford_is_refused() {
    let text = format!("tick_hz = 500\n[render]\nlongest_step = \"2 us\"\n{MINIMAL}");
    check(
        &text,
        &[],
        "scene.toml:3:16: \"longest_step\" is 2e-6 s, but a tick at 500 Hz may take 960 steps at \
         most; give at least 2.1 us, or a faster tick",
    );
    check(&text.replace("2 us", "2.1 us"), &[], "nothing is wrong");
}

#[test]
fn two_voices_for_one_range_are_refused() {
    check(
        &format!("{MINIMAL}preset = \"paper\"\n"),
        &[],
        "scene.toml:4:1: \"preset\" stands beside an instrument, which has its own; \
         keep one of the two",
    );
}

#[test]
fn a_scene_that_is_not_there_is_answered_with_those_that_are() {
    let said = |name: &str| Scene::load(&Library::default(), name, &[]).unwrap_err().to_string();
    assert_eq!(
        said("papr"),
        "papr: there is no scene \"papr\"; use \"paper\", the nearest of default, springs, \
         bach, paper, paper-rig, mixed, fast, rigid, or a path to a file of yours"
    );
    let folder = std::env::current_dir().unwrap();
    let expected = format!(
        "mine.toml: there is no file \"mine.toml\" in {}; correct the path",
        folder.display()
    );
    assert_eq!(said("mine.toml"), expected);
    assert_eq!(
        check_file(&Library::default(), Path::new("mine.toml")).unwrap_err().to_string(),
        expected
    );
}

#[test]
fn a_file_that_is_no_scene_is_refused() {
    let folder = Folder::new("refused");
    let check = |bytes: &[u8], expected: &str| {
        let path = folder.write("file.toml", bytes);
        let said = check_file(&Library::default(), Path::new(&path)).unwrap_err().to_string();
        assert_eq!(said.strip_prefix(&path), Some(expected));
    };
    check(b"ti\xff", ":1:3: this byte is not UTF-8; save the file as UTF-8 text");
    check(
        "a = 'ä'\nää\u{1}".as_bytes(),
        ":2:4: this is not TOML, key with no value, expected `=`; correct the line",
    );
    check(
        b"title = \"a shopping list\"\n",
        ":1:1: this is neither a scene nor an instrument nor a model; a scene has [[keys]], an \
         instrument a model, a description [modes]",
    );
    check(
        &vec![b' '; 300_000],
        ": the file is longer than 256 KiB; this is no scene or instrument, choose another",
    );
}

#[test]
fn programs_read_the_same_as_json() {
    let text = "lanes = 0\n[[keys]]\nrange = 60\nmodel = \"spring-wall\"\n";
    let all = Scene::check(&Library::default(), &source(text), &[]).unwrap_err();
    let expected = concat!(
        r#"[{"file":"scene.toml","line":1,"column":9,"#,
        r#""message":"\"lanes\" is 0, out of range","help":"give 1 to 16"}]"#
    );
    assert_eq!(serde_json::to_string(&all).unwrap(), expected);
}
