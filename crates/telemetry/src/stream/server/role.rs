//! What somebody may do.

use serde::{Deserialize, Serialize};

use crate::Request;

/// What somebody may do; each may do what those before may.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Watches.
    Viewer,
    /// Changes how keys feel.
    Tuner,
    /// Stops, and writes files.
    Owner,
}

impl Role {
    /// Who may ask for `request`, at least.
    pub const fn for_request(request: &Request) -> Self {
        match request {
            Request::Set { .. }
            | Request::UseInstrument { .. }
            | Request::Press { .. }
            | Request::Identify { .. } => Self::Tuner,
            Request::Stop {} | Request::Scene {} | Request::Where {} | Request::Record { .. } => {
                Self::Owner
            }
        }
    }

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Viewer => "viewer",
            Self::Tuner => "tuner",
            Self::Owner => "owner",
        }
    }

    /// Whether it may ask for `request`.
    ///
    /// # Errors
    /// If not; a sentence.
    pub fn check(self, request: &Request) -> Result<(), String> {
        let needed = Self::for_request(request);
        if self >= needed {
            return Ok(());
        }
        Err(format!(
            "a {} may not do this: connect with a token of the role {}",
            self.name(),
            needed.name()
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_viewer_only_watches_and_only_an_owner_stops() {
        let set = Request::Set { changes: vec![] };
        let refused = "a viewer may not do this: connect with a token of the role tuner";
        assert_eq!(Role::Viewer.check(&set), Err(refused.to_owned()));
        assert_eq!(Role::Tuner.check(&set), Ok(()));
        assert_eq!(Role::Owner.check(&set), Ok(()));
        assert!(Role::Tuner.check(&Request::Stop {}).is_err());
        assert_eq!(Role::Owner.check(&Request::Stop {}), Ok(()));
    }
}
