//! All that the picture of a run shows.

use super::curve::SignalCurve;
use super::epoch::Epochs;
use super::mark::EventMarks;
use super::track::Columns;

/// What a run has shown, in bounded memory.
#[derive(Debug)]
pub(super) struct RunPicture {
    /// Model, method and tick, one to a line.
    pub(super) title: [String; 3],
    pub(super) axis: Columns,
    /// Names of the model's modes.
    pub(super) modes: Vec<&'static str>,
    pub(super) curves: Vec<SignalCurve>,
    pub(super) epochs: Epochs,
    pub(super) marks: EventMarks,
}
