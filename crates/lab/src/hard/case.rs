//! The cases, built in: settings and references from one file, and the descriptions.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, LazyLock};

use instruments::LoadedModel;
use mechanism::Library;
use serde::{Deserialize, Serialize};

/// A hard case: a description, its settings, and the right outcome.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct HardCase {
    pub name: String,
    /// Difficulty that it shares with others.
    pub topic: String,
    /// URL of a public bug report, or origin of the reference.
    pub source: String,
    /// Behaviour of tools that fail.
    pub symptom: String,
    /// Name of the description.
    pub model: String,
    /// End (s).
    pub until: f64,
    /// Lengths of ticks (s), the longest first.
    pub steps: Vec<f64>,
    #[serde(default)]
    pub arguments: Vec<String>,
    #[serde(default)]
    pub first_tick: u64,
    /// `true` if it has too many ticks for a quick study.
    #[serde(default)]
    pub is_long: bool,
    /// Reason for errors that are known.
    pub explained: Option<String>,
    pub expected: ExpectedRun,
}

/// Events and values of the right outcome.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct ExpectedRun {
    /// Largest error of a time (s), and of values unless `accuracy` states another.
    pub tolerance: f64,
    /// Largest error of a value, over the larger of its size and `scale`.
    pub accuracy: Option<f64>,
    /// Size below which errors of values are absolute; 1 if absent.
    pub scale: Option<f64>,
    /// All events, by guard and time (s).
    pub events: Option<Vec<(String, f64)>>,
    /// First events.
    #[serde(default)]
    pub begins: Vec<(String, f64)>,
    /// Last events.
    #[serde(default)]
    pub ends: Vec<(String, f64)>,
    #[serde(default)]
    pub counts: BTreeMap<String, usize>,
    /// Smallest number of events.
    #[serde(default)]
    pub least: usize,
    /// State at the end (SI).
    #[serde(default)]
    pub r#final: BTreeMap<String, f64>,
    /// Largest error of the energy audit, as a share of the energy that moved.
    pub energy: Option<f64>,
    /// Angle of the fastest motion over the run (rad), for a budget per radian; 10 if absent.
    pub radians: Option<f64>,
    pub fails: Option<HardFailure>,
}

/// Reported failure that is the right outcome.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum HardFailure {
    /// The description is rejected.
    Mistake,
    /// The run ends where there is no solution.
    Fault,
}

pub(super) type CaseModel = Result<Arc<LoadedModel>, String>;

macro_rules! descriptions {
    ($($name:literal)+) => {
        /// Descriptions by file name.
        const DESCRIPTIONS: &[(&str, &str)] = &[$((
            $name,
            include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/cases/", $name, ".toml")),
        )),+];
    };
}

descriptions! {
    "ball" "ball-mega" "ball-nano" "bead" "belt" "billiard" "block" "box" "contact" "crank"
    "cubic" "cycle" "cylinder" "detent" "dry" "electron" "felt" "field" "filippov" "gravity-off"
    "graze" "held" "hunt" "jumps" "not-a-number" "oscillator" "other-way" "parabola" "parachute"
    "pendulum" "platform" "pulse" "reaction" "relation" "relay" "rod" "rope" "sawtooth" "shaker"
    "slide" "spool" "stays" "swing" "thresholds" "two-balls" "yank"
}

/// All cases; none if the built-in list is malformed, which a test excludes.
pub static HARD_CASES: LazyLock<Vec<HardCase>> = LazyLock::new(|| {
    serde_json::from_str(include_str!("../../cases/cases.json")).unwrap_or_default()
});

impl HardCase {
    /// Returns the model of its description, or the mistakes.
    pub(super) fn load(&self, library: &Library) -> CaseModel {
        let path = PathBuf::from(format!("{}.toml", self.model));
        let known = DESCRIPTIONS.iter().find(|(name, _)| *name == self.model);
        library.keep_file(&path, known.map_or("", |(_, text)| text));
        library.load(&path).map_err(|mistakes| mistakes.to_string())
    }
}
