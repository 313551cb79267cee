use std::{collections::BTreeMap, path::Path};

use instruments::{FileContents, ModelEntry};
use telemetry::Description;

#[derive(Clone, Debug, Default)]
pub(super) struct DescriptionStates {
    files: BTreeMap<String, ReadDescription>,
    /// Start times of versions that the scene did not begin with (ns since 1970).
    since: BTreeMap<u32, u64>,
    pub(super) is_watched: bool,
}

#[derive(Clone, Debug)]
struct ReadDescription {
    contents: FileContents,
    mistakes: String,
}

impl DescriptionStates {
    pub(super) fn note_read(&mut self, file: &str, contents: FileContents, mistakes: &str) {
        let read = ReadDescription { contents, mistakes: mistakes.to_owned() };
        self.files.insert(file.to_owned(), read);
    }

    pub(super) fn note_playing(&mut self, model: &ModelEntry, now: u64) {
        if let Some(source) = &model.source {
            self.since.insert(source.version, now);
        }
    }

    pub(super) fn contents(&self, model: &ModelEntry) -> Option<FileContents> {
        let source = model.source.as_ref()?;
        let read = self.files.get(&source.file);
        Some(read.map_or(&source.contents, |read| &read.contents).clone())
    }

    pub(super) fn complete(&self, descriptions: &mut [Description]) {
        for description in descriptions {
            let path = description.files.first().map_or("", |file| file.path.as_str());
            let read = self.files.get(path);
            description.mistakes = read.map_or_else(String::new, |read| read.mistakes.clone());
            description.since = self.since.get(&description.version).copied().unwrap_or(0);
            description.watched = self.is_watched;
        }
    }
}

/// Returns the path by which the file `name` is known.
pub(super) fn known_path(name: &str) -> String {
    let path = std::path::absolute(name).unwrap_or_else(|_unknown| Path::new(name).to_owned());
    path.to_string_lossy().into_owned()
}
