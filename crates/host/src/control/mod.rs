//! Requests to a running host: one JSON object a line over a Unix socket, or by its stream.
//!
//! ```text
//! letoff instruments use NAME ──socket──▶ server ─┐
//! dashboard ──WebSocket──▶ telemetry::stream ─────┴▶ RequestHandler ─▶ RunHandle ──ring──▶ lanes
//! ```
//!
//! [`RequestHandler`] checks a request and builds what it needs, off the tick: a voice for another
//! instrument, an array of values for other parameters. [`RunHandle`] sends it to the run. The
//! tick puts it in between two ticks, and safety blends the new force in.
//!
//! A description that is saved while it plays, or asked for, is read, checked, derived and compiled
//! on the same side (`load`, `watch`): if it is right, voices of the new version go on where those
//! of the old one are, and if it is wrong nothing changes but what is told of it.
//!
//! Settings of `[render]` change the same way (`render_settings`): they are tried first, and voices
//! that are computed by them go on where the others are.
//!
//! A scene is read again at SIGHUP (`reload`): what can change live does, the same way.
//!
//! A program change that is heard on a MIDI port is a request for an instrument (`programs`).
//!
//! `letoff stop` comes the same way: the run ends with the next tick, and boards are stopped.
//! The socket listens before keys are tried and touches rehearsed (`starting`), so that a host that only
//! prepares is stopped too.

mod background;
mod client;
mod current_voices;
mod description_states;
mod emergency;
mod fingers;
mod folders;
mod key_port;
mod load;
mod lower_fidelity;
mod new_voice;
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
pub use stream_sink::StreamSink;
pub use watch::watch_descriptions;

pub use telemetry::{Reply, Request};

/// The answer to one request: what was done, or in a sentence why nothing was.
pub type Answer = Result<Reply, String>;

/// The refusal of a host that is being prepared, or has ended.
const NOT_RUNNING: &str = "the host is not running yet, or not any more";
