//! Writer of a calibration file: whole or not at all, with the old one beside it.

use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use super::CalibrationSheet;
use crate::Error;

/// Returns the path of the previous file of `path`.
pub fn backup(path: &Path) -> PathBuf {
    beside(path, ".bak")
}

/// Returns the path of measured keys that do not make up a complete file at `path`.
pub fn partial(path: &Path) -> PathBuf {
    beside(path, ".partial")
}

/// Writes `sheet` to `path`, and creates its folder; on any failure the old file remains. The old
/// file is kept, see [`backup`].
pub fn write(path: &Path, sheet: &CalibrationSheet) -> Result<(), Error> {
    let written = replace(path, sheet.render().as_bytes());
    written.map_err(|source| Error::Unwritable { path: path.to_owned(), source })
}

fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let part = beside(path, ".part");
    let mut file = File::create(&part)?;
    file.write_all(bytes)?;
    // A file renamed before it is on the disk may be empty after a power cut.
    file.sync_all()?;
    match fs::copy(path, backup(path)) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
        Ok(_) | Err(_) => {}
    }
    fs::rename(part, path)
}

fn beside(path: &Path, more: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(more);
    name.into()
}
