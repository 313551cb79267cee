//! The commands for boards, against simulated ones behind pseudo-terminals.

use std::collections::BTreeMap;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};

use boards::calibration::file;
use boards::sim::board::BoardMake;
use firmware_protocol::frame::hello::safe_reason;
use rustix::process::{Pid, Signal, kill_process};
use serde_json::Value;
use telemetry::Update;
use telemetry::recording::Recording;

use crate::common::{Board, make};
use crate::machine_time::{WaitWatch, with_time};
use crate::typed::{Folder, eventually};

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_letoff"));
    command.args(arguments).stdin(Stdio::null());
    command
}

fn letoff(arguments: &[&str]) -> Output {
    command(arguments).output().expect("the program")
}

/// Like [`letoff`], for a program that needs the machine's time.
fn watched(watch: &WaitWatch, arguments: &[&str]) -> Output {
    let mut command = command(arguments);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    watch.output(&mut command).expect("the program")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _absent = std::fs::remove_dir_all(&folder);
    folder
}

#[test]
fn boards_are_listed_with_their_logs_and_a_dead_link_is_no_end() {
    with_time("a list of boards", |watch| {
        let board = Board::start(make(4, 11), watch);
        let (link, dead) = (board.link(), "serial:/dev/no-such-port");
        let said = watched(
            watch,
            &["devices", "--boards", "--link", dead, "--link", &link, "--light", "4"],
        );
        assert_eq!(said.status.code(), Some(1), "{said:?}");
        assert!(
            text(&said.stderr).contains("no board can be used on /dev/no-such-port"),
            "{said:?}"
        );
        let said = text(&said.stdout);
        let parts = [
            "it is not there",
            "board 4 ",
            "F4..D#5",
            "simulated fingers",
            "never armed",
            "it blinks for ",
        ];
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
        let absent = ["--light", "5", "--mute", "A0"];
        let said =
            watched(watch, &[&["devices", "--boards", "--link", &link], &absent[..]].concat());
        assert_eq!(said.status.code(), Some(1), "{said:?}");
        let said = text(&said.stderr);
        let parts = ["no board has the number 5", "no board here has the key A0"];
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
        let said = watched(watch, &["devices", "--boards", "--link", &link, "--log", "--json"]);
        let listed: Value = serde_json::from_slice(&said.stdout).expect("JSON");
        let it = &listed[0]["boards"][0];
        assert_eq!(it["uid"], board.uid.to_string());
        assert!(it["log"][0].as_str().expect("a line").ends_with("  light"), "{listed}");
        assert_eq!(it["law_hz"], 10_000);
        assert!(board.stop().board.is_lit());
    });
}

#[test]
fn a_board_is_calibrated_into_a_file_and_the_file_is_not_lost() {
    with_time("the calibration of a simulated board", |watch| {
        let board = Board::start(BoardMake { offset: 500, ..make(3, 2) }, watch);
        let (link, folder) = (board.link(), folder("calibrate"));
        let folder_name = folder.display().to_string();
        let calibrate = ["calibrate", "--link", &link, "--folder", &folder_name];
        let said = watched(watch, &calibrate);
        let (out, err) = (text(&said.stdout), text(&said.stderr));
        assert!(said.status.success(), "{out}{err}");
        assert!(err.contains(": G3, 1 of 2 keys done"), "{err}");
        assert!(out.contains("  F#3        500") && out.contains("  10.1"), "{out}");
        let path = file::path(&folder, board.uid);
        let keys = file::read(&path, board.uid, 2).expect("a good file").expect("a file");
        for key in keys.as_slice() {
            assert!((key.rest.get() - 500).abs() <= 2, "{key:?}");
            assert!((10.15e-3..10.20e-3).contains(&key.travel()), "{key:?}");
            assert!((0.10..0.14).contains(&key.friction), "{key:?}");
        }
        // Without a terminal for a question, the command overwrites nothing.
        let said = watched(watch, &calibrate);
        let err = text(&said.stderr);
        assert_eq!(said.status.code(), Some(2), "{err}");
        assert!(err.contains("would be overwritten; give --yes"), "{err}");
        let said = watched(watch, &[&calibrate[..], &["--yes", "--json", "--board", "3"]].concat());
        assert!(said.status.success(), "{}", text(&said.stderr));
        let written: Value = serde_json::from_slice(&said.stdout).expect("JSON");
        assert_eq!(written[0]["keys"][1]["key"], "G3");
        assert!(file::backup(&path).exists());
    });
}

