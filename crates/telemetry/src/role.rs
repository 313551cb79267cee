use serde::{Deserialize, Serialize};

/// Rights of a client; each role includes those before it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Watches, and may remove all forces.
    Viewer,
    Tuner,
    /// Writes files, and reads the scene.
    Owner,
}

impl Role {
    /// Returns the role's name in a file of tokens.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Viewer => "viewer",
            Self::Tuner => "tuner",
            Self::Owner => "owner",
        }
    }

    pub(crate) fn named(name: &str) -> Option<Self> {
        [Self::Viewer, Self::Tuner, Self::Owner].into_iter().find(|role| role.name() == name)
    }
}
