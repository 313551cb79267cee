//! Every README and manual of the project: its commands run and print the shown output, its links
//! and paths lead to files, and its lines have one sentence each.

use std::fs;
use std::path::{Path, PathBuf};

use crate::letoff::{folder, run};

const DOCUMENTS: &str =
    "README BOARDS CONTACTS FIGURE6 GUIDE HARD IMPEDANCE LANGUAGE MANUAL STABILITY";

struct Document {
    path: PathBuf,
    text: String,
}

impl Document {
    /// Returns the lines; those that end with a backslash are joined with the next.
    fn lines(&self) -> Vec<String> {
        self.text.replace("\\\n", " ").lines().map(str::to_owned).collect()
    }

    fn quoted(&self) -> Vec<String> {
        let lines = self.lines();
        let quoted = lines.iter().flat_map(|line| line.split('`').skip(1).step_by(2));
        quoted.map(str::to_owned).collect()
    }

    fn prose(&self) -> Vec<&str> {
        let mut is_code = false;
        let mut prose = Vec::new();
        for line in self.text.lines() {
            let is_fence = line.starts_with("```");
            is_code ^= is_fence;
            if !is_code && !is_fence && !line.starts_with('|') && !line.starts_with("    ") {
                prose.push(line);
            }
        }
        prose
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn documents() -> Vec<Document> {
    let mut paths = Vec::new();
    let mut folders = vec![root().to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file")) {
            let name = entry.file_name().into_string().expect("a name in UTF-8");
            let is_folder = entry.file_type().expect("a kind of file").is_dir();
            if is_folder && name != "target" && !name.starts_with('.') {
                folders.push(entry.path());
            } else if name
                .strip_suffix(".md")
                .is_some_and(|it| DOCUMENTS.split(' ').any(|known| known == it))
            {
                paths.push(entry.path());
            }
        }
    }
    paths.sort();
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("a README");
        Document { path, text }
    };
    let all: Vec<_> = paths.into_iter().map(read).collect();
    for path in ["", "configs", "firmware-protocol", "crates/pode", "crates/dashboard"] {
        let path = root().join(path).join("README.md");
        assert!(all.iter().any(|it| it.path == path), "{} is missing", path.display());
    }
    all
}

/// Returns the words of a command behind `letoff`; quotes keep a word together.
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

fn commands() -> Vec<Vec<String>> {
    let lines: Vec<_> = documents().iter().flat_map(Document::lines).collect();
    let all: Vec<_> =
        lines.iter().filter(|line| line.starts_with("letoff ")).map(|it| words(it)).collect();
    assert!(all.len() >= 12, "the READMEs show commands: {all:?}");
    all
}

fn mentioned() -> Vec<Vec<String>> {
    let quoted: Vec<_> = documents().iter().flat_map(Document::quoted).collect();
    let mentioned = quoted.iter().filter(|it| it.starts_with("letoff "));
    let all: Vec<_> = mentioned.map(|it| words(&it.replace(['[', ']', '…'], ""))).collect();
    assert!(all.len() >= 40, "the READMEs mention commands: {all:?}");
    all
}

fn borrowed(words: &[String]) -> Vec<&str> {
    words.iter().map(String::as_str).collect()
}

#[test]
fn every_command_can_be_typed() {
    let folder = folder("readme-mentioned");
    for command in commands().iter().chain(&mentioned()) {
        // Arguments before `--help` are parsed first: an option that no longer exists is found.
        let mut arguments = borrowed(command);
        arguments.push("--help");
        let said = run(&folder, &arguments);
        assert_eq!(said.code, Some(0), "letoff {}: {}", command.join(" "), said.err);
    }
}

