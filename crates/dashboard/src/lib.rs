//! The window: keys, scopes, mechanisms and sliders of a host, live or recorded.
//!
//! It knows [`telemetry`] and nothing else of ours: everything it shows comes through a
//! [`telemetry::Source`], everything it wants goes out as a [`telemetry::Request`].
//!
//! | folder | what stands there |
//! |---|---|
//! | [`store`] | what has arrived, as much of it as is kept |
//! | [`tune`] | parameters that are tuned: shown, asked for, taken back |
//! | [`scope`] | what a scope shows, and when it holds still |
//! | `panels` | one file for each panel: what it remembers, and how it is drawn |
//! | [`app`] | the window around them |
//! | [`source_thread`] | a live source on its own thread, so that a still keyboard costs no frames |
//! | [`demonstration`] | a recorded take in a loop: a source without a host |
//!
//! Nothing here knows a key's physics, waits, or reads a clock that it was not given.

#![forbid(unsafe_code)]

pub mod app;
mod app_state;
mod demonstration;
mod fault_text;
mod layout;
pub mod names;
mod number;
pub mod open;
mod panels;
pub mod scope;
pub mod source_thread;
pub mod store;
mod theme;
mod triangulate;
pub mod tune;
mod unit;

use std::sync::Arc;
use std::time::Duration;

pub use app::{App, SavedWindow};
pub use demonstration::demonstration;
pub use panels::Pane;

/// A clock of the system's time (ns since 1970).
pub type WallClock = Arc<dyn Fn() -> u64 + Send + Sync>;

/// Called from any thread when something has arrived: how soon it is worth a frame.
pub type RepaintWaker = Arc<dyn Fn(Duration) + Send + Sync>;

/// Returns a clock of the system's time (ns since 1970).
pub fn wall_clock() -> WallClock {
    Arc::new(|| {
        let since = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
        since.map_or(0, |it| u64::try_from(it.as_nanos()).unwrap_or(u64::MAX))
    })
}
