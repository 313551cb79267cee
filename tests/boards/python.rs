//! A board in Python, written from PROTOCOL.md alone: first correct, then faulty in every way.
//!
//! `tests/bad_boards.rs` tests the same in virtual time; here another codec and another state
//! machine meet the real program and its messages.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use serde_json::Value;

use crate::letoff::{self, Said};
use crate::machine_time::{Task, WaitWatch, judged_with_time, say, with_time};
use crate::rig::{count, interrupt, machine, part_of_machine, run_watched, side_by_side, wait_for};

pub(crate) struct PythonBoard {
    child: Option<Child>,
    pub(crate) link: String,
}

impl PythonBoard {
    pub(crate) fn start(folder: &Path, arguments: &[&str]) -> Option<Self> {
        let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/boards/board.py");
        let port = folder.join("board");
        let _none = std::fs::remove_file(&port);
        let mut python = Command::new("python3");
        python.arg("-B").arg(program).arg("--link").arg(&port).args(arguments);
        let Ok(child) = python.stdout(Stdio::piped()).spawn() else {
            say("SKIPPED: a board in Python: python3 is not installed");
            return None;
        };
        let board = Self { child: Some(child), link: format!("serial:{}", port.display()) };
        wait_for("the board's port", || port.exists());
        Some(board)
    }

    pub(crate) fn task(&self) -> Task {
        Task::process(self.child.as_ref().expect("it lives"))
    }

    pub(crate) fn stop(mut self) -> Value {
        let child = self.child.take().expect("it lives");
        interrupt(&child);
        let output = child.wait_with_output().expect("it ends");
        serde_json::from_slice(&output.stdout).expect("what it tells")
    }
}

impl Drop for PythonBoard {
    fn drop(&mut self) {
        if let Some(mut child) = self.child.take() {
            let _gone = child.kill();
            let _status = child.wait();
        }
    }
}

/// Calibrates the board with the real command; `None` on a machine that was too busy.
fn calibrated(folder: &Path, board: PythonBoard) -> Option<PathBuf> {
    let files = folder.join("calibration");
    let dir = files.display().to_string();
    let arguments = ["calibrate", "--link", &board.link, "--yes", "--folder", &dir];
    judged_with_time("calibration of a board in Python", |watch| {
        watch.add(board.task());
        let said = run_watched(watch, folder, &arguments);
        assert_eq!(said.code, Some(0), "{said:?}");
        Some(())
    })?;
    assert_eq!(board.stop()["state"], "disarmed");
    Some(files)
}

/// Plays while a finger presses the keys, with forces valid for `valid` (s); returns the output
/// of the host and the board's report. A board without a file calls itself a simulation.
fn play(
    watch: &WaitWatch,
    folder: &Path,
    files: Option<&PathBuf>,
    valid: &str,
    arguments: &[&str],
) -> (Said, Value) {
    let mut all = vec!["--finger", "0.8"];
    if files.is_none() {
        all.extend(["--say", "features=44"]);
    }
    all.extend(arguments);
    let files = files.map_or(folder, PathBuf::as_path);
    let valid = format!("links.valid={valid}");
    let board = PythonBoard::start(folder, &all).expect("there is Python");
    watch.add(board.task());
    let calibration = format!("links.calibration=\"{}\"", files.display());
    let run = ["run", "springs", "--json", "--performance", "none", "--duration", "4"];
    // Stable with the delay of a board in Python.
    let spring = ["--set", "keys.0.instrument=spring"];
    let sets =
        [&spring[..], &["--set", &valid, "--set", &calibration, "--set", "tick_hz=500"]].concat();
    let run = [&run[..], &sets[..], &["--link", &board.link]].concat();
    (run_watched(watch, folder, &run), board.stop())
}

fn forces(told: &Value) -> [Vec<u64>; 2] {
    ["before_mn", "after_mn"].map(|name| {
        let forces = told[name].as_array().expect("forces");
        forces.iter().map(|it| it.as_u64().expect("a force")).collect()
    })
}

/// Returns `true` if the board had its time and no voice failed because of late samples.
fn had_time(said: &Said, told: &Value) -> bool {
    // A board that restarts counts its samples from there.
    let served = told["counters"][0].as_u64().unwrap_or_default().max(count(told, "/forces"));
    10 * count(told, "/skipped") < served && count(&said.report(), "/faults") == 0
}

/// Response of the host to a fault of a running board.
struct Wrong {
    way: &'static str,
    says: &'static [&'static str],
    /// `true` for each of the two keys that still gets forces.
    plays: [bool; 2],
}

const IN_RUN: [Wrong; 8] = [
    Wrong { way: "flag", says: &["renders no force"], plays: [false, false] },
    Wrong { way: "key-less", says: &["cannot be read"], plays: [false, false] },
    Wrong { way: "key-fault", says: &[], plays: [true, true] },
    Wrong { way: "jump", says: &["C4 is muted", "far beyond"], plays: [false, true] },
    Wrong { way: "noise", says: &["C4 is muted", "to and fro"], plays: [false, true] },
    Wrong { way: "late", says: &["ms old when they come"], plays: [false, false] },
    Wrong { way: "reset", says: &[], plays: [true, true] },
    Wrong { way: "lost-homing", says: &["do not know where 2 of its keys"], plays: [false, false] },
];

