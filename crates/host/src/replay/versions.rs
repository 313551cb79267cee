use std::{collections::BTreeMap, path::Path, sync::Arc};

use instruments::LoadedModel;
use scene::Library;
use telemetry::{Catalogue, Voice};

use super::ReplayError;

#[derive(Clone, Debug, Default)]
pub(super) struct RecordedVersions {
    /// Reads the recorded texts, without the disk.
    pub(super) library: Library,
    models: BTreeMap<u32, Arc<LoadedModel>>,
}

impl RecordedVersions {
    /// Reads the new descriptions of `catalogue` from its texts, whatever the files contain now.
    pub(super) fn learn(&mut self, catalogue: &Catalogue) -> Result<(), ReplayError> {
        for description in &catalogue.descriptions {
            if self.models.contains_key(&description.version) {
                continue;
            }
            let Some(first) = description.files.first() else { continue };
            for file in &description.files {
                self.library.keep_file(Path::new(&file.path), &file.text);
            }
            let read = self.library.load(Path::new(&first.path));
            let model = read.map_err(|wrong| ReplayError::Scene(wrong.to_string()))?;
            self.models.insert(description.version, model);
        }
        Ok(())
    }

    pub(super) fn model(&self, voice: &Voice) -> Result<Arc<LoadedModel>, ReplayError> {
        let found = match voice.version {
            0 => self.library.find(&voice.model, Path::new("")).ok(),
            version => self.models.get(&version).cloned(),
        };
        found.ok_or_else(|| {
            ReplayError::Voice(format!("there is no model {:?} in this version", voice.model))
        })
    }
}
