//! The window: keys, scopes, mechanisms and sliders of a host, live or recorded.
//!
//! All data comes from a [`telemetry::Source`], and each request is a [`telemetry::Request`].
//!
//! | folder | contents |
//! |---|---|
//! | [`store`] | the arrivals, up to a bound |
//! | [`tune`] | tuned parameters: shown, requested, undone |
//! | [`scope`] | contents of a scope, and its trigger |
//! | `panels` | one file for each panel: saved state and drawing |
//! | [`app`] | the window around them |
//! | [`source_thread`] | a live source on its own thread, so that a resting keyboard costs no frames |
//! | [`demonstration`] | a recorded take in a loop: a source without a host |
//!
//! Nothing here knows a key's physics, waits, or reads a clock other than the given one.

#![forbid(unsafe_code)]

pub mod app;
mod app_state;
mod demonstration;
mod fault_text;
mod grid;
mod layout;
pub mod names;
mod number;
pub mod open;
mod panels;
pub mod scope;
mod source_state;
pub mod source_thread;
pub mod store;
mod theme;
mod toast;
mod triangulate;
pub mod tune;
mod unit;

use std::{sync::Arc, time::Duration};

pub use app::{App, SavedWindow};
pub use demonstration::demonstration;
pub use panels::Pane;

/// Clock of the system's time (ns since 1970).
pub type WallClock = Arc<dyn Fn() -> u64 + Send + Sync>;

/// Callback from any thread for an arrival, with the time within which to draw a frame.
pub type RepaintWaker = Arc<dyn Fn(Duration) + Send + Sync>;

/// Returns a clock of the system's time (ns since 1970).
pub fn wall_clock() -> WallClock {
    Arc::new(|| {
        let since = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
        since.map_or(0, |it| u64::try_from(it.as_nanos()).unwrap_or(u64::MAX))
    })
}
