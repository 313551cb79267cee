//! Writes files that are complete or missing.

use std::path::{Path, PathBuf};
use std::{fs, io};

use documents::shown;

/// A file or folder that could not be written, with the cause.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}: {cause}", shown(path))]
pub struct DiskError {
    pub path: PathBuf,
    pub cause: io::Error,
}

pub(super) fn prepare(folder: &Path) -> Result<(), DiskError> {
    let fail = |cause| DiskError { path: folder.to_owned(), cause };
    fs::create_dir_all(folder).map_err(fail)?;
    let probe = folder.join(".letoff-lab");
    fs::write(&probe, "").and_then(|()| fs::remove_file(&probe)).map_err(fail)
}

pub(super) fn write(path: &Path, text: &str) -> Result<(), DiskError> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".part");
    let part = path.with_file_name(name);
    let written = fs::write(&part, text).and_then(|()| fs::rename(&part, path));
    written.map_err(|cause| DiskError { path: path.to_owned(), cause })
}