/// Boards that are rejected before any force, with the words of the message.
const REFUSED: [(&[&str], &str); 9] = [
    (&["--drift", "50000"], "% too fast, and at most 3 % is accepted"),
    (&["--wrong", "flag"], "its samples say that it renders no force"),
    (&["--wrong", "key-less"], "its samples are none of 2 keys"),
    (&["--wrong", "wrong-nonce"], "answered Arm with \"wrong nonce\""),
    (&["--wrong", "no-ping"], "answered Ping with \"unknown operation\""),
    (&["--wrong", "late-replies"], "answers later than 25 ms"),
    (&["--say", "quantum_nm=0"], "quantum_nm = 0, and 1 to 1000000 is possible"),
    (&["--say", "max_force_mn=0"], "max_force_mn = 0, and 1 to 65535 is possible"),
    (&["--say", "max_sample_hz=0"], "max_sample_hz = 0, and 1 to 65535 is possible"),
];

const DRIFT: f64 = 5.0;

/// Error within which the host must know a clock's rate before it rejects the clock (%):
/// `RATE_ERROR` of `boards/clock.rs`. Virtual time gives the exact figure (`bad_boards.rs`).
const RATE_ERROR: f64 = 0.3;

fn reported_drift(said: &Said) -> Option<f64> {
    let (_before, figure) = said.err.split_once("its clock runs ")?;
    figure.split(' ').next()?.parse().ok()
}

#[test]
fn a_board_written_from_the_document_serves_and_what_is_wrong_with_it_is_said() {
    let _machine = machine();
    let folder = letoff::folder("python-board");
    let Some(board) = PythonBoard::start(&folder, &[]) else { return };
    let files = calibrated(&folder, board);
    let files = files.as_ref();

    judged_with_time("a board in Python that is well", |watch| {
        let (said, told) = play(watch, &folder, files, "0.1", &[]);
        if !had_time(&said, &told) {
            return None;
        }
        let report = said.report();
        assert_eq!(report["boards"][0]["state"], "armed", "{said:?}");
        assert_eq!(report["boards"][0]["calibrated"], files.is_some(), "{report}");
        assert!(200 < count(&told, "/forces") && 100 < forces(&told)[1][1], "{told}");
        assert_eq!(told["counters"][2], 0, "nothing was corrupt: {told}");
        Some(())
    });

    with_time("the largest force of a board in Python", |watch| {
        let weak = ["--say", "max_force_mn=500"];
        let (said, told) = play(watch, &folder, files, "0.1", &weak);
        assert!(forces(&told)[1].iter().all(|it| *it <= 500), "{said:?}: {told}");
    });

    side_by_side(&folder, 2, &IN_RUN, |folder, Wrong { way, says, plays }| {
        // Samples may be marked up to 60 ms late, longer than these forces are valid.
        let valid = if *way == "late" { "0.02" } else { "0.1" };
        judged_with_time(way, |watch| {
            let wrong = ["--wrong", way, "--at", "1"];
            let (said, told) = play(watch, folder, files, valid, &wrong);
            if !had_time(&said, &told) {
                return None;
            }
            letoff::check_words(&said, says);
            let [before, after] = forces(&told);
            assert!(before.iter().all(|it| 0 < *it), "{way}: {told}");
            assert_eq!([0, 1].map(|key| 0 < after[key]), *plays, "{way}: {told}, {said:?}");
            check_armings(way, &told);
            Some(())
        });
    });
}

#[track_caller]
fn check_armings(what: &str, told: &Value) {
    let n = count(told, "/arm_requests");
    assert!(n <= 8, "{what}: asked to arm {n} times");
}

#[test]
fn a_board_that_breaks_the_protocol_is_refused_before_any_force_and_told_why() {
    let _machine = part_of_machine();
    let folder = letoff::folder("python-board-refused");
    if PythonBoard::start(&folder, &[]).is_none() {
        return;
    }
    side_by_side(&folder, 4, &REFUSED, |folder, (arguments, words)| {
        with_time(&format!("the refusal \"{words}\""), |watch| {
            let (said, told) = play(watch, folder, None, "0.1", arguments);
            assert_eq!(said.code, Some(1), "{arguments:?}: {said:?}");
            letoff::check_words(&said, &["board 5 on", words]);
            let drift = reported_drift(&said);
            assert!(drift.is_none_or(|it| (it - DRIFT).abs() <= RATE_ERROR), "{said:?}");
            assert_eq!(drift.is_some(), arguments[0] == "--drift", "{said:?}");
            assert_eq!(forces(&told), [[0; 2]; 2], "{arguments:?}: {told}");
            check_armings(words, &told);
        });
    });
}
