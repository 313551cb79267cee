//! The whole host against the fault rig: the reference firmware with motors, encoders and a finger,
//! which has every fault that boards have had. Both live in virtual time, so each row is exact.
//!
//! A row is judged by what the key felt: the motor's work on it, its largest force and how long a
//! force lasted, as the rig measured them; then by the log and the exit code. The bounds are those of
//! the classes of faults in `firmware-protocol/README.md`.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use crate::letoff::{self, Said};

/// What a fault may cost.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Class {
    /// It is there before a model plays: the key gets no more than the push of its proof.
    AtArming,
    /// It damages samples or frames: nearly nothing is handed out.
    InSamples,
    /// It appears while a piece is played: the key is silenced 100 ms after it shows.
    InRun,
    /// Nothing that the host sends changes it: it is named.
    BeyondHost,
}

/// A fault of the rig, and what the host makes of it.
struct Row {
    fault: &'static str,
    /// When it begins, after the first arming (s).
    from: &'static str,
    class: Class,
    /// When it shows, after its beginning (s).
    shows: f64,
    code: i32,
    words: &'static str,
}

const fn row(
    fault: &'static str,
    from: &'static str,
    class: Class,
    code: i32,
    words: &'static str,
) -> Row {
    Row { fault, from, class, shows: 0.0, code, words }
}

impl Row {
    const fn shows(self, seconds: f64) -> Self {
        Self { shows: seconds, ..self }
    }
}

const ROWS: &[Row] = &[
    row("half", "0", Class::AtArming, 1, "confirmed a sample every 1.00 ms and sends one every 2.00 ms"),
];

/// Most that a proof pushes (N), with what a current loop overshoots.
const MOST_PUSH: f64 = 1.55;

/// What more than an honest board a damaged one may hand out (mJ), and push along a motion (N).
const MORE_WORK: f64 = 5.0;
const MORE_PUSH: f64 = 2.0;

/// Time from what shows a fault to the end of all forces (s): 100 ms, and 20 ms in which they fade.
const SILENCED: f64 = 0.12;

/// Largest force of the rig's motors (N).
const MAX_FORCE: f64 = 30.0;

/// What the rig measured on the key that it plays.
struct Felt {
    key: Value,
}

impl Felt {
    fn get(&self, name: &str) -> f64 {
        self.key[name].as_f64().unwrap_or_default()
    }
}

/// The rig, built with the command of its README; nothing without a compiler.
fn rig() -> Option<PathBuf> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("firmware-protocol/c/rig");
    let readme = std::fs::read_to_string(source.join("README.md")).expect("the rig's README");
    let command = readme.split("```sh\n").nth(1).and_then(|it| it.split("```").next());
    let program = letoff::folder("fault-rig").join("rig");
    let command = command.expect("the command").replace("-o rig", "-o \"$PROGRAM\"");
    if Command::new("cc").arg("--version").output().is_err() {
        return None;
    }
    let mut shell = Command::new("sh");
    shell.args(["-e", "-c", &command]).env("PROGRAM", &program).current_dir(source);
    assert!(shell.status().expect("a shell").success(), "the rig cannot be built");
    Some(program)
}

/// Plays `instrument` on the rig with these arguments for so long (s).
fn play(rig: &Path, instrument: &str, seconds: &str, arguments: &str) -> (Said, Option<Felt>) {
    let name: String = arguments.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    let folder = letoff::folder(&format!("fault-rig/{instrument}{name}"));
    let report = folder.join("rig.json");
    let _none = std::fs::remove_file(&report);
    let link = format!("rig:{} --lockstep --report {} {arguments}", rig.display(), report.display());
    let said = letoff::run(&folder, &[
        "run", "default", "--set", &format!("instrument.action=\"{instrument}\""), "--link", &link,
        "--performance", "none", "--virtual-time", "--duration", seconds, "--json",
    ]);
    let felt = std::fs::read_to_string(report).ok().map(|text| {
        let report: Value = serde_json::from_str(&text).expect("a report");
        Felt { key: report["keys"][0].clone() }
    });
    (said, felt)
}
