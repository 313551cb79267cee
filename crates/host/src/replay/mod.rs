//! A recording, run again: the same voices on the same samples, compared to the last bit.
//!
//! ```text
//! recording ─▶ Feed: samples, lateness, voices of each tick ─▶ Scheduler ─▶ TickRecorder
//!     │                                                                           ▼
//!     └──────────────── messages ──────────▶ Comparison ◀── messages ── TelemetryThread
//! ```
//!
//! The recording contains all inputs of the run: the ticks that ran, samples and their age, late
//! lanes, changed voices, disarming. The code computes the rest again. A replay ends at a hole of a
//! damaged recording, since the state of the voices behind it is not recorded.

mod compare;
mod feed;
mod lanes;
mod run;
mod versions;

pub use compare::ReplayDifference;
pub use run::{Replayed, replay};

/// Reason why a recording cannot be replayed.
#[derive(Debug, thiserror::Error)]
pub enum ReplayError {
    #[error("the recording has no catalogue, which names what was run: it can only be exported")]
    NoCatalogue,
    /// The recording began later than the run.
    #[error(
        "the recording begins at tick {0}, in the middle of a run, without the state of its voices: \
         it can be exported, but only a run that was recorded from its beginning (`letoff record`) \
         can be replayed"
    )]
    Middle(u64),
    #[error("{0}; the run's beginning is lost, so the recording can be exported, but not replayed")]
    Beginning(String),
    #[error("the scene in the recording is not understood by this version: {0}")]
    Scene(String),
    #[error("a voice of the recording cannot be built: {0}")]
    Voice(String),
    #[error("{0}")]
    Read(String),
}
