//! What is tried, and what came of one run.

use std::path::PathBuf;

use host::report::RunReport;
use scene::Scene;

use crate::actions::ActionCounts;
use crate::synthesizer::Sounds;
use crate::telling::ToldEvents;
use crate::watch::SoakFindings;

/// How the host is tried.
#[derive(Clone, Debug)]
pub(crate) struct SoakChoice {
    /// Simulated keys, without a pianist and without a MIDI output of its own.
    pub(crate) scene: Scene,
    pub(crate) seed: u64,
    /// Length of the run (s), 10 at least.
    pub(crate) seconds: f64,
    pub(crate) time: SoakTime,
    /// Folder of the recordings, in which files of their names must not exist.
    pub(crate) folder: PathBuf,
}

/// The time in which a trial runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum SoakTime {
    /// As fast as it goes: a seed gives the same bits every time.
    Virtual,
    /// By the clock, beside busy processors and strangers at the stream.
    Real,
}

/// All that came of one run.
pub(crate) struct PlayedTrial {
    pub(crate) report: RunReport,
    pub(crate) seen: Box<SoakFindings>,
    pub(crate) sounds: Sounds,
    pub(crate) told: ToldEvents,
    pub(crate) acted: ActionCounts,
    /// What strangers did, in words.
    pub(crate) strangers: Vec<String>,
    /// What is wrong with its recordings.
    pub(crate) recordings: Vec<String>,
}
