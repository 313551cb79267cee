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
const MAY_KNOW: [(&str, &[&str]); 22] = [
    ("keyboard", &[]),
    ("diagnostics", &[]),
    ("pode", &[]),
    ("haptics", &[]),
    ("xtask", &[]),
    ("firmware-protocol", &["keyboard"]),
    ("midi", &["keyboard"]),
    ("scheduler", &["keyboard"]),
    ("telemetry", &["keyboard"]),
    ("models", &["pode"]),
    ("kane", &["diagnostics", "pode"]),
    ("links", &["firmware-protocol", "keyboard"]),
    ("hardware", &["firmware-protocol", "haptics", "keyboard", "links", "scheduler"]),
    ("performance", &["haptics", "keyboard", "midi"]),
    ("realtime", &["keyboard", "scheduler"]),
    ("scene", &SCENE_MAY_KNOW),
    ("voice", &["firmware-protocol", "haptics", "models", "pode", "scene", "scheduler"]),
    ("lab", &["diagnostics", "haptics", "kane", "keyboard", "models", "performance", "pode"]),
    ("dashboard", &["telemetry"]),
    ("host", &HOST_MAY_KNOW),
    // The command, and tests/ and benches/ of the source-less root package, may know all.
    ("cli", &EVERYONE),
    ("letoff", &EVERYONE),
];

const SCENE_MAY_KNOW: [&str; 9] = [
    "diagnostics",
    "firmware-protocol",
    "haptics",
    "hardware",
    "keyboard",
    "links",
    "midi",
    "models",
    "pode",
];

const HOST_MAY_KNOW: [&str; 16] = [
    "diagnostics",
    "firmware-protocol",
    "haptics",
    "hardware",
    "kane",
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

const EVERYONE: [&str; 22] = [
    "cli",
    "dashboard",
    "diagnostics",
    "firmware-protocol",
    "haptics",
    "hardware",
    "host",
    "kane",
    "keyboard",
    "lab",
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
    let text = fs::read_to_string(manifest).expect("a manifest");
    let document: Document<String> = text.parse().expect("valid TOML");
    let name = document["package"]["name"].as_str().expect("a name").to_owned();
    let ours = ["dependencies", "dev-dependencies", "build-dependencies"]
        .iter()
        .filter_map(|kind| document.get(kind).and_then(Item::as_table_like))
        .flat_map(|table| table.iter().map(|(key, _)| key.to_owned()).collect::<Vec<_>>())
        .filter(|key| EVERYONE.contains(&key.as_str()))
        .collect();
    (name, ours)
}
