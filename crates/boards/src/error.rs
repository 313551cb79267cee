//! Errors at set-up, as sentences for the operator.

use std::{io, path::PathBuf};

use documents::shown;

/// Reason why a set-up failed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("a tick of {period} s is not possible; give a period above 0 and up to 1 s")]
    Period {
        /// Requested period (s).
        period: f64,
    },
    #[error(
        "a board of {n_keys} keys from key {first} on is not possible; \
         give 1 to 12 keys, all within the 88"
    )]
    BoardKeys {
        /// The lowest key, `0 ..= 87`.
        first: u8,
        n_keys: usize,
    },
    #[error("{} cannot be written: {source}; see to the folder and its rights", shown(.path))]
    Unwritable { path: PathBuf, source: io::Error },
}
