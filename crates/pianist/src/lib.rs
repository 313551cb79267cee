//! The virtual pianist: finger strokes from a MIDI file.
//!
//! ```text
//! bytes ── score::read ──▶ Score ── stroke::plan ──▶ strokes of each key
//!                                                        │ rehearse: which gesture gives
//!                                                        ▼ this hammer speed at this time?
//!        Assessment ◀── assess ── what was struck    Performance
//! ```
//!
//! Hammers are thrown, not placed: a stroke's effect depends on the action and on the state of the
//! key. So each stroke is rehearsed by simulation from the state that its key will have, until it
//! gives the wanted velocity and onset.
//! This crate contains no instrument: the host supplies one as a [`Rehearsal`].
//! Times are `f64` seconds since the start of the performance.

#![forbid(unsafe_code)]

mod align;
pub mod assess;
mod kept;
pub mod pianist;
pub mod rehearse;
pub mod score;
pub mod stroke;

pub use assess::{
    Assessment, Assessor, Damped, Deviation, DeviationKind, ExpectedNote, Spread, Struck, WINDOW,
    assess,
};
pub use pianist::{CutNote, Performance, Pianist, Progress, ShortStroke};
pub use rehearse::{
    DamperFall, LiftTable, MISSING, PlayOutcome, Practice, Rehearsal, RehearsedStroke, Shortfall,
    Strike, StrokeTable, StrokeTables,
};
pub use score::{
    ChosenParts, PassedOver, PassedOverCounts, Score, ScoreError, ScoreNote, ScoreTrack, read,
    read_parts,
};
pub use stroke::{PlannedStroke, Technique, plan};
