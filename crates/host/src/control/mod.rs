//! What a running host is asked for: one JSON object a line over a Unix socket, or by its stream.
//!
//! ```text
//! letoff instruments use NAME ──socket──▶ server ── Switchboard ──ring──▶ lanes, between ticks
//! dashboard ──WebSocket──▶ telemetry::stream ─────────┘
//! ```
//!
//! `letoff stop` comes the same way: the run ends with the next tick, and boards are stopped.
//! The socket is there before anything is rehearsed, so that a host is stopped that only begins.
//!
//! A request is checked and its voices are built here, off the tick; the tick only swaps
//! finished voices, and safety blends their forces in.

mod client;
mod emergency;
mod fingers;
mod folders;
mod patchbay;
mod place;
mod server;
mod stream;
mod switchboard;
mod tuning;

pub use client::{ControlError, send, send_within};
pub use emergency::{BoardsTold, EmergencyStop};
pub use fingers::{Connection, FingerQueue};
pub use folders::Folders;
pub use patchbay::{IdentifyTarget, Lights, RunHandle};
pub use place::socket_path;
pub use server::{Answers, Clients, ControlServer, serve};
pub use stream::{RequestHandler, StreamSink};
pub use switchboard::VoiceSwitcher;

pub use telemetry::{Reply, Request};

/// What the host answers to one line: what was done, or in a sentence why nothing was.
pub type Answer = Result<Reply, String>;
