//! Calibration on the disk: a file for each board.
//!
//! TOML, not to be edited by people: a checksum over all values detects changed or cut files.

mod read;
mod sheet;
#[cfg(test)]
mod tests;
mod write;

use std::path::{Path, PathBuf};

use firmware_protocol::key::PerKey;

use super::KeyCalibration;
use crate::identity::Uid;

pub use read::{load, load_partial};
pub use sheet::CalibrationSheet;
pub use write::{backup, partial, write};

pub fn usual_folder() -> Option<PathBuf> {
    let set = |name: &str| std::env::var_os(name).filter(|it| !it.is_empty()).map(PathBuf::from);
    let base = set("XDG_CONFIG_HOME").or_else(|| Some(set("HOME")?.join(".config")))?;
    Some(base.join("letoff/calibration"))
}

pub fn path(folder: &Path, uid: Uid) -> PathBuf {
    folder.join(format!("{uid}.toml"))
}

/// Reads the file of a board of `n_keys` keys; `None` if there is none.
///
/// # Errors
/// All faults of the file, a sentence on each line.
pub fn read(
    path: &Path,
    uid: Uid,
    n_keys: usize,
) -> Result<Option<PerKey<KeyCalibration>>, String> {
    let whole = |sheet: CalibrationSheet| sheet.keys.as_slice().iter().copied().collect();
    let keys: Option<Option<Vec<_>>> = load(path, uid, n_keys)?.map(whole);
    Ok(keys.flatten().map(PerKey::collect))
}
