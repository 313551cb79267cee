//! The process that holds the MIDI port and the notes, and outlives the host.
//!
//! ```text
//!  host                                        letoff midi-guardian PATH
//!  MIDI thread ─▶ GuardedOutput ─ lines of JSON, by a socket ─▶ NoteGuardian ─▶ port
//!                      ▲  hello, messages, a beat every 50 ms       │
//!                      └────── opened, beats, finished ◀────────────┘
//! ```
//!
//! Without a host, or a beat for half a second, the guardian ends its notes. Its socket is beside
//! the control socket: a restarted host finds it there with the port and its connections.

mod channel;
mod guarded_output;
mod guardian_process;
mod protocol;

use std::path::PathBuf;

pub use channel::program;
pub(crate) use guarded_output::{GuardedOutput, GuardianReport, GuardianTrouble};
pub use guardian_process::attend;
pub(crate) use protocol::GuardedPort;

use crate::control::socket_path;

pub fn guardian_path() -> PathBuf {
    let mut path = socket_path().into_os_string();
    path.push(".midi");
    path.into()
}
