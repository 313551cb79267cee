use super::curve::SignalCurve;
use super::epoch::Epochs;
use super::mark::EventMarks;
use super::track::Columns;

#[derive(Debug)]
pub(super) struct RunPicture {
    /// Model, method and tick, one per line.
    pub(super) title: [String; 3],
    pub(super) axis: Columns,
    pub(super) modes: Vec<&'static str>,
    pub(super) curves: Vec<SignalCurve>,
    pub(super) epochs: Epochs,
    pub(super) marks: EventMarks,
}
