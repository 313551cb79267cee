//! Versions of descriptions that a recording contains.

use std::collections::BTreeMap;
use std::path::Path;

use descriptions::{find_model, keep_file, load_model};
use models::catalogue::ModelEntry;
use telemetry::{Catalogue, Voice};

use super::ReplayError;

/// The versions of descriptions that were told of, by their numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct RecordedVersions(BTreeMap<u32, &'static ModelEntry>);

impl RecordedVersions {
    /// Reads the descriptions of `catalogue` that are not known yet, from the texts in it: whatever
    /// stands in files of the same names now is not looked at.
    pub(super) fn learn(&mut self, catalogue: &Catalogue) -> Result<(), ReplayError> {
        for description in &catalogue.descriptions {
            if self.0.contains_key(&description.version) {
                continue;
            }
            let Some(first) = description.files.first() else { continue };
            for file in &description.files {
                keep_file(Path::new(&file.path), &file.text);
            }
            let read = load_model(Path::new(&first.path));
            let model = read.map_err(|wrong| ReplayError::Scene(wrong.to_string()))?;
            self.0.insert(description.version, model);
        }
        Ok(())
    }

    /// Returns the model of a recorded voice.
    pub(super) fn model(&self, voice: &Voice) -> Result<&'static ModelEntry, ReplayError> {
        let found = match voice.version {
            0 => find_model(&voice.model, Path::new("")).ok(),
            version => self.0.get(&version).copied(),
        };
        found.ok_or_else(|| {
            ReplayError::Voice(format!("there is no model {:?} in this version", voice.model))
        })
    }
}