#[test]
fn what_a_key_renders_is_said_beside_the_theory_and_no_file_is_written() {
    with_time("the range of a key", |watch| {
        let board = Board::start(make(3, 2), watch);
        let (link, folder) = (board.link(), folder("range"));
        let name = folder.display().to_string();
        let range = ["calibrate", "--range", "--link", &link, "--folder", &name];
        let said = watched(watch, &[&range[..], &["--key", "G3", "--json"]].concat());
        assert!(said.status.success(), "{}", text(&said.stderr));
        let found: Value = serde_json::from_slice(&said.stdout).expect("JSON");
        assert_eq!(found["key"], "G3");
        let spring = &found["objects"][0];
        assert!(spring["object"] == "spring" && spring["unit"] == "N/m", "{found}");
        // By theory 2 kN/m for 1 N·s/m at 1 kHz without delay; this link has some.
        assert!(spring["passive"].as_f64().is_some_and(|it| it < 2e3), "{found}");
        assert!(!folder.exists());
        for (wrong, advice) in [
            (["--key", "A0"], "no board has the key A0; `letoff devices --boards"),
            (["--key", "H9"], "`H9` is no key: give a note from A0 to C8"),
            (["--weight", "50"], "cannot be used with"),
            (["--board", "9"], "no board has the number 9"),
        ] {
            let said = watched(watch, &[&range[..], &wrong].concat());
            assert_eq!(said.status.code(), Some(2), "{said:?}");
            assert!(text(&said.stderr).contains(advice), "{said:?}");
        }
        assert!(board.stop().board.is_safe());
    });
}

#[test]
fn a_key_that_jams_is_named_and_the_other_board_gets_its_file() {
    with_time("the calibration of a key that jams", |watch| {
        let mut jams = make(0, 1);
        jams.rig.key.stiction = 3.0;
        let (board, good) = (Board::start(jams, watch), Board::start(make(1, 1), watch));
        let folder = folder("jams");
        let (link, good_link) = (board.link(), good.link());
        let links = ["calibrate", "--link", &link, "--link", &good_link];
        let said =
            watched(watch, &[&links[..], &["--folder", &folder.display().to_string()]].concat());
        let err = text(&said.stderr);
        assert_eq!(said.status.code(), Some(1), "{err}");
        assert!(
            err.contains("A0 of board 0 on /dev/pts/") && err.contains("does not move"),
            "{err}"
        );
        assert!(err.contains("none of its 1 keys was measured, no file written"), "{err}");
        assert!(!file::path(&folder, board.uid).exists());
        assert!(file::path(&folder, good.uid).exists());
        let said = watched(watch, &["calibrate", "--link", &link, "--board", "9"]);
        let advice = format!("no board has the number 9; `letoff devices --boards --link {link}@");
        assert!(text(&said.stderr).contains(&advice), "{said:?}");
        let said = watched(watch, &["calibrate", "--link", &link, "--weight", "50"]);
        assert!(text(&said.stderr).contains("needs somebody at a terminal"), "{said:?}");
    });
}

#[test]
fn a_scene_that_cannot_fit_is_refused_before_a_link_is_opened() {
    let folder = folder("overload");
    std::fs::create_dir_all(&folder).expect("a folder");
    let board = |n: usize| {
        let (first, last) = (21 + 11 * n, 31 + 11 * n);
        format!("[[links.bus.board]]\nnumber = {n}\nkeys = \"{first}..{last}\"\n")
    };
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
        let parts = ["no-such-can (CAN FD at 1/5 Mbit/s)", "would take 195.3 %", "lower the rates"];
        assert!(parts.iter().all(|part| err.contains(part)), "{err}");
        assert!(!err.contains("cannot be opened"), "{err}");
    }
    assert_eq!(letoff(&["plan", &path]).status.code(), Some(2));
}

