//! What the README says of commands: each can be typed, and prints what stands there.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

use std::fs;
use std::path::Path;

use crate::letoff::{folder, run};

/// The README's lines, those that end with a backslash joined with the next.
fn lines() -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let text = fs::read_to_string(path).expect("the README");
    text.replace("\\\n", " ").lines().map(str::to_owned).collect()
}

/// The words of a command behind `letoff`; quotes keep a word together.
fn words(command: &str) -> Vec<String> {
    let (mut words, mut word, mut is_quoted) = (Vec::new(), String::new(), false);
    for letter in command.chars() {
        match letter {
            '\'' => is_quoted = !is_quoted,
            ' ' if !is_quoted => words.push(std::mem::take(&mut word)),
            _ => word.push(letter),
        }
    }
    words.push(word);
    words.into_iter().filter(|word| !word.is_empty()).skip(1).collect()
}

/// The commands that stand as lines of their own, ready to be copied.
fn commands() -> Vec<Vec<String>> {
    let all: Vec<_> =
        lines().iter().filter(|line| line.starts_with("letoff ")).map(|it| words(it)).collect();
    assert!(all.len() >= 5, "the README shows commands: {all:?}");
    all
}

/// The commands within sentences, with their optional parts.
fn mentioned() -> Vec<Vec<String>> {
    let lines = lines();
    let quoted = lines.iter().flat_map(|line| line.split('`').skip(1).step_by(2));
    let mentioned = quoted.filter(|it| it.starts_with("letoff "));
    let all: Vec<_> = mentioned.map(|it| words(&it.replace(['[', ']', '…'], ""))).collect();
    assert!(all.len() >= 10, "the README mentions commands: {all:?}");
    all
}

fn borrowed(words: &[String]) -> Vec<&str> {
    words.iter().map(String::as_str).collect()
}

#[test]
fn every_command_can_be_typed() {
    let folder = folder("readme-mentioned");
    for command in commands().iter().chain(&mentioned()) {
        // What comes before `--help` is read first: an option that is gone is found.
        let mut arguments = borrowed(command);
        arguments.push("--help");
        let said = run(&folder, &arguments);
        assert_eq!(said.code, Some(0), "letoff {}: {}", command.join(" "), said.err);
    }
}

/// The parts of scenes, between fences that say so.
fn parts_of_scenes() -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let text = fs::read_to_string(path).expect("the README");
    let parts = text.split("```toml\n").skip(1);
    let parts: Vec<_> =
        parts.filter_map(|it| it.split_once("```")).map(|(part, _)| part.to_owned()).collect();
    assert!(!parts.is_empty(), "the README shows scenes");
    parts
}

#[test]
fn every_part_of_a_scene_is_a_good_one() {
    let folder = folder("readme-scenes");
    for (number, part) in parts_of_scenes().iter().enumerate() {
        let keys = "[[keys]]\nrange = \"A0..C8\"\ninstrument = \"grand-springs\"\n";
        let given = if part.contains("[[keys]]") { "" } else { keys };
        let name = format!("part-{number}.toml");
        fs::write(folder.join(&name), format!("{given}\n{part}")).expect("a scene");
        let said = run(&folder, &["check", &name]);
        assert_eq!(said.code, Some(0), "{}{}{part}", said.out, said.err);
    }
}

#[test]
fn every_simulation_runs_as_it_stands() {
    let folder = folder("readme-simulations");
    let stroke = "t,s\n0,0\n0.25,0.01\n0.5,0.02\n0.75,0.01\n1,0\n";
    fs::write(folder.join("stroke.csv"), stroke).expect("a stroke");
    for command in commands().iter().filter(|it| it[0] == "simulate") {
        let said = run(&folder, &borrowed(command));
        assert_eq!(said.code, Some(0), "letoff {}: {}", command.join(" "), said.err);
    }
}

#[test]
fn the_events_of_figure_6_are_those_that_stand_there() {
    let folder = folder("readme-events");
    let commands = commands();
    let command = commands.iter().find(|it| it.iter().any(|word| word == "figure6.svg"));
    let said = run(&folder, &borrowed(command.expect("the stroke of figure 6")));
    assert_eq!(said.code, Some(0), "{}", said.err);
    let written = fs::read_to_string(folder.join("events.csv")).expect("events");

    let lines = lines();
    let shown: Vec<_> = lines.iter().skip_while(|line| *line != "t,guard,from,to").collect();
    let shown = shown[1..].iter().take_while(|line| !line.starts_with("```"));
    let mut count = 0;
    for (shown, written) in shown.zip(written.lines().skip(1)) {
        let (t, what) = shown.split_once(',').expect("columns");
        let (seen, rest) = written.split_once(',').expect("columns");
        // Another libm moves an event by a rounding or two.
        let apart = t.parse::<f64>().expect("a time") - seen.parse::<f64>().expect("a time");
        assert!(apart.abs() < 1e-13, "{shown}, and now {seen}");
        assert!(rest.starts_with(what), "{shown}, and now {rest}");
        count += 1;
    }
    assert_eq!(count, 5);
}
