//! What a running host is asked for: one JSON object a line over a Unix socket, or by its stream.
//!
//! ```text
//! letoff instruments use NAME ──socket──▶ server ── Switchboard ──ring──▶ lanes, between ticks
//! dashboard ──WebSocket──▶ telemetry::stream ─────────┘
//! ```
//!
//! `letoff stop` comes the same way: the run ends with the next tick, and boards are stopped.
//!
//! A request is checked and its voices are built here, off the tick; the tick only swaps
//! finished voices, and safety blends their forces in.

mod client;
mod patchbay;
mod server;
mod stream;
mod switchboard;
mod tuning;

pub use client::{ControlError, send};
pub use patchbay::{Lights, Lit, Patchbay};
pub use server::{Clients, Server, serve};
pub use stream::{StreamSink, Studio};
pub use switchboard::Switchboard;

use std::path::PathBuf;

pub use telemetry::{Reply, Request};

/// What the host answers to one line: what was done, or in a sentence why nothing was.
pub type Answer = Result<Reply, String>;

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