#[test]
fn a_run_on_a_board_reports_its_link() {
    with_time("a run on a simulated board", |watch| {
        let board = Board::start(make(2, 11), watch);
        let link = board.link();
        let arguments =
            ["run", "--link", &link, "--performance", "none", "--duration", "1", "--json"];
        let said = watched(watch, &arguments);
        assert!(said.status.success(), "{}", text(&said.stderr));
        let report: Value = serde_json::from_slice(&said.stdout).expect("JSON");
        let line = &report["lines"][0];
        assert_eq!(
            (line["name"].as_str(), line["state"].as_str()),
            (board.port.to_str(), Some("active"))
        );
        assert!(200.0 < line["seen_hz"].as_f64().expect("a rate"), "{line}");
        assert!(line["medium"].is_null() && line["planned_load"].is_null(), "{line}");
    });
}

#[test]
fn keys_without_a_board_have_no_voice_and_no_rows() {
    with_time("voices of four keys", check_four_keys);
}

fn check_four_keys(watch: &WaitWatch) {
    let (board, folder) = (Board::start(make(2, 4), watch), Folder::new("few-keys"));
    let link = board.link();
    let run =
        ["run", "springs", "--link", &link, "--duration", "2", "--json", "--record", "a.mcap"];
    let (code, out, err) = folder.letoff(&run);
    assert_eq!(code, Some(0), "{err}");
    assert!(err.contains("84 keys of the scene have no board: A0 to F#2, B2 to C8\n"), "{err}");
    let report: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(report["voices"], 4);
    assert!(report["work"]["derivatives"].as_u64().is_some_and(|n| 0 < n), "{report}");
    let unplayed = &report["notes"]["unplayed"];
    assert!(unplayed["without_voice"].as_u64().is_some_and(|n| 0 < n), "{unplayed}");
    let recording = Recording::open(folder.join("a.mcap")).expect("a recording");
    let mut rows = BTreeMap::<u32, usize>::new();
    for message in recording.messages() {
        if let Update::Block(block) = message.expect("a message").1 {
            *rows.entry(block.key).or_default() += block.after.len();
        }
    }
    let beyond_first = rows.iter().filter(|(_key, n)| 1 < **n).map(|(key, _n)| *key);
    assert_eq!(beyond_first.collect::<Vec<_>>(), [22, 23, 24, 25], "{rows:?}");
    let (code, out, err) = folder.letoff(&["replay", "a.mcap"]);
    assert_eq!(code, Some(0), "{out}{err}");
}

#[test]
fn requests_concern_the_keys_that_boards_carry() {
    with_time("requests to four keys", check_requests);
}

fn check_requests(watch: &WaitWatch) {
    let (board, folder) = (Board::start(make(2, 4), watch), Folder::new("few-keys-asked"));
    let scene = |instrument: &str| {
        let port = board.port.display();
        let text = format!(
            "[[keys]]\nrange = \"A0..C8\"\ninstrument = \"{instrument}\"\n[midi]\noutput = \"none\"\n\
             [links]\nkind = \"boards\"\n[[links.bus]]\nserial = \"{port}\"\n"
        );
        folder.write("few.toml", text);
    };
    scene("grand-springs");
    let run = ["run", "few.toml", "--black-box", "none", "--duration", "60"];
    let mut host = watch.guard(start(&folder, &run));
    let says = |words: &str| {
        eventually(words, || folder.read("complaints").contains(words).then_some(()));
    };
    says("4 voices at 1000 Hz on boards");
    let status = || -> Value {
        let (_code, out, _err) = folder.letoff(&["status", "--json"]);
        serde_json::from_str(&out).expect("JSON")
    };
    let is_asleep = |it: &Value| it["state"] == "playing" && it["asleep"] == 4;
    let asleep = eventually("four keys sleep", || Some(status()).filter(is_asleep));
    assert_eq!(asleep["voices"], 4, "{asleep}");
    let answers = |arguments: &[&str], words: &str| {
        assert_eq!(folder.letoff(arguments).1, format!("{words}\n"), "{arguments:?}");
    };
    answers(&["instruments", "use", "spring-wall"], "4 keys are now spring-wall");
    answers(&["instruments", "use", "spring", "--keys", "A0..G2"], "1 keys are now spring");
    answers(&["set", "render.passivity=control"], "render.passivity=control");
    let none = ["instruments", "use", "spring", "--keys", "C4..B4"];
    folder.refuses(&none, 2, &["no board carries C4 to B4\n"]);
    folder.refuses(&["press", "C4"], 2, &["no board carries C4\n"]);
    folder.refuses(&["press", "G2"], 2, &["these keys are real"]);
    scene("spring-wall");
    let pid = Pid::from_child(&host);
    kill_process(pid, Signal::HUP).expect("it is there");
    says("SIGHUP: the scene was read again: 4 keys changed");
    kill_process(pid, Signal::INT).expect("it is there");
    assert!(host.wait().expect("it ends").success(), "{}", folder.read("complaints"));
}

