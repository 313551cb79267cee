//! Distinguishes scenes, instruments and descriptions of models by the names in the file.

use std::path::Path;

use serde::Serialize;

use super::source::SourceText;
use documents::Diagnostics;
use documents::toml::{SourcePlace, TomlNode};

const SCENE: [&str; 10] =
    ["tick_hz", "lanes", "realtime", "budget", "render", "rig", "keys", "links", "midi", "pianist"];

// A description has a base, too: that name alone decides for a description.
const INSTRUMENT: [&str; 12] = [
    "base_hash",
    "base_values",
    "differences",
    "doc",
    "model",
    "preset",
    "offline",
    "stable",
    "parameters",
    "figures",
    "fidelity",
    "program",
];

const DESCRIPTION: [&str; 23] = [
    "base",
    "bodies",
    "constraints",
    "contacts",
    "coordinates",
    "damper",
    "definitions",
    "drawing",
    "felts",
    "forces",
    "frames",
    "frictions",
    "gravity",
    "input",
    "modes",
    "outputs",
    "points",
    "presets",
    "rates",
    "remove",
    "rest",
    "speeds",
    "springs",
];

/// Kind of a file, by its contents.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FileKind {
    Scene,
    Instrument,
    Model,
    Piece,
}

impl FileKind {
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Instrument => "instrument",
            Self::Model => "model",
            Self::Piece => "piece",
        }
    }
}

/// Returns `true` if the file at `path` is the description of a model, by its contents.
pub fn is_description(path: &Path) -> bool {
    SourceText::read(path).is_ok_and(|source| describes_model(&source))
}

pub(super) fn describes_model(source: &SourceText) -> bool {
    kind_of(source) == Ok(FileKind::Model)
}

/// Returns the kind with the most names in `source`.
pub(super) fn kind_of(source: &SourceText) -> Result<FileKind, Diagnostics> {
    let (mut report, root) = source.parsed(&[]);
    let entries = root.as_ref().and_then(TomlNode::entries).unwrap_or_default();
    let count = |names: &[&str]| {
        entries.iter().filter(|entry| names.contains(&entry.name.as_str())).count()
    };
    let kind = match (count(&SCENE), count(&INSTRUMENT), count(&DESCRIPTION)) {
        (0, 0, 0) => {
            let help = "a scene has [[keys]], an instrument a model, a description [modes]";
            let message = "this is neither a scene nor an instrument nor a model";
            report.miss(SourcePlace::default(), message, help);
            None
        }
        (scene, instrument, model) if scene.max(instrument) < model => Some(FileKind::Model),
        (scene, instrument, _) if instrument <= scene => Some(FileKind::Scene),
        _ => Some(FileKind::Instrument),
    };
    // The check of the file reports TOML errors again.
    match kind {
        Some(kind) => Ok(kind),
        None => report.verdict(None),
    }
}
