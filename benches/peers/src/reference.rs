//! Reference events and states, from a closed form or an independent program.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::problems::ModelB;

/// Interval of the rows of a trajectory (s).
const ROW: f64 = 0.01;

/// Minimum distance of a compared state from any event (s): an event time that is off by δ makes
/// the state wrong by δ times the jump, an error that is measured on its own.
const AWAY: f64 = 0.005;

#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Expected {
    pub(crate) t: f64,
    pub(crate) guard: String,
}

#[derive(Clone, Debug)]
pub(crate) struct Reference {
    pub(crate) events: Vec<Expected>,
    pub(crate) times: Vec<f64>,
    pub(crate) states: Vec<Vec<f64>>,
    pub(crate) scales: Vec<f64>,
}

impl Reference {
    /// Keeps the rows that are away from all events, and not at the start.
    pub(crate) fn new(events: Vec<Expected>, rows: Vec<(f64, Vec<f64>)>) -> Self {
        let is_away = |t: f64| t > 0.0 && events.iter().all(|event| (event.t - t).abs() > AWAY);
        let (times, states): (Vec<_>, Vec<_>) =
            rows.into_iter().filter(|(t, _)| is_away(*t)).unzip();
        let width = states.first().map_or(0, Vec::len);
        let largest = |column: usize| {
            states.iter().fold(0.0, |most: f64, state: &Vec<f64>| most.max(state[column].abs()))
        };
        let scales = (0..width).map(largest).collect();
        Self { events, times, states, scales }
    }
}

pub(crate) fn rows(t_end: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
    let count = (t_end / ROW + 0.5) as u32;
    count
}

pub(crate) fn row_time(row: u32) -> f64 {
    f64::from(row) * ROW
}

/// Model B for the peers, its parameters by name, its end (s), and its reference.
pub(crate) struct ModelBCase {
    pub(crate) problem: ModelB,
    pub(crate) parameters: Value,
    pub(crate) t_end: f64,
    pub(crate) reference: Reference,
}

pub(crate) fn model_b(name: &str) -> Result<ModelBCase, String> {
    let folder = folder();
    let json = read(&folder.join(format!("{name}.json")))?;
    let mut json: Value =
        serde_json::from_str(&json).map_err(|error| format!("{name}: {error}"))?;
    let rows = trajectory(&read(&folder.join(format!("{name}.csv")))?)?;
    let rest = rows.first().map(|(_, state)| state.clone()).unwrap_or_default();
    let problem = problem(&json["parameters"], &json["input"]["A_tc_w"], &rest)
        .ok_or_else(|| format!("{name}: a parameter is missing"))?;
    let t_end = number(&json["t_end"]).ok_or_else(|| format!("{name}: no t_end"))?;
    let events = json["events"].as_array().map(Vec::as_slice).unwrap_or_default();
    let events: Option<Vec<_>> = events.iter().map(expected).collect();
    let events = events.ok_or_else(|| format!("{name}: an event is incomplete"))?;
    let parameters = json["parameters"].take();
    Ok(ModelBCase { problem, parameters, t_end, reference: Reference::new(events, rows) })
}

/// Reads a case of this package: its parameters by name, its end (s), and its reference.
pub(crate) fn contact(name: &str) -> Result<(BTreeMap<String, f64>, f64, Reference), String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("references");
    let json = read(&path.join(format!("{name}.json")))?;
    let json: Value = serde_json::from_str(&json).map_err(|error| format!("{name}: {error}"))?;
    let parts = || {
        let parameters = json["parameters"].as_object()?.iter();
        let parameters = parameters.map(|(name, value)| Some((name.clone(), number(value)?)));
        let events = json["events"].as_array()?.iter().map(expected).collect::<Option<_>>()?;
        let row = |row: &Value| {
            let row: Option<Vec<f64>> = row.as_array()?.iter().map(number).collect();
            let (t, state) =
                row.as_deref()?.split_first().map(|(t, state)| (*t, state.to_vec()))?;
            Some((t, state))
        };
        let rows = json["rows"].as_array()?.iter().map(row).collect::<Option<_>>()?;
        let reference = Reference::new(events, rows);
        Some((parameters.collect::<Option<_>>()?, number(&json["t_end"])?, reference))
    };
    parts().ok_or_else(|| format!("{name}: the reference is incomplete"))
}

pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../crates/instruments/tests/reference")
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn expected(event: &Value) -> Option<Expected> {
    Some(Expected { t: number(&event["t"])?, guard: event["guard"].as_str()?.to_owned() })
}

/// Reads a number, also in quotes, which keep its digits.
pub(crate) fn number(value: &Value) -> Option<f64> {
    value.as_f64().or_else(|| value.as_str()?.parse().ok())
}

fn problem(p: &Value, bells: &Value, rest: &[f64]) -> Option<ModelB> {
    let of = |name: &str| number(&p[name]);
    let g = of("g")?;
    let bell = |i: usize| {
        let part = |j: usize| number(&bells[i][j]);
        Some([part(0)?, part(1)?, 1.0 / part(2)?])
    };
    Some(ModelB {
        l: [of("L1")?, of("L2")?, of("L3")?, of("L4")?],
        weights: [of("M1")? * g * of("cK")?, of("M2")? * g * of("L2")?],
        k: [of("k1")?, of("k2")?],
        j: [of("JK")?, of("JH")?],
        string: [of("string_angle")?, of("restitution")?],
        bells: [bell(0)?, bell(1)?, bell(2)?],
        rest: rest.try_into().ok()?,
    })
}

/// Reads time and four states of each row: columns t, mode, θh, θk, θh', θk', …
fn trajectory(csv: &str) -> Result<Vec<(f64, Vec<f64>)>, String> {
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        let t = fields.first()?.parse().ok()?;
        let state: Option<Vec<f64>> =
            fields.get(2..6)?.iter().map(|field| field.parse().ok()).collect();
        Some((t, state?))
    };
    let rows: Option<Vec<_>> = csv.lines().skip(1).map(row).collect();
    rows.ok_or_else(|| "a row of the trajectory cannot be read".to_owned())
}
