//! Tells scenes from instruments by the names in the file.

use std::path::Path;

use serde::Serialize;

use super::document;
use super::instrument::Instrument;
use super::report::{Location, MistakeList};
use super::scene::Scene;
use super::source::SourceText;
use diagnostics::Diagnostics;

/// Names that only a scene has.
const SCENE: [&str; 7] = ["tick_hz", "lanes", "render", "keys", "links", "midi", "pianist"];

/// Names that only an instrument has.
const INSTRUMENT: [&str; 6] = ["doc", "model", "preset", "offline", "stable", "parameters"];

/// The kind of a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FileKind {
    Scene,
    Instrument,
}

impl FileKind {
    /// Returns its name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Instrument => "instrument",
        }
    }
}

/// Checks the scene or instrument at `path`, whichever it is by what stands in it.
///
/// # Errors
///
/// All that is wrong with it, or that it is neither.
pub fn check_file(path: &Path) -> Result<FileKind, Diagnostics> {
    check(&SourceText::read(path)?)
}

/// Checks a text as [`check_file`] does.
pub(super) fn check(source: &SourceText) -> Result<FileKind, Diagnostics> {
    let kind = kind_of(source)?;
    match kind {
        FileKind::Scene => Scene::check(source, &[]).map(|_scene| kind),
        FileKind::Instrument => Instrument::check(source).map(|_instrument| kind),
    }
}

/// Returns the kind of which `source` has more names.
fn kind_of(source: &SourceText) -> Result<FileKind, Diagnostics> {
    let mut report = MistakeList::new(source, &[]);
    let root = document::parse(&mut report);
    let entries = root.as_ref().and_then(document::Node::entries).unwrap_or_default();
    let count = |names: &[&str]| {
        entries.iter().filter(|entry| names.contains(&entry.name.as_str())).count()
    };
    let kind = match (count(&SCENE), count(&INSTRUMENT)) {
        (0, 0) => {
            let help = "a scene has [[keys]], an instrument has a model";
            report.miss(Location::At(0), "this is neither a scene nor an instrument", help);
            None
        }
        (scene, instrument) if instrument <= scene => Some(FileKind::Scene),
        _ => Some(FileKind::Instrument),
    };
    // The check of the file reports again what is no TOML.
    match kind {
        Some(kind) => Ok(kind),
        None => report.verdict(None),
    }
}
