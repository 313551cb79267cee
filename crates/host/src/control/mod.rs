//! Switching instruments on a running host: one JSON object a line over a Unix socket.
//!
//! ```text
//! letoff instruments use NAME ──socket──▶ server ── Switchboard ──ring──▶ lanes, between ticks
//! ```
//!
//! `letoff stop` comes the same way: the run ends with the next tick, and boards are stopped.
//!
//! A request is checked and its voices are built here, off the tick; the tick only swaps
//! finished voices, and safety blends their forces in.

mod client;
mod patchbay;
mod server;
mod switchboard;

pub use client::{ControlError, send};
pub use patchbay::Patchbay;
pub use server::{Clients, Server, serve};
pub use switchboard::Switchboard;

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

/// What a client asks for.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// An instrument's name or file.
    pub instrument: String,
    /// Which keys, as `C4..B5`; all without.
    pub keys: Option<String>,
}

/// All that a client may ask for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Wish {
    /// Another instrument.
    Switch(Request),
    /// An end, at once.
    Stop(Stop),
}

impl Wish {
    /// Reads one line.
    fn parse(line: &str) -> serde_json::Result<Self> {
        let value: serde_json::Value = serde_json::from_str(line)?;
        if value.get("stop").is_some() {
            serde_json::from_value(value).map(Self::Stop)
        } else {
            serde_json::from_value(value).map(Self::Switch)
        }
    }
}

/// An end, at once: boards are told to render no force until they are seen to.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stop {
    /// What kind of end.
    pub stop: StopKind,
}

/// What kind of end.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StopKind {
    /// No force on any key from the next tick on.
    Emergency,
}

/// What the host answers.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reply {
    /// Voices are on their way to so many keys.
    Switched(usize),
    /// All forces are taken away with the next tick, and the run ends.
    Stopped,
    /// Nothing was changed; why, in a sentence.
    Refused(String),
}

/// Where a host of this user listens: where `LETOFF_SOCKET` says, in the runtime directory,
/// or else beside other temporary files, in a folder of the user's own.
pub fn socket_path() -> PathBuf {
    if let Some(path) = std::env::var_os("LETOFF_SOCKET") {
        return path.into();
    }
    let runtime = std::env::var_os("XDG_RUNTIME_DIR").map(PathBuf::from);
    let folder = runtime.filter(|folder| folder.is_dir()).unwrap_or_else(|| {
        let user = rustix::process::getuid().as_raw();
        std::env::temp_dir().join(format!("letoff-{user}"))
    });
    folder.join("letoff.sock")
}