#[test]
fn boards_that_cannot_be_as_typed_are_refused() {
    let check = |arguments: &[&str], words: &str| {
        let said = letoff(&[&["board"], arguments].concat());
        let err = text(&said.stderr);
        assert_eq!((said.status.code(), err.contains(words)), (Some(2), true), "{err}");
    };
    let fates = ["--count", "2", "--fate", "9@0:die", "--fate", "3@1:die"];
    check(&fates, "--fate 9@0: there is no board 9\nletoff: --fate 3@1: there is no board 3; give");
    check(&["--links", "/proc/x", "--duration", "1"], "/proc/x cannot be made");
    check(&["--links", "x", "--on", "can:vcan0"], "cannot be used with");
    check(&["--strength=-1"], "`-1` is no ratio");
    check(&["--strength", "-1"], "`-1` is no ratio");
    check(&["--drift", "nan"], "`nan` is not a number");
    check(&["--seed", "7"], "required");
}

#[test]
fn a_program_learns_at_once_where_boards_are() {
    let wire = ["--loss", "0.1", "--baud", "1000000", "--seed", "7"];
    let said = letoff(&[&["board", "--json", "--duration", "0.1"], &wire[..]].concat());
    let out = text(&said.stdout);
    let (places, report) = out.split_once('\n').expect("a line and a report");
    let places: Value = serde_json::from_str(places).expect("a line of JSON");
    let report: Value = serde_json::from_str(report).expect("a report as JSON");
    assert!(places["boards"][0]["link"].as_str().expect("a link").starts_with("serial:/dev/pts/"));
    assert_eq!(places["boards"][0]["link"], report[0]["link"]);
}

#[test]
fn names_of_boards_are_gone_after_them_and_a_file_of_that_name_stays() {
    for signal in [Signal::TERM, Signal::INT] {
        let folder = Folder::new("board-names");
        let mut boards = start(&folder, &["board", "--count", "2", "--links", "names"]);
        let names = ["names/board0", "names/board1"].map(|name| folder.join(name));
        eventually("names", || names.iter().all(|name| name.exists()).then_some(()));
        kill_process(Pid::from_child(&boards), signal).expect("it is there");
        assert!(boards.wait().expect("it ends").success());
        assert!(!names.iter().any(|name| name.is_symlink()), "{signal:?}");
        std::fs::write(&names[1], "not a link").expect("a file");
        let board = ["board", "--count", "2", "--links", "names", "--duration", "0.1"];
        folder.refuses(&board, 2, &["names/board1 cannot be made", "exists"]);
        assert_eq!(folder.read("names/board1"), "not a link");
        assert!(!names[0].is_symlink());
    }
}

#[test]
fn a_plan_without_links_says_what_it_needs() {
    let needs = "the scene \"default\" has no boards: give --link";
    Folder::new("plan").refuses(&["plan"], 2, &[needs]);
    assert!(text(&letoff(&["plan", "--help"]).stdout).contains("has no links: give it --link"));
}

