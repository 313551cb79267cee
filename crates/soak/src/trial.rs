//! What is tried, and what came of one run.

use std::path::PathBuf;

use host::report::RunReport;
use scene::Scene;

use crate::actions::ActionCounts;
use crate::host_files::SupervisedProgram;
use crate::killed::KilledFindings;
use crate::synthesizer::Sounds;
use crate::telling::ToldEvents;
use crate::watch::SoakFindings;

/// How the host is tried.
#[derive(Clone, Debug)]
pub struct SoakChoice {
    /// Simulated keys, without a pianist and without a MIDI output of its own.
    pub scene: Scene,
    pub seed: u64,
    /// Length of the run (s), 10 at least.
    pub seconds: f64,
    pub time: SoakTime,
    /// Where recordings go; files of these names must not be there.
    pub folder: PathBuf,
    /// What is killed beside a trial in real time, if anything is.
    pub supervised: Option<SupervisedProgram>,
}

/// The time in which a trial runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum SoakTime {
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
    /// What became of the host that was killed beside it, if one was.
    pub(crate) killed: Option<KilledFindings>,
    /// What is wrong with its recordings.
    pub(crate) recordings: Vec<String>,
}
