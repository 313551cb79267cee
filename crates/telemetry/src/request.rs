//! What a client may ask a host for, and what it answers.

use serde::{Deserialize, Serialize};

/// A request; on the stream its name is the service's.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(tag = "service", rename_all = "snake_case", deny_unknown_fields)]
pub enum Request {
    /// Other values for parameters of voices: all of them or none.
    Set {
        /// What shall be changed.
        changes: Vec<Change>,
    },
    /// Another instrument for a range of keys, as `C4..B5`; all without.
    UseInstrument {
        /// An instrument's name or file.
        instrument: String,
        keys: Option<String>,
    },
    /// No force on any key from the next tick on, and an end.
    Stop {},
    /// The simulated finger on a key presses so hard; nothing lets go.
    Press {
        /// Which key, 0 (A0) to 87 (C8).
        key: u8,
        /// How hard (N).
        newtons: f64,
    },
    /// A board shows its light.
    Identify {
        /// Which line, in the order of the scene.
        line: u32,
        board: u32,
    },
    /// The scene as it sounds now, as a file.
    Scene {},
    /// Where the host streams what it tells.
    Where {},
    /// Begins to record, or ends.
    Record {
        /// Where to; `None` ends the recording.
        file: Option<String>,
    },
}

/// Another value for a parameter.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Change {
    /// Which key, 0 (A0) to 87 (C8).
    pub key: u8,
    pub parameter: String,
    /// Its value, in the parameter's unit.
    pub value: f64,
}

impl Change {
    /// Its name as a parameter of the stream: `/key/<n>/<parameter>`.
    pub fn name(&self) -> String {
        format!("/key/{}/{}", self.key, self.parameter)
    }

    /// What the parameter `name` of the stream means, if it is one.
    pub fn named(name: &str, value: f64) -> Option<Self> {
        let (key, parameter) = name.strip_prefix("/key/")?.split_once('/')?;
        let key = key.parse().ok().filter(|key| usize::from(*key) < crate::KEYS)?;
        Some(Self { key, parameter: parameter.to_owned(), value })
    }
}

/// What became of a request.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(tag = "reply", rename_all = "snake_case")]
pub enum Reply {
    Done {
        /// What was done, in a sentence.
        text: String,
    },
    /// All forces were taken away, and the run ends.
    Stopped {
        /// What was done, in a sentence.
        text: String,
        /// Boards that were told to render no force.
        told: u32,
        /// Boards that were armed; where fewer were told, cut the power of the others.
        boards: u32,
    },
    /// The scene as it sounds now.
    Scene { toml: String },
    /// Where the host streams what it tells.
    Where {
        /// Of its stream, as `ws://127.0.0.1:8765`; behind a `#` the fingerprint of its certificate,
        /// if it has one.
        address: String,
        /// What it must be told to be heard.
        token: Option<String>,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_has_a_name_on_the_stream() {
        let change = Change { key: 39, parameter: "k2".into(), value: 1.5 };
        assert_eq!(change.name(), "/key/39/k2");
        assert_eq!(Change::named("/key/39/k2", 1.5), Some(change));
        for foreign in ["", "/key/39", "/key/88/k2", "/key/x/k2", "key/39/k2"] {
            assert_eq!(Change::named(foreign, 0.0), None, "{foreign}");
        }
    }

    #[test]
    fn requests_are_json_with_a_service_s_name() {
        let text = serde_json::to_string(&Request::Press { key: 39, newtons: 2.5 }).expect("JSON");
        assert_eq!(text, r#"{"service":"press","key":39,"newtons":2.5}"#);
        let foreign = r#"{"service":"press","key":39,"newtons":"much"}"#;
        assert!(serde_json::from_str::<Request>(foreign).is_err());
    }
}
