use std::path::{Path, PathBuf};

use mechanism::kane::derive_model;
use mechanism::kane::description::Bases;

/// Bases: descriptions in one folder, and shipped ones by their names.
pub(crate) struct Folder;

impl Bases for Folder {
    fn load(&self, base: &str, _from: &str) -> Result<(String, Vec<u8>), String> {
        let file = files().into_iter().find(|file| {
            let text = std::fs::read_to_string(file).unwrap_or_default();
            text.starts_with(&format!("name = \"{base}\"")) || file.ends_with(base)
        });
        let file = file.ok_or("there is none")?;
        let bytes = std::fs::read(&file).map_err(|error| error.to_string())?;
        Ok((file.display().to_string(), bytes))
    }
}

pub(crate) fn files() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut all = Vec::new();
    for folder in ["configs/models", "crates/mechanism/tests/kane/actions"] {
        for entry in std::fs::read_dir(root.join(folder)).expect("a folder") {
            all.push(entry.expect("an entry").path());
        }
    }
    for entry in std::fs::read_dir(root.join("crates/instruments/src")).expect("a folder") {
        let file = entry.expect("an entry").path().join("model.toml");
        if file.exists() {
            all.push(file);
        }
    }
    all.retain(|file| file.extension().is_some_and(|it| it == "toml"));
    all.sort();
    all
}

#[test]
fn every_description_becomes_a_program() {
    let mut wrong = Vec::new();
    for file in files() {
        let text = std::fs::read_to_string(&file).unwrap();
        let began = std::time::Instant::now();
        match derive_model(&file.display().to_string(), &text, &Folder) {
            Ok(model) => {
                let tapes = model.program.tapes();
                let instructions: usize = tapes.iter().map(|it| it.instructions.len()).sum();
                println!(
                    "{}: {} modes, {} functions, {instructions} instructions, {} nodes, {:?}",
                    model.program.table.name,
                    model.program.table.modes.len(),
                    tapes.len(),
                    model.system.mechanism.graph.len(),
                    began.elapsed(),
                );
            }
            Err(mistakes) => wrong.push(mistakes.to_string()),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