#[test]
fn all_links_that_cannot_be_opened_are_said_at_once() {
    let links = ["--link", "serial:/dev/no-such-1", "--link", "serial:/dev/no-such-2"];
    for command in ["run", "calibrate"] {
        let said = letoff(&[&[command], &links[..]].concat());
        let err = text(&said.stderr);
        assert_eq!(said.status.code(), Some(1), "{err}");
        assert!(err.contains("no-such-1") && err.contains("no-such-2"), "{err}");
    }
}

/// Starts `letoff` in `folder`, with stderr in the file `complaints`.
fn start(folder: &Folder, arguments: &[&str]) -> Child {
    let mut command = folder.command(Path::new(env!("CARGO_BIN_EXE_letoff")), arguments);
    command.stdout(Stdio::null()).stderr(File::create(folder.join("complaints")).expect("a file"));
    command.spawn().expect("a process")
}

#[test]
fn a_headless_host_says_what_becomes_of_its_boards_and_who_stops_it() {
    with_time("the log of a headless host", |watch| {
        let (board, folder) = (Board::start(make(2, 11), watch), Folder::new("headless"));
        let link = board.link();
        let listen = ["--listen", "127.0.0.1:0", "--black-box", "none"];
        let run = ["run", "--link", &link, "--performance", "none", "--midi", "none"];
        let mut host = watch.guard(start(&folder, &[&run[..], &listen].concat()));
        let complaints = || folder.read("complaints");
        let says = |words: &str| eventually(words, || complaints().contains(words).then_some(()));
        says("letoff: plays \"default\": 11 voices at 1000 Hz on boards on 1 links; MIDI: none\n");
        says("letoff: streams at ws://127.0.0.1:");
        says(&format!("letoff: board 2 on {}, G2 to F3: armed\n", board.port.display()));
        let (code, out, _others) = folder.letoff(&["stop"]);
        assert_eq!(code, Some(0));
        assert!(out.starts_with("stopped: 1 of 1 boards were told"), "{out}");
        assert!(host.wait().expect("it ends").success(), "{}", complaints());
        says("letoff: stop asked for by `letoff stop`\n");
        assert!(complaints().lines().all(|line| line.starts_with("letoff: ")), "{}", complaints());
        assert_eq!(board.stop().board.safe_reason(), safe_reason::EMERGENCY_STOP);
    });
}

#[test]
fn calibration_is_stopped_as_a_run_is() {
    with_time("the end of a calibration", |watch| {
        let ends =
            [(None, safe_reason::EMERGENCY_STOP), (Some(Signal::TERM), safe_reason::DISARMED)];
        for (signal, reason) in ends {
            let (board, folder) =
                (Board::start(make(3, 2), watch), Folder::new("calibrate-stopped"));
            let (link, files) = (board.link(), folder.display().to_string());
            let calibrate = ["calibrate", "--link", &link, "--folder", &files];
            let mut calibrate = watch.guard(start(&folder, &calibrate));
            eventually("a socket", || folder.socket().exists().then_some(()));
            // Forces are sent from here on; the progress until then does not matter.
            eventually("it is armed", || board.is_armed().then_some(()));
            match signal {
                None => {
                    let (code, out, _others) = folder.letoff(&["stop"]);
                    assert_eq!(code, Some(0));
                    assert!(out.starts_with("stopped: 1 of 1 boards"), "{out}");
                }
                Some(signal) => {
                    let is_half = || folder.read("complaints").contains("1 of 2 keys done");
                    eventually("a key", || is_half().then_some(()));
                    let id = i32::try_from(calibrate.id()).ok().and_then(Pid::from_raw);
                    kill_process(id.expect("a process"), signal).expect("it is there");
                }
            }
            assert_eq!(calibrate.wait().expect("it ends").code(), Some(1));
            let complaints = folder.read("complaints");
            assert!(complaints.contains("stopped at board 3"), "{signal:?}: {complaints}");
            let path = file::path(&folder, board.uid);
            assert!(!path.exists());
            let kept =
                file::load_partial(&file::partial(&path), board.uid, 2).expect("a good file");
            let known = kept.map(|it| it.keys.as_slice().iter().map(Option::is_some).collect());
            assert_eq!(known, signal.map(|_| vec![true, false]), "{complaints}");
            assert_eq!(board.stop().board.safe_reason(), reason, "{signal:?}");
        }
    });
}
