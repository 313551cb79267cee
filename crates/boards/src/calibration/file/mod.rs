//! Calibration on the disk: a file for each board.
//!
//! TOML, to be read by people and not to be edited: a checksum over all values makes a file
//! that was changed or cut be refused with a sentence.

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

/// Returns where the files of this user are.
pub fn usual_folder() -> Option<PathBuf> {
    let set = |name: &str| std::env::var_os(name).filter(|it| !it.is_empty()).map(PathBuf::from);
    let base = set("XDG_CONFIG_HOME").or_else(|| Some(set("HOME")?.join(".config")))?;
    Some(base.join("letoff/calibration"))
}

/// Returns the file of the board with this id.
pub fn path(folder: &Path, uid: Uid) -> PathBuf {
    folder.join(format!("{uid}.toml"))
}

/// Reads the file of a board of `n_keys` keys; nothing if there is none.
///
/// # Errors
/// All that is wrong with the file, a sentence on each line.
pub fn read(
    path: &Path,
    uid: Uid,
    n_keys: usize,
) -> Result<Option<PerKey<KeyCalibration>>, String> {
    let whole = |sheet: CalibrationSheet| sheet.keys.as_slice().iter().copied().collect();
    let keys: Option<Option<Vec<_>>> = load(path, uid, n_keys)?.map(whole);
    Ok(keys.flatten().map(PerKey::collect))
}
