//! A recording, run again: the same voices on the same samples, compared to the last bit.
//!
//! ```text
//! recording ─▶ Feed: samples, lateness, voices of each tick ─▶ Scheduler ─▶ Tap ─▶ Pump
//!     └──────────────── messages ──────────▶ Comparison ◀────────── messages ─────────┘
//! ```
//!
//! What decided in the run is in the recording: which ticks were run, what sensors said and how
//! old it was, which lane was late, when a voice was put in or retuned, when voices were
//! disarmed. All else follows, and is made again by the code that made it.

mod agreement;
mod compare;
mod damage;
mod feed;
mod lanes;
mod run;
mod versions;

pub use agreement::{ForceDifference, ResumedTicks};
pub use compare::ReplayDifference;
pub use damage::MissingTicks;
pub use run::{Replayed, replay};

/// The reason why a recording cannot be run again.
#[derive(Debug, thiserror::Error)]
pub enum ReplayError {
    /// There is no catalogue.
    #[error(
        "the recording has no catalogue, so nobody knows what was run: it can only be looked at"
    )]
    NoCatalogue,
    /// It began later than the run.
    #[error(
        "the recording begins at tick {0}, in the middle of a run, and what its voices were like \
         then is not in it: it can be looked at, but only a run that was recorded from its \
         beginning (`letoff record`) can be run again"
    )]
    Middle(u64),
    /// Its beginning is damaged.
    #[error(
        "{0}; how the run began is among what is lost, so it cannot be run again, only looked at"
    )]
    Beginning(String),
    /// Its scene is of another time.
    #[error("the scene in the recording is not understood by this version: {0}")]
    Scene(String),
    /// A voice cannot be built.
    #[error("a voice of the recording cannot be built: {0}")]
    Voice(String),
    /// The recording cannot be read.
    #[error("{0}")]
    Read(String),
}