/// Returns the parts of scenes, between fences that say so; those in LANGUAGE.md are descriptions
/// of models, which `mechanism` tests.
fn parts_of_scenes() -> Vec<String> {
    let of_scenes = |document: &Document| !document.path.ends_with("crates/mechanism/LANGUAGE.md");
    let documents = documents().into_iter().filter(of_scenes);
    let texts: Vec<_> = documents.map(|document| document.text).collect();
    let parts = texts.iter().flat_map(|text| text.split("```toml\n").skip(1));
    let parts: Vec<_> =
        parts.filter_map(|it| it.split_once("```")).map(|(part, _)| part.to_owned()).collect();
    assert!(parts.len() >= 2, "the READMEs show scenes");
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
    let mentioned = mentioned().into_iter().filter(|it| it.iter().any(|word| word == "--until"));
    for command in commands().into_iter().chain(mentioned).filter(|it| it[0] == "simulate") {
        let said = run(&folder, &borrowed(&command));
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

    let lines: Vec<_> = documents().iter().flat_map(Document::lines).collect();
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

fn command(parts: &[&str]) -> Vec<String> {
    let has = |command: &Vec<String>| parts.iter().all(|part| command.iter().any(|it| it == part));
    mentioned().into_iter().find(has).expect("the command")
}

fn first_event(parts: &[&str]) -> Vec<String> {
    let folder = folder("readme-limits");
    let command = command(parts);
    let mut arguments = borrowed(&command);
    arguments.extend(["--events", "first.csv"]);
    let said = run(&folder, &arguments);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let written = fs::read_to_string(folder.join("first.csv")).expect("events");
    let first = written.lines().nth(1).expect("an event");
    first.split(',').map(str::to_owned).collect()
}

#[test]
fn the_limits_of_the_geometry_are_those_that_stand_there() {
    // The hammer's pivot is beyond the slider: it hangs.
    let arguments = command(&["key-hammer-springs", "L3=0.2"]);
    let said = run(&folder("readme-hangs"), &borrowed(&arguments));
    assert!(said.out.contains("0 events"), "{}", said.out);
    assert!(said.out.contains("mode B2, theta_h = -1.570796e0"), "{}", said.out);

    // The hammer's line has no end: it lands 0.30 m from P2, at the hammer's angle.
    let event = first_event(&["key-hammer-rigid", "L2=0.2"]);
    assert_eq!(event[1], "land");
    let angle = event[6].parse::<f64>().expect("an angle");
    let (l1, l3) = (0.4, 0.1);
    assert!(((l1 - l3) / angle.cos() - 0.30).abs() < 0.005, "{event:?}");
}

#[test]
fn every_link_leads_to_a_file() {
    let mut count = 0;
    for document in documents() {
        let folder = document.path.parent().expect("a folder");
        let links = document.text.split("](").skip(1).filter_map(|it| it.split_once(')'));
        for (link, _) in links.filter(|(link, _)| !link.contains("://")) {
            assert!(folder.join(link).exists(), "{} links {link}", document.path.display());
            count += 1;
        }
    }
    assert!(count >= 30, "{count} links");
}

#[test]
fn every_path_from_the_root_exists() {
    let folders = ["benches/", "configs/", "crates/", "firmware-protocol/"];
    for document in documents() {
        for path in document.quoted() {
            let is_path = folders.iter().any(|folder| path.starts_with(folder));
            if is_path && !path.contains(['*', ' ', '…']) && !path.contains("YOUR") {
                assert!(root().join(&path).exists(), "{}: {path}", document.path.display());
            }
        }
    }
}

fn words_behind(before: &str) -> Vec<(PathBuf, String, String)> {
    let mut found = Vec::new();
    for document in documents() {
        for line in document.lines() {
            for (at, _) in line.match_indices(before) {
                let rest = &line[at + before.len()..];
                let word: String = rest
                    .chars()
                    .take_while(|it| it.is_alphanumeric() || "-_".contains(*it))
                    .collect();
                found.push((document.path.clone(), line.clone(), word));
            }
        }
    }
    found
}

#[test]
fn every_chore_and_example_exists() {
    let usage = root().join("crates/xtask/src/arguments.rs");
    let usage = fs::read_to_string(usage).expect("the chores");
    let chores = words_behind("cargo xtask ");
    assert!(chores.len() >= 5, "{chores:?}");
    for (path, _, chore) in chores {
        let listed = format!("  cargo xtask {chore}");
        assert!(usage.contains(&listed), "{} names {chore}", path.display());
    }
    let examples = words_behind("--example ");
    assert!(examples.len() >= 3, "{examples:?}");
    for (path, line, example) in examples {
        let (_, package) = line.split_once(" -p ").expect("a package");
        let package = package.split(' ').next().expect("a package");
        let file = root().join("crates").join(package).join(format!("examples/{example}.rs"));
        assert!(file.exists(), "{} names {}", path.display(), file.display());
    }
}

#[test]
fn every_line_has_one_sentence() {
    for document in documents() {
        for line in document.prose() {
            let ends = line.match_indices(". ").filter(|(at, _)| {
                let (before, behind) = (&line[..*at], &line[at + 2..]);
                let number = before.trim_start().parse::<u32>().is_ok();
                !number && behind.starts_with(|it: char| it.is_uppercase() || it == '`')
            });
            assert_eq!(ends.count(), 0, "{}: {line}", document.path.display());
        }
    }
}

#[test]
fn the_figures_of_the_first_page_are_those_of_pode() {
    let documents = documents();
    let text = |folder: &str| {
        let path = root().join(folder).join("README.md");
        documents.iter().find(|it| it.path == path).map(|it| it.text.as_str()).expect("a README")
    };
    let (_, figures) = text("").split_once("<!-- figures: begin").expect("figures");
    let (figures, _) = figures.split_once("<!-- figures: end").expect("their end");
    let rows = figures.lines().filter(|line| line.starts_with('|')).skip(2);
    let figures: Vec<_> = rows.filter_map(|row| row.rsplit('|').nth(1)).map(str::trim).collect();
    assert_eq!(figures.len(), 2);
    for figure in figures {
        assert!(text("crates/pode").contains(figure), "crates/pode/README.md lacks {figure}");
    }
}
