//! What can be wrong at set-up, as sentences for the operator.

use std::io;
use std::path::PathBuf;

/// Why something could not be set up.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The tick's period is not one that boards can keep.
    #[error("a tick of {period} s is not possible; give a period above 0 and up to 1 s")]
    Period {
        /// What was asked for [s].
        period: f64,
    },
    /// The system refused to list its serial ports.
    #[error("the system does not list its serial ports: {0}")]
    SerialPorts(#[from] serialport::Error),
    /// A folder or file of the system could not be read.
    #[error("{path} cannot be read: {source}")]
    Unreadable {
        /// Which one.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
}
