//! The command's end: one request, one reply.

use std::io::{self, BufRead as _, BufReader, Write as _};
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::{Answer, Request};

/// Longest time that a host is waited for.
const PATIENCE: Duration = Duration::from_secs(5);

/// Why there was no reply.
#[derive(Debug, thiserror::Error)]
pub enum ControlError {
    /// Nobody listens.
    #[error("no host is running here ({path}): start one with `letoff run`", path = .path.display())]
    NoHost {
        /// Where it was looked for.
        path: PathBuf,
    },
    /// The host went away or did not answer.
    #[error("the host did not answer: {0}")]
    Silent(#[from] io::Error),
    /// Somebody else answered.
    #[error("what answered is no host of this version: {0}")]
    Foreign(#[from] serde_json::Error),
}

/// Sends `request` to the host at `path` and waits for its reply.
///
/// # Errors
/// If there is no host, or it does not answer within seconds.
pub fn send(path: &Path, request: &Request) -> Result<Answer, ControlError> {
    let mut stream = UnixStream::connect(path)
        .map_err(|_nobody| ControlError::NoHost { path: path.to_owned() })?;
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let mut text = serde_json::to_string(request)?;
    text.push('\n');
    stream.write_all(text.as_bytes())?;
    let mut line = String::new();
    BufReader::new(stream).read_line(&mut line)?;
    Ok(serde_json::from_str(&line)?)
}
