//! Tells scenes, instruments and descriptions of models by the names in the file.

use std::path::Path;

use serde::Serialize;

use super::source::SourceText;
use documents::Diagnostics;
use documents::toml::{SourcePlace, TomlNode};

/// Names that only a scene has.
const SCENE: [&str; 10] =
    ["tick_hz", "lanes", "realtime", "budget", "render", "rig", "keys", "links", "midi", "pianist"];

/// Names that only an instrument has.
const INSTRUMENT: [&str; 9] =
    ["doc", "model", "preset", "offline", "stable", "parameters", "figures", "fidelity", "program"];

/// Names that only the description of a model has.
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

/// The kind of a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FileKind {
    Scene,
    Instrument,
    /// The description of a model.
    Model,
}

impl FileKind {
    /// Returns its name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Instrument => "instrument",
            Self::Model => "model",
        }
    }
}

/// Returns whether the file at `path` is the description of a model, by what stands in it.
pub fn is_description(path: &Path) -> bool {
    SourceText::read(path).is_ok_and(|source| describes_model(&source))
}

/// Returns whether `source` is the description of a model.
pub(super) fn describes_model(source: &SourceText) -> bool {
    kind_of(source) == Ok(FileKind::Model)
}

/// Returns the kind of which `source` has more names.
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
    // The check of the file reports again what is no TOML.
    match kind {
        Some(kind) => Ok(kind),
        None => report.verdict(None),
    }
}
