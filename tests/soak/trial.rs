//! Settings and result of one run.

use std::path::PathBuf;

use host::report::RunReport;
use scene::Scene;

use crate::actions::ActionCounts;
use crate::synthesizer::Sounds;
use crate::telling::ToldEvents;
use crate::watch::SoakFindings;

#[derive(Clone, Debug)]
pub(crate) struct SoakChoice {
    pub(crate) scene: Scene,
    pub(crate) seed: u64,
    pub(crate) seconds: f64,
    pub(crate) time: SoakTime,
    /// Folder of the recordings, without files of their names.
    pub(crate) folder: PathBuf,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum SoakTime {
    /// As fast as possible: a seed gives the same bits every time.
    Virtual,
    Real,
}

pub(crate) struct PlayedTrial {
    pub(crate) report: RunReport,
    pub(crate) seen: Box<SoakFindings>,
    pub(crate) sounds: Sounds,
    pub(crate) told: ToldEvents,
    pub(crate) acted: ActionCounts,
    pub(crate) strangers: Vec<String>,
    pub(crate) recordings: Vec<String>,
}
