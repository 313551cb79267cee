//! Hard cases as descriptions, most of them public bug reports of other tools, rebuilt.
//!
//! `cases/cases.json` lists them with their sources; each is simulated by five methods.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde::Deserialize;
use serde_json::{Map, Value};

pub(crate) const METHODS: [&str; 5] = ["rk4", "dop853", "tsitouras5", "by-need", "exact"];

/// Error of `by-need` over ten radians, of its budget of 1e-4 per radian.
const BUDGET: f64 = 1e-3;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct HardCase {
    name: String,
    source: String,
    symptom: String,
    model: String,
    until: f64,
    steps: Vec<f64>,
    /// Largest error of times (s) and of final values.
    tolerance: f64,
    #[serde(default)]
    arguments: Vec<String>,
    /// All events, by guard and time (s).
    events: Option<Vec<(String, f64)>>,
    /// The first events.
    #[serde(default)]
    begins: Vec<(String, f64)>,
    #[serde(default)]
    counts: Map<String, Value>,
    /// Smallest number of events.
    #[serde(default)]
    least: usize,
    #[serde(default)]
    r#final: Map<String, Value>,
    /// Largest error of the energy audit.
    energy: Option<f64>,
    /// Exit code, where it is refused or fails.
    fails: Option<i32>,
}

#[test]
fn hard_cases_run_right_by_five_methods() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases");
    let text = fs::read_to_string(folder.join("cases.json")).expect("the cases");
    let cases: Vec<HardCase> = serde_json::from_str(&text).expect("cases");
    let mut wrong = Vec::new();
    for case in &cases {
        let is_known = case.source.starts_with("https://") || case.source == "closed form";
        assert!(is_known && !case.symptom.is_empty(), "{} has no source", case.name);
        for method in METHODS {
            for step in &case.steps {
                let found = case.run(&folder, method, *step).err();
                wrong.extend(found.map(|it| format!("{}, {method}, {step} s: {it}", case.name)));
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {} cases:\n{}", wrong.len(), cases.len(), wrong.join("\n"));
}

impl HardCase {
    fn run(&self, folder: &Path, method: &str, step: f64) -> Result<(), String> {
        let events = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("case_events.csv");
        let model = folder.join(format!("{}.toml", self.model));
        let output = simulate(&model, (self.until, step), method, &events, &self.arguments);
        if self.fails.is_some() {
            let is_told = output.status.code() == self.fails && !output.stderr.is_empty();
            return is_told.then_some(()).ok_or_else(|| format!("{}", output.status));
        }
        let tolerance =
            if method == "by-need" { self.tolerance.max(BUDGET) } else { self.tolerance };
        self.end(&output, tolerance)?;
        self.sequence(&read(&events), tolerance)
    }

    fn end(&self, output: &Output, tolerance: f64) -> Result<(), String> {
        let report = report(output)?;
        for (name, expected) in &self.r#final {
            let (found, expected) = (number(&report["final"]["state"][name]), number(expected));
            let error = (found - expected).abs() / expected.abs().max(1.0);
            if error.is_nan() || tolerance < error {
                return Err(format!("{name} ends at {found}, not at {expected}"));
            }
        }
        let error = number(&report["energy_audit"]["error"]);
        match self.energy {
            Some(most) if error.is_nan() || most < error => Err(format!("energy off by {error}")),
            _ => Ok(()),
        }
    }

    fn sequence(&self, found: &[(String, f64)], tolerance: f64) -> Result<(), String> {
        let is_one = |(found, expected): (&(String, f64), &(String, f64))| {
            found.0 == expected.0 && (found.1 - expected.1).abs() <= tolerance
        };
        let all = self.events.as_ref().is_none_or(|expected| {
            expected.len() == found.len() && found.iter().zip(expected).all(is_one)
        });
        let begins = self.begins.len() <= found.len() && found.iter().zip(&self.begins).all(is_one);
        let counts = self.counts.iter().all(|(name, count)| {
            Some(found.iter().filter(|it| it.0 == *name).count() as u64) == count.as_u64()
        });
        if all && begins && counts && self.least <= found.len() {
            return Ok(());
        }
        Err(format!("{} events: {:?} …", found.len(), &found[..found.len().min(6)]))
    }
}

pub(crate) fn read(events: &Path) -> Vec<(String, f64)> {
    let text = fs::read_to_string(events).expect("events");
    let row = |line: &str| {
        let mut columns = line.split(',');
        let t = columns.next().and_then(|it| it.parse().ok()).expect("a time");
        (columns.next().expect("a guard").to_owned(), t)
    };
    text.lines().skip(1).map(row).collect()
}

/// Simulates until a time (s) in steps of a length (s), with the events in the file `events`.
pub(crate) fn simulate(
    model: &Path,
    (until, step): (f64, f64),
    method: &str,
    events: &Path,
    arguments: &[String],
) -> Output {
    Command::new(env!("CARGO_BIN_EXE_letoff"))
        .arg("simulate")
        .arg(model)
        .args(["--until", &until.to_string(), "--step", &step.to_string(), "--method", method])
        .args(["--json", "--events"])
        .arg(events)
        .args(arguments)
        .output()
        .expect("letoff starts")
}

/// Returns the report of a run, or what it said where it failed.
pub(crate) fn report(output: &Output) -> Result<Value, String> {
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    Ok(serde_json::from_slice(&output.stdout).expect("a report"))
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}
