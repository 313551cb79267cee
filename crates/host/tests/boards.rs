//! The commands that speak with boards, against simulated ones behind pseudo-terminals.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use firmware_protocol::key::BoardId;
use haptics::RigParameters;
use hardware::calibration::file;
use hardware::link::serial::Pty;
use hardware::refusal::Uid;
use hardware::sim::board::{BoardMake, SimulatedBoard};
use serde_json::Value;

/// A simulated board behind a port.
struct Board {
    port: PathBuf,
    uid: Uid,
    stop: Arc<AtomicBool>,
    thread: Option<JoinHandle<SimulatedBoard>>,
}

impl Board {
    fn start(make: BoardMake) -> Self {
        let Pty { mut board, path: port } = Pty::open().expect("a pseudo-terminal");
        let mut simulated = SimulatedBoard::new(make).expect("a possible board");
        let stop = Arc::new(AtomicBool::new(false));
        let its_stop = Arc::clone(&stop);
        let thread = std::thread::spawn(move || {
            let began = Instant::now();
            while !its_stop.load(Ordering::Acquire) {
                // Its ticks are of 100 us.
                let tick = u64::try_from(began.elapsed().as_micros() / 100).expect("a short test");
                simulated.advance(tick, &mut board);
                std::thread::sleep(Duration::from_micros(300));
            }
            simulated
        });
        Self { port, uid: Uid(make.uid()), stop, thread: Some(thread) }
    }

    fn link(&self) -> String {
        format!("serial:{}", self.port.display())
    }

    fn stop(mut self) -> SimulatedBoard {
        self.stop.store(true, Ordering::Release);
        self.thread.take().expect("it lives").join().expect("it lives well")
    }
}

impl Drop for Board {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Release);
    }
}

fn make(number: u8, n_keys: usize) -> BoardMake {
    let id = BoardId::new(number).expect("a board");
    BoardMake { n_keys, ..BoardMake::standard(id, 100e-6, RigParameters::default()) }
}

fn letoff(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_letoff"));
    command.args(arguments).stdin(Stdio::null()).output().expect("the program")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A folder of its own for the files of one test.
fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    // Those of an earlier run may lie there.
    let _absent = std::fs::remove_dir_all(&folder);
    folder
}

#[test]
fn boards_are_listed_with_their_logs_and_a_dead_link_is_no_end() {
    let board = Board::start(make(4, 11));
    let (link, dead) = (board.link(), "serial:/dev/no-such-port");
    let said = letoff(&["devices", "--boards", "--link", dead, "--link", &link, "--light", "4"]);
    let said = text(&said.stdout);
    let parts = ["it is not there", "board 4 ", "F4..D#5", "simulated fingers", "never armed"];
    assert!(parts.iter().all(|part| said.contains(part)), "{said}");
    let said = letoff(&["devices", "--boards", "--link", &link, "--log", "--json"]);
    let listed: Value = serde_json::from_slice(&said.stdout).expect("JSON");
    let it = &listed[0]["boards"][0];
    assert_eq!(it["uid"], board.uid.to_string());
    assert!(it["log"][0].as_str().expect("a line").ends_with("  light"), "{listed}");
    assert_eq!(it["law_hz"], 10_000);
    assert!(board.stop().is_lit());
}

