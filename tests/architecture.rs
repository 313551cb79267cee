//! Who may know whom: the crate graph of ARCHITECTURE.md, read from the manifests.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use toml_edit::{Document, Item};

/// Every crate of ours with the crates of ours that it may depend on.
///
/// Crates that design.md names but that are not there yet are listed too, so that
/// their first commit is held to the same rule.
const MAY_KNOW: [(&str, &[&str]); 29] = [
    ("keyboard", &[]),
    ("diagnostics", &[]),
    ("pode", &[]),
    ("haptics", &[]),
    ("xtask", &[]),
    ("firmware-protocol", &["keyboard"]),
    ("midi", &["diagnostics", "keyboard"]),
    ("scheduler", &["keyboard"]),
    ("telemetry", &["diagnostics", "keyboard"]),
    ("contacts", &["pode"]),
    ("equations", &["contacts", "pode"]),
    // What it hands out is read from descriptions, which its tests do.
    ("models", &["contacts", "descriptions", "equations", "pode"]),
    ("descriptions", &["diagnostics", "kane", "models", "native"]),
    ("expressions", &["equations", "pode"]),
    ("formulas", &["diagnostics", "expressions"]),
    ("kane", &KANE_MAY_KNOW),
    ("native", &["equations", "expressions", "pode"]),
    ("links", &["firmware-protocol"]),
    (
        "hardware",
        &["diagnostics", "firmware-protocol", "haptics", "keyboard", "links", "scheduler"],
    ),
    ("performance", &["haptics", "keyboard", "midi"]),
    ("realtime", &["scheduler"]),
    ("scene", &SCENE_MAY_KNOW),
    ("voice", &VOICE_MAY_KNOW),
    ("lab", &LAB_MAY_KNOW),
    ("impedance", &["descriptions", "haptics", "lab", "models", "pode"]),
    ("dashboard", &["telemetry"]),
    ("host", &HOST_MAY_KNOW),
    // The command, and tests/ and benches/ of the source-less root package, may know all.
    ("cli", &EVERYONE),
    ("letoff", &EVERYONE),
];

const KANE_MAY_KNOW: [&str; 6] =
    ["contacts", "diagnostics", "equations", "expressions", "formulas", "pode"];

const LAB_MAY_KNOW: [&str; 7] =
    ["descriptions", "diagnostics", "expressions", "formulas", "haptics", "models", "pode"];

const VOICE_MAY_KNOW: [&str; 8] = [
    "descriptions",
    "equations",
    "firmware-protocol",
    "haptics",
    "models",
    "pode",
    "scene",
    "scheduler",
];

const SCENE_MAY_KNOW: [&str; 13] = [
    "descriptions",
    "diagnostics",
    "firmware-protocol",
    "formulas",
    "haptics",
    "hardware",
    "keyboard",
    "links",
    "midi",
    "models",
    "performance",
    "pode",
    "scheduler",
];

const HOST_MAY_KNOW: [&str; 16] = [
    "descriptions",
    "diagnostics",
    "firmware-protocol",
    "haptics",
    "hardware",
    "keyboard",
    "links",
    "midi",
    "models",
    "performance",
    "pode",
    "realtime",
    "scene",
    "scheduler",
    "telemetry",
    "voice",
];

const EVERYONE: [&str; 29] = [
    "cli",
    "contacts",
    "dashboard",
    "descriptions",
    "diagnostics",
    "equations",
    "expressions",
    "firmware-protocol",
    "formulas",
    "haptics",
    "hardware",
    "host",
    "impedance",
    "kane",
    "keyboard",
    "lab",
    "links",
    "midi",
    "models",
    "native",
    "performance",
    "pode",
    "realtime",
    "scene",
    "scheduler",
    "telemetry",
    "voice",
    "xtask",
    "letoff",
];

#[test]
fn every_crate_knows_only_whom_it_may() {
    for manifest in manifests() {
        let (name, ours) = read(&manifest);
        let (_, allowed) = MAY_KNOW
            .iter()
            .find(|(known, _)| *known == name)
            .unwrap_or_else(|| panic!("{name} is not in the graph: add it to MAY_KNOW"));
        for dependency in ours {
            assert!(
                allowed.contains(&dependency.as_str()),
                "{name} must not depend on {dependency}"
            );
        }
    }
}

#[test]
fn the_graph_in_architecture_md_names_every_crate() {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    for manifest in manifests() {
        let (name, ours) = read(&manifest);
        if name == "letoff" {
            continue;
        }
        assert!(text.contains(&format!("`{name}`")), "ARCHITECTURE.md does not name {name}");
        for dependency in ours {
            let edge = format!("{name} -> {dependency}");
            assert!(text.contains(&edge), "ARCHITECTURE.md does not draw {edge}");
        }
    }
}

#[test]
fn every_dependency_is_used() {
    for manifest in manifests() {
        let folder = manifest.parent().expect("its folder");
        let product = sources(&folder.join("src"));
        let tests = ["tests", "benches", "examples"].map(|it| sources(&folder.join(it))).concat();
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

/// The manifests of the root and of every member.
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

/// A package's name, and those of its dependencies of any kind that are ours.
fn read(manifest: &Path) -> (String, Vec<String>) {
    let name = parse(manifest)["package"]["name"].as_str().expect("a name").to_owned();
    let all = dependencies(manifest).into_iter().map(|(_, name)| name);
    (name, all.filter(|name| EVERYONE.contains(&name.as_str())).collect())
}

fn parse(manifest: &Path) -> Document<String> {
    fs::read_to_string(manifest).expect("a manifest").parse().expect("valid TOML")
}

/// The dependencies of a package with their kind, those for some targets only as well.
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

/// All Rust below `folder`, one file after the other; nothing if there is no such folder.
fn sources(folder: &Path) -> String {
    let entries = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
    let text = |path: PathBuf| {
        if path.is_dir() {
            sources(&path)
        } else if path.extension().is_some_and(|it| it == "rs") {
            fs::read_to_string(path).expect("a source")
        } else {
            String::new()
        }
    };
    entries.map(|entry| text(entry.path())).collect()
}

/// Whether `text` has `word`, not as a part of a longer one.
fn names(text: &str, word: &str) -> bool {
    text.split(|letter: char| !letter.is_alphanumeric() && letter != '_').any(|it| it == word)
}
