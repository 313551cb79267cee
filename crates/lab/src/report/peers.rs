//! Results of other codes on some of the same problems, written by `benches/peers`.

use std::fs;
use std::path::{Path, PathBuf};

use documents::shown;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::text;

/// One run of one code, measured by `benches/peers`.
#[derive(Clone, PartialEq, Debug, Deserialize, Serialize)]
pub struct Peer {
    pub problem: String,
    pub code: String,
    pub version: String,
    pub method: String,
    /// Settings: the code's defaults, or its documentation's advice.
    pub setting: String,
    /// Tolerance, or step (s).
    pub tolerance_or_step: Option<f64>,
    pub events: Option<u64>,
    /// `true` if the right events occurred in the right order.
    pub sequence_ok: bool,
    pub event_error_s: Option<f64>,
    /// Largest error of the state away from events, each entry over its largest magnitude.
    pub state_error: Option<f64>,
    /// Evaluations of the right-hand side in the whole run.
    pub rhs: Option<f64>,
    pub ns_per_ms_min: Option<f64>,
    pub ns_per_ms_median: Option<f64>,
    #[serde(default)]
    pub note: Option<String>,
    #[serde(default)]
    pub failure: Option<String>,
}

impl Peer {
    pub(super) fn curve(&self) -> String {
        format!("{} {} ({})", self.code, self.method, self.setting)
    }

    pub(super) fn author(&self) -> Author {
        match self.code.as_str() {
            "pode" => Author::Ours,
            "handwritten" => Author::ByHand,
            _ => Author::Others,
        }
    }

    pub(super) fn knob(&self) -> String {
        self.tolerance_or_step.map(text::exponent).unwrap_or_default()
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Author {
    /// `pode`, in the same run as the others.
    Ours,
    ByHand,
    Others,
}

/// Invalid file of other codes' results.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("{}: {what}; give the results.json that benches/peers writes", shown(path))]
pub struct BadPeers {
    pub path: PathBuf,
    pub what: String,
}

/// Reads the rows of a file: a list, or an object with a list called `rows`.
pub fn read(path: &Path) -> Result<Vec<Peer>, BadPeers> {
    let bad = |what: String| BadPeers { path: path.to_owned(), what };
    let text = fs::read_to_string(path).map_err(|cause| bad(cause.to_string()))?;
    rows(&text).map_err(bad)
}

fn rows(text: &str) -> Result<Vec<Peer>, String> {
    let value: Value = serde_json::from_str(text).map_err(|cause| format!("no JSON: {cause}"))?;
    let listed = if let Value::Object(mut fields) = value {
        fields.remove("rows").unwrap_or_default()
    } else {
        value
    };
    let Value::Array(rows) = listed else {
        return Err("there is no list of rows".to_owned());
    };
    let row = |(index, row)| {
        serde_json::from_value(row).map_err(|cause| format!("row {}: {cause}", index + 1))
    };
    rows.into_iter().enumerate().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROW: &str = r#"{"problem": "ball", "code": "diffsol", "version": "0.16", "method":
        "tsit45", "setting": "default", "tolerance_or_step": 1e-6, "events": 10, "sequence_ok":
        true, "event_error_s": 1e-9, "state_error": null, "rhs": 100, "ns_per_ms_min": 4.7,
        "ns_per_ms_median": 5.0, "note": ""}"#;

    #[test]
    fn rows_stand_in_a_list_or_under_their_name() {
        for text in [format!("[{ROW}]"), format!("{{\"machine\": 1, \"rows\": [{ROW}, {ROW}]}}")] {
            let rows = rows(&text).unwrap();
            assert_eq!((rows[0].code.as_str(), rows[0].state_error), ("diffsol", None));
            assert_eq!(rows[0].rhs, Some(100.0));
        }
    }

    #[test]
    fn what_is_wrong_is_said_with_its_row() {
        let without_code = ROW.replace("\"code\"", "\"kode\"");
        let said = |text: &str| rows(text).unwrap_err();
        assert!(
            said(&format!("[{ROW}, {without_code}]")).starts_with("row 2: missing field `code`")
        );
        assert_eq!(said("{\"row\": []}"), "there is no list of rows");
        assert_eq!(said("7"), "there is no list of rows");
        assert!(said("[").starts_with("no JSON: EOF"));
    }
}
