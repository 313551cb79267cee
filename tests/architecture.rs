//! No crate depends on a higher one, and some on nearly none: read from the manifests.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use toml_edit::{Document, Item};

use crate::sources::rust_files;

const FLOORS: &str = "keyboard documents pode haptics firmware-protocol scheduler midi telemetry \
    instruments mechanism boards pianist scene engine figures host cli lab dashboard xtask letoff";

/// Crates that may depend only on these of ours, with the reason.
const KNOWS_ONLY: [(&str, &str, &str); 10] = [
    ("keyboard documents pode haptics xtask", "", "each can be used alone"),
    ("firmware-protocol", "keyboard", "firmware compiles it"),
    ("scheduler", "keyboard", "the tick, without a clock and without equations"),
    ("midi telemetry", "documents keyboard", "they have no forces, and viewers compile them"),
    ("instruments", "pode", "equations without their origin"),
    ("mechanism", "documents instruments pode", "equations know no keys, ticks or wires"),
    ("boards", "documents firmware-protocol haptics keyboard scheduler", "wires decide no force"),
    ("pianist", "haptics keyboard midi", "the host lends it a rehearsal"),
    (
        "engine",
        "firmware-protocol haptics instruments pode scene scheduler",
        "a voice knows no wires and no MIDI",
    ),
    ("dashboard", "telemetry", "it sees what any client sees"),
];

fn lists(words: &str, word: &str) -> bool {
    words.split(' ').any(|it| it == word)
}

#[test]
fn no_crate_knows_a_higher_one() {
    for manifest in manifests() {
        let (name, ours) = read(&manifest);
        let floor = |it: &str| FLOORS.split(' ').position(|known| known == it);
        let own = floor(&name).unwrap_or_else(|| panic!("{name} is in no floor: add it to FLOORS"));
        for dependency in ours {
            assert!(floor(&dependency) < Some(own), "{name} must not depend on {dependency}");
        }
    }
}

#[test]
fn documents_are_short() {
    let short = [("README.md", 8_000), ("ARCHITECTURE.md", 20_000), ("CONTRIBUTING.md", 10_000)];
    for (name, most) in short {
        let length = fs::metadata(root().join(name)).expect("a document").len();
        assert!(length <= most, "{name} has {length} bytes of {most}");
    }
}

#[test]
fn walls_between_crates_stand() {
    for manifest in manifests() {
        let (name, ours) = read(&manifest);
        for (_, only, why) in KNOWS_ONLY.iter().filter(|(names, ..)| lists(names, &name)) {
            let other = ours.iter().find(|it| !lists(only, it));
            assert_eq!(other, None, "{name} knows only {only:?}: {why}");
        }
    }
}

#[test]
fn few_crates_each_with_its_readme_and_its_line_in_architecture_md() {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let manifests: Vec<_> =
        manifests().into_iter().filter(|it| *it != root().join("Cargo.toml")).collect();
    let crates = manifests.iter().filter(|it| it.starts_with(root().join("crates"))).count();
    assert!(crates <= 19, "{crates} crates under crates/: merge two");
    for manifest in manifests {
        let (name, _) = read(&manifest);
        assert!(text.contains(&format!("`{name}`")), "ARCHITECTURE.md does not name {name}");
        let readme = fs::read_to_string(manifest.with_file_name("README.md")).unwrap_or_default();
        let lines = readme.lines().count();
        assert!((10..=60).contains(&lines), "the README of {name} has {lines} lines of 10 to 60");
    }
}

#[test]
fn every_dependency_is_used() {
    for manifest in manifests() {
        let folder = manifest.parent().expect("its folder");
        let product = text_below(&folder.join("src"));
        let tests =
            ["tests", "benches", "examples"].map(|it| text_below(&folder.join(it))).concat();
        for (kind, name) in dependencies(&manifest) {
            let word = name.replace('-', "_");
            let is_used =
                names(&product, &word) || kind.starts_with("dev-") && names(&tests, &word);
            assert!(is_used, "no source of {} uses {name}: remove it", manifest.display());
        }
    }
}

#[test]
fn every_shared_dependency_is_inherited() {
    let inherited: BTreeSet<String> =
        manifests().iter().flat_map(|it| dependencies(it)).map(|(_, name)| name).collect();
    let root = parse(&root().join("Cargo.toml"));
    let shared = root["workspace"]["dependencies"].as_table_like().expect("a table");
    for (name, _) in shared.iter() {
        assert!(inherited.contains(name), "no crate depends on {name}: remove it");
    }
}

#[test]
fn every_dependency_has_a_reason() {
    let text = fs::read_to_string(root().join("Cargo.toml")).expect("Cargo.toml");
    let others = text.split("# Others'").nth(1).expect("the section of others' crates");
    let section = others.split("[workspace.lints").next().unwrap_or_default();
    for line in section.lines().filter(|line| line.contains(" = ")) {
        assert!(line.contains(" # "), "no reason beside: {line}");
    }
}

#[test]
fn the_top_level_is_what_the_design_says() {
    let folders: BTreeSet<String> = fs::read_dir(root())
        .expect("the root")
        .filter_map(Result::ok)
        .filter(|entry| entry.path().is_dir())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|name| !name.starts_with('.') && name != "target")
        .collect();
    let expected = ["benches", "configs", "crates", "firmware-protocol", "tests"];
    assert_eq!(folders, expected.map(String::from).into());
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn manifests() -> Vec<PathBuf> {
    let members = fs::read_dir(root().join("crates")).expect("crates/");
    let mut paths: Vec<_> = members
        .filter_map(Result::ok)
        .map(|entry| entry.path().join("Cargo.toml"))
        .filter(|path| path.exists())
        .collect();
    paths.push(root().join("firmware-protocol/Cargo.toml"));
    paths.push(root().join("Cargo.toml"));
    paths
}

/// Returns a package's name, and those of its dependencies that are ours; its tests may use more.
fn read(manifest: &Path) -> (String, Vec<String>) {
    let name = parse(manifest)["package"]["name"].as_str().expect("a name").to_owned();
    let all = dependencies(manifest).into_iter().filter(|(kind, _)| !kind.starts_with("dev-"));
    (name, all.map(|(_, it)| it).filter(|it| lists(FLOORS, it)).collect())
}

fn parse(manifest: &Path) -> Document<String> {
    fs::read_to_string(manifest).expect("a manifest").parse().expect("valid TOML")
}

fn dependencies(manifest: &Path) -> Vec<(&'static str, String)> {
    let document = parse(manifest);
    let targets = document.get("target").and_then(Item::as_table_like);
    let targets = targets.iter().flat_map(|table| table.iter()).map(|(_, target)| target);
    let tables: Vec<_> = [document.as_item()].into_iter().chain(targets).collect();
    let of_kind = |kind: &'static str| {
        let tables = tables.iter().filter_map(move |it| it.get(kind)?.as_table_like());
        tables.flat_map(move |table| table.iter().map(move |(key, _)| (kind, key.to_owned())))
    };
    ["dependencies", "dev-dependencies", "build-dependencies"]
        .into_iter()
        .flat_map(of_kind)
        .collect()
}

fn text_below(folder: &Path) -> String {
    let read = |path: PathBuf| fs::read_to_string(path).expect("a source");
    rust_files(folder).into_iter().map(read).collect()
}

fn names(text: &str, word: &str) -> bool {
    text.split(|letter: char| !letter.is_alphanumeric() && letter != '_').any(|it| it == word)
}
