//! The files of a model.

use std::path::{Path, PathBuf};

/// The files and the version of a model's description.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ModelSource {
    /// Absolute path of the description.
    pub file: String,
    /// Number of the version in the order of reading, from 1.
    pub version: u32,
    /// Contents of its files, the description first, then its bases.
    pub contents: FileContents,
}

/// Contents of a description's files when they were read; `None` for an unreadable one.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct FileContents(pub Vec<(PathBuf, Option<Vec<u8>>)>);

impl FileContents {
    #[must_use]
    pub fn read_again(&self, read: &dyn Fn(&Path) -> Option<Vec<u8>>) -> Self {
        Self(self.0.iter().map(|(path, _before)| (path.clone(), read(path))).collect())
    }

    /// Returns `true` if a file that was readable `before` is not readable now.
    pub fn lacks_one_of(&self, before: &Self) -> bool {
        self.0.iter().zip(&before.0).any(|(now, before)| now.1.is_none() && before.1.is_some())
    }

    /// Returns the absolute path and the text of each readable file.
    pub fn texts(&self) -> Vec<(PathBuf, String)> {
        let absolute = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let text = |(path, bytes): &(PathBuf, Option<Vec<u8>>)| {
            let text = String::from_utf8_lossy(bytes.as_deref()?).into_owned();
            Some((absolute(path), text))
        };
        self.0.iter().filter_map(text).collect()
    }
}
