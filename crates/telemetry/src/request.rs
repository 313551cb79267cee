//! Requests of a client, and the host's replies.

use keyboard::Difference;
use serde::{Deserialize, Serialize};

use crate::HostStatus;

/// A request; on the stream its name is the service's.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(tag = "service", rename_all = "snake_case", deny_unknown_fields)]
pub enum Request {
    /// Sets parameters of voices: all of them or none.
    Set { changes: Vec<Change> },
    /// Changes render settings of all voices: all of them or none.
    Render { settings: Vec<RenderSetting> },
    /// Lets another instrument play a range of keys, as `C4..B5`; all if `None`.
    UseInstrument {
        /// Name or file of the instrument.
        instrument: String,
        keys: Option<String>,
    },
    /// Lets a saved instrument play a range of keys, with the present values of its base.
    FollowBase {
        /// Name or file of the instrument.
        instrument: String,
        keys: Option<String>,
    },
    /// Saves differences from an instrument as an instrument of their own, usable by clients.
    SaveInstrument {
        /// Its name: that of a file without folder and ending.
        name: String,
        /// Name of the instrument that is changed, as its voices report it.
        base: String,
        differences: Vec<ParameterDifferences>,
        overwrite: bool,
    },
    /// Reads the description of a model and lets its newest version play.
    Load {
        description: String,
        /// The keys, as `C4..B5`; if `None`, those that play another version of it.
        keys: Option<String>,
    },
    /// Removes the force of all keys from the next tick on, and ends the run.
    Stop {},
    /// Presses a key with its simulated finger; a force of zero releases it.
    Press {
        key: u8,
        /// Force of the finger (N).
        newtons: f64,
    },
    /// Holds a simulated key with a hand that grips it, pushes and pulls.
    Grip {
        key: u8,
        /// Depth to lead the key to, as a fraction of its dip; `None` releases it.
        depth: Option<f64>,
    },
    /// Measures by which factor a key's force may grow until it is unstable, as it plays now, and
    /// the weights that move it.
    Margin {
        /// Number of the key, 0 (A0) to 87 (C8).
        key: u8,
    },
    /// Measures let-off, weights, strokes and repetition of a key with its present values, apart
    /// from the run, and compares them with what its instrument expects.
    Figures {
        /// Number of the key, 0 (A0) to 87 (C8).
        key: u8,
    },
    Identify {
        /// Number of the line, in the order of the scene.
        line: u32,
        board: u32,
    },
    /// Asks for the present scene as the text of a file.
    Scene {},
    /// Asks for the address of the host's stream.
    Where {},
    /// Asks for the status of the host.
    Status {},
    /// Begins a recording, or ends it.
    Record { file: Option<String> },
}

/// A new value of a parameter.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Change {
    /// Number of the key, 0 (A0) to 87 (C8).
    pub key: u8,
    pub parameter: String,
    /// Value in the parameter's unit.
    pub value: f64,
}

/// Differences of a parameter from its instrument.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ParameterDifferences {
    pub parameter: String,
    /// Numbers of keys, 0 (A0) to 87 (C8), and their differences.
    pub keys: Vec<(u8, Difference)>,
}

/// A setting of a scene's table `render`.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RenderSetting {
    /// Its path, as `render.passivity`.
    pub name: String,
    /// Value as written in a scene, as `control` or `"400 N/m"`.
    pub value: String,
}

impl Change {
    pub fn name(&self) -> String {
        format!("/key/{}/{}", self.key, self.parameter)
    }

    pub fn named(name: &str, value: f64) -> Option<Self> {
        let (key, parameter) = name.strip_prefix("/key/")?.split_once('/')?;
        let key = key.parse().ok().filter(|key| usize::from(*key) < crate::KEYS)?;
        Some(Self { key, parameter: parameter.to_owned(), value })
    }
}

/// The host's answer to a request.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(tag = "reply", rename_all = "snake_case")]
pub enum Reply {
    Done {
        /// Sentence about the result.
        text: String,
    },
    /// All forces were removed, and the run ends.
    Stopped {
        text: String,
        /// Boards that received the order to render no force.
        told: u32,
        /// Boards that were armed; if fewer received the order, cut the power of the others.
        boards: u32,
    },
    /// The present scene as the text of a file.
    Scene { toml: String },
    /// Address of the host's stream.
    Where {
        /// Address as `ws://127.0.0.1:8765`; its certificate's fingerprint follows a `#`, if any.
        address: String,
        /// Token that the stream asks for.
        token: Option<String>,
    },
    /// Status of the host.
    Status { status: Box<HostStatus> },
    /// Figures of a key with its present values.
    Figures {
        key: u8,
        figures: Vec<KeyFigure>,
        /// A sentence on each fault of the key, the worst first; empty for a good one.
        warnings: Vec<String>,
    },
}

/// A measured figure of a key, with the range that its instrument expects.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct KeyFigure {
    /// Name in the table `figures` of an instrument.
    pub name: String,
    /// Title for people, with the unit of the value in brackets.
    pub title: String,
    pub value: f64,
    pub low: Option<f64>,
    pub high: Option<f64>,
}
