mod any_input;
mod edited;
mod fidelity;
mod mistakes;
mod shipped;
mod values;

use mechanism::Library;
use std::fs;
use std::path::{Path, PathBuf};

use documents::Diagnostics;

use super::source::SourceText;
use super::*;

const MINIMAL: &str = "[[keys]]\nrange = \"A0..C8\"\ninstrument = \"grand-springs\"\n";

/// Model with the paper's parameters below middle C, a grand from there on.
const TWO_RANGES: &str = "[[keys]]
range = \"A0..B3\"
model = \"key-hammer-springs\"
preset = \"paper\"
[[keys]]
range = \"C4..C8\"
instrument = \"grand-springs\"
[keys.parameters]
k1 = 400
";

fn source(text: &str) -> SourceText {
    SourceText::from_bytes(Path::new("scene.toml"), text.as_bytes().to_vec()).unwrap()
}

fn owned(overrides: &[(&str, &str)]) -> Vec<Override> {
    let owned = overrides.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned()));
    owned.map(Override::from).collect()
}

#[track_caller]
fn load(text: &str, overrides: &[(&str, &str)]) -> Scene {
    Scene::check(&Library::default(), &source(text), &owned(overrides))
        .unwrap_or_else(|all| panic!("{all}"))
}

struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("letoff-{test}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn write(&self, name: &str, bytes: &[u8]) -> String {
        let path = self.0.join(name);
        fs::write(&path, bytes).unwrap();
        path.to_str().unwrap().to_owned()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.0));
    }
}
