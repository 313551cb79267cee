use std::{fmt, path::PathBuf};

/// Reason why an existing device cannot be used; a sentence when displayed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Obstacle {
    Forbidden {
        path: PathBuf,
        /// The group that may, if any.
        group: Option<String>,
    },
    Down {
        /// Command that brings it up.
        command: String,
    },
    /// The interface is up, but carries no frames.
    NotRunning { name: String },
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Forbidden { path, group: Some(group) } => write!(
                f,
                "you may not read and write {}; join the group {group}: \
                 sudo usermod -aG {group} $USER, then log in again",
                path.display()
            ),
            Self::Forbidden { path, group: None } => {
                write!(f, "you may not read and write {}; only its owner may", path.display())
            }
            Self::Down { command } => write!(f, "the interface is down; bring it up: {command}"),
            Self::NotRunning { name } => write!(
                f,
                "{name} is up but carries no frames; see its state: \
                 ip -details link show {name}"
            ),
        }
    }
}
