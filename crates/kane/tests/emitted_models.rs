//! The models of the program are the Rust that their descriptions give today.

use std::path::PathBuf;

use kane::derive_model;

use crate::shipped::{Folder, files};

/// The Rust that stands beside a description, and what it gives; none that is not of the program.
fn emitted(file: &PathBuf) -> Option<(PathBuf, String)> {
    let beside = file.with_file_name("emitted.rs");
    if !file.ends_with("model.toml") {
        return None;
    }
    let text = std::fs::read_to_string(file).expect("a description");
    let model = derive_model(&file.display().to_string(), &text, &Folder);
    let model = model.unwrap_or_else(|mistakes| panic!("{mistakes}"));
    Some((beside, model.rust()))
}

/// `EMIT=1 cargo test -p kane emitted_models` writes the files anew.
#[test]
fn every_model_of_the_program_is_what_its_description_gives() {
    let mut stale = Vec::new();
    for (path, text) in files().iter().filter_map(emitted) {
        if std::env::var_os("EMIT").is_some() {
            std::fs::write(&path, &text).expect("a folder of the models");
        }
        if std::fs::read_to_string(&path).unwrap_or_default() != text {
            stale.push(path);
        }
    }
    assert!(stale.is_empty(), "not what is emitted today: {stale:?}");
}
