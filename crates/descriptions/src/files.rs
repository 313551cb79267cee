//! The files of descriptions: on the disk, or kept in a recording.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// Longest file that is read (bytes).
const LONGEST: u64 = 1 << 18;

/// The contents of files that are known without the disk, by their absolute paths.
static KEPT: Mutex<BTreeMap<PathBuf, Arc<[u8]>>> = Mutex::new(BTreeMap::new());

/// Returns `path` from the root on, as it is written otherwise.
pub(crate) fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_unknown| path.to_owned())
}

/// Makes `text` what this process reads at `path` from now on, whatever stands on the disk: a
/// recording is run again with the descriptions in it.
pub fn keep_file(path: &Path, text: &str) {
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    kept.insert(absolute(path), text.as_bytes().into());
}

/// The contents of a file: kept, or read from the disk.
///
/// # Errors
/// Why it cannot be read, and what to do.
pub(crate) fn read_bytes(path: &Path) -> Result<Vec<u8>, (String, &'static str)> {
    let kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner).get(&absolute(path)).cloned();
    if let Some(bytes) = kept {
        return Ok(bytes.to_vec());
    }
    let failed = |error: std::io::Error| {
        if error.kind() == std::io::ErrorKind::NotFound {
            ("there is no such file".to_owned(), "correct the path")
        } else {
            (format!("the file cannot be read, {error}"), "make it readable")
        }
    };
    let bytes = diagnostics::read_input(path, LONGEST).map_err(failed)?;
    if bytes.len() as u64 > LONGEST {
        let message = format!("the file is longer than {} KiB", LONGEST / 1024);
        return Err((message, "this is no description, choose another"));
    }
    Ok(bytes)
}

/// The text of the file that a mistake is in, as far as it can be read.
pub(crate) fn text_of(file: &str) -> Option<String> {
    String::from_utf8(read_bytes(Path::new(file)).ok()?).ok()
}

/// What stood in the files of a description when they were read; nothing in one that could not be.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct FileContents(Vec<(PathBuf, Option<Vec<u8>>)>);

impl FileContents {
    /// Returns what stands in the same files now.
    #[must_use]
    pub fn now(&self) -> Self {
        let now =
            |(path, _before): &(PathBuf, Option<Vec<u8>>)| (path.clone(), read_bytes(path).ok());
        Self(self.0.iter().map(now).collect())
    }

    /// Returns whether the files say what they said.
    pub fn is_current(&self) -> bool {
        self.0.iter().all(|(path, before)| read_bytes(path).ok() == *before)
    }

    /// Returns whether a file cannot be read that could be `before`.
    pub fn lacks_one_of(&self, before: &Self) -> bool {
        self.0.iter().zip(&before.0).any(|(now, before)| now.1.is_none() && before.1.is_some())
    }

    /// Returns the absolute path and the text of each file that could be read.
    pub fn texts(&self) -> Vec<(PathBuf, String)> {
        let text = |(path, bytes): &(PathBuf, Option<Vec<u8>>)| {
            let text = String::from_utf8_lossy(bytes.as_deref()?).into_owned();
            Some((absolute(path), text))
        };
        self.0.iter().filter_map(text).collect()
    }
}

/// Reads the files of one description, and remembers what stood in them.
#[derive(Debug, Default)]
pub struct DescriptionFiles(RefCell<FileContents>);

impl DescriptionFiles {
    /// Returns the contents of the file at `path`.
    ///
    /// # Errors
    /// Why it cannot be read.
    pub fn read(&self, path: &Path) -> Result<Vec<u8>, String> {
        self.read_or_help(path).map_err(|(message, _help)| message)
    }

    pub(crate) fn read_or_help(&self, path: &Path) -> Result<Vec<u8>, (String, &'static str)> {
        let read = read_bytes(path);
        self.0.borrow_mut().0.push((path.to_owned(), read.as_ref().ok().cloned()));
        read
    }

    pub(crate) fn into_contents(self) -> FileContents {
        self.0.into_inner()
    }
}