#[test]
fn a_board_is_calibrated_into_a_file_and_the_file_is_not_lost() {
    let board = Board::start(BoardMake { offset: 500, ..make(3, 2) });
    let (link, folder) = (board.link(), folder("calibrate"));
    let folder_name = folder.display().to_string();
    let calibrate = ["calibrate", "--link", &link, "--folder", &folder_name];
    let said = letoff(&calibrate);
    let (out, err) = (text(&said.stdout), text(&said.stderr));
    assert!(said.status.success(), "{out}{err}");
    assert!(out.contains("  F#3        500") && out.contains("  10.1"), "{out}");
    let path = file::path(&folder, board.uid);
    let keys = file::read(&path, board.uid, 2).expect("a good file").expect("a file");
    for key in keys.as_slice() {
        assert!((key.rest.get() - 500).abs() <= 2, "{key:?}");
        assert!((10.15e-3..10.20e-3).contains(&key.travel()), "{key:?}");
        assert!((0.10..0.14).contains(&key.friction), "{key:?}");
    }
    // Nobody can be asked, so nothing is overwritten.
    let said = letoff(&calibrate);
    let err = text(&said.stderr);
    assert_eq!(said.status.code(), Some(2), "{err}");
    assert!(err.contains("would be overwritten; give --yes"), "{err}");
    let said = letoff(&[&calibrate[..], &["--yes", "--json", "--board", "3"]].concat());
    assert!(said.status.success(), "{}", text(&said.stderr));
    let written: Value = serde_json::from_slice(&said.stdout).expect("JSON");
    assert_eq!(written[0]["keys"][1]["key"], "G3");
    assert!(file::backup(&path).exists());
}

#[test]
fn a_key_that_jams_is_named_and_no_file_is_written() {
    let mut jams = make(0, 1);
    jams.rig.key.stiction = 3.0;
    let board = Board::start(jams);
    let folder = folder("jams");
    let link = board.link();
    let said = letoff(&["calibrate", "--link", &link, "--folder", &folder.display().to_string()]);
    let err = text(&said.stderr);
    assert_eq!(said.status.code(), Some(1), "{err}");
    assert!(err.contains("A0 of board 0 on /dev/pts/") && err.contains("does not move"), "{err}");
    assert!(!folder.exists());
    let said = letoff(&["calibrate", "--link", &link, "--board", "9"]);
    assert!(text(&said.stderr).contains("no board has the number 9"), "{said:?}");
    let said = letoff(&["calibrate", "--link", &link, "--weight", "50"]);
    assert!(text(&said.stderr).contains("needs somebody at a terminal"), "{said:?}");
}

#[test]
fn a_scene_that_cannot_fit_is_refused_before_a_link_is_opened() {
    let folder = folder("overload");
    std::fs::create_dir_all(&folder).expect("a folder");
    let board = |n| format!("[[links.bus.board]]\nnumber = {n}\nkeys = \"A0..G1\"\n");
    let boards: Vec<_> = (0..8).map(board).collect();
    let boards = boards.concat();
    let scene = format!(
        "tick_hz = 1000\n[[keys]]\nrange = \"A0..C8\"\ninstrument = \"grand-springs\"\n\
         [links]\nkind = \"boards\"\n[[links.bus]]\ncan = \"no-such-can\"\n{boards}"
    );
    let path = folder.join("full.toml");
    std::fs::write(&path, scene).expect("a scene");
    let path = path.display().to_string();
    for command in [&["run", &path, "--duration", "1"][..], &["plan", &path]] {
        let said = letoff(command);
        let err = text(&said.stderr);
        let parts = ["no-such-can (CAN FD at 1/5 Mbit/s)", "would take 194.1 %", "lower the rates"];
        assert!(parts.iter().all(|part| err.contains(part)), "{err}");
        assert!(!err.contains("cannot be opened"), "{err}");
    }
    assert_eq!(letoff(&["plan", &path]).status.code(), Some(1));
}

#[test]
fn a_run_on_a_board_reports_its_link() {
    let board = Board::start(make(2, 11));
    let link = board.link();
    let arguments = ["run", "--link", &link, "--performance", "none", "--duration", "1", "--json"];
    let said = letoff(&arguments);
    assert!(said.status.success(), "{}", text(&said.stderr));
    let report: Value = serde_json::from_slice(&said.stdout).expect("JSON");
    let line = &report["lines"][0];
    assert_eq!(
        (line["name"].as_str(), line["state"].as_str()),
        (board.port.to_str(), Some("active"))
    );
    assert!(200.0 < line["seen_hz"].as_f64().expect("a rate"), "{line}");
    assert!(line["medium"].is_null() && line["planned_load"].is_null(), "{line}");
}
