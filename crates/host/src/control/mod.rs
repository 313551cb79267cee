//! Requests to a running host: one JSON object per line over a Unix socket, or by its stream.
//!
//! ```text
//! letoff instruments use NAME ──socket──▶ server ─┐
//! dashboard ──WebSocket──▶ telemetry::stream ─────┴▶ RequestHandler ─▶ RunHandle ──ring──▶ lanes
//! ```
//!
//! [`RequestHandler`] checks a request and builds its voice or its array of values off the tick.
//! [`RunHandle`] sends it to the run. The scheduler puts it in between two ticks, and safety blends
//! the new force in.
//!
//! | module | source of changes |
//! |---|---|
//! | `load`, `watch` | descriptions: voices of a new version continue from the old ones' states |
//! | `render_settings` | settings of `[render]`: tried first, then applied like a new version |
//! | `reload` | the scene, at SIGHUP: the parts that can change live |
//! | `programs` | MIDI program changes, as requests for an instrument |
//!
//! A mistake changes nothing and is reported. The socket listens before keys are tried and touches
//! rehearsed (`starting`), so that `letoff stop` also ends a host in preparation.

mod background;
mod client;
mod current_voices;
mod description_states;
mod emergency;
mod figures_of_key;
mod fingers;
mod folders;
mod key_port;
mod load;
mod lower_fidelity;
mod new_voice;
mod own_instruments;
pub(crate) mod place;
mod programs;
mod reload;
mod render_settings;
mod repeated_look;
mod request_handler;
mod run_handle;
mod run_status;
mod server;
mod starting;
mod status_publisher;
mod stream_sink;
mod voice_port;
mod watch;

pub use background::BackgroundWork;
pub use client::{
    AskedHost, ControlError, end_command, hold, hosts_elsewhere, send, send_to_host, send_within,
    stop_hosts,
};
pub(crate) use current_voices::is_absent;
pub use emergency::{BoardsTold, EmergencyStop};
pub use fingers::{FingerOwner, FingerQueue};
pub use folders::Folders;
pub use key_port::{IdentifyTarget, Lights};
pub use lower_fidelity::follow_load;
pub use place::{socket_path, temporary_folder};
pub use programs::ProgramListener;
pub use repeated_look::RepeatedLook;
pub use request_handler::{RequestHandler, StreamAddress};
pub use run_handle::RunHandle;
pub(crate) use run_status::passes;
pub use run_status::{RunDescription, RunStatus, StatusSink};
pub use server::{Answers, Clients, ControlServer, serve};
pub use starting::{STARTING, StartingHost};
pub use status_publisher::StatusPublisher;
pub use stream_sink::StreamSink;
pub use watch::watch_descriptions;

pub use telemetry::{Reply, Request};

/// The answer to one request: the change, or a sentence why nothing changed.
pub type Answer = Result<Reply, String>;

/// Refusal of a host that is being prepared or has ended.
const NOT_RUNNING: &str = "the host is not running yet, or not any more";
