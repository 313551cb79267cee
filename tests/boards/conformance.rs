//! `letoff devices --boards --test` on three boards that share no code: each fault is named.

use std::path::Path;

use serde_json::Value;

use crate::cortex::{Processor, build, has_tools};
use crate::letoff;
use crate::machine_time::{Task, WaitWatch, judged_with_time, with_time};
use crate::python::PythonBoard;
use crate::rig::{Boards, count, machine, number, part_of_machine, run_watched, side_by_side};

fn tested(watch: &WaitWatch, folder: &Path, link: &str, depth: &str) -> [Vec<String>; 2] {
    let test = format!("--test={depth}");
    let devices = ["devices", "--boards", "--json", &test, "--link", link];
    let said = run_watched(watch, folder, &devices);
    let report = said.report();
    let items = report[0]["items"].as_array().unwrap_or_else(|| panic!("{said:?}"));
    let with = |outcome: &str| {
        let found = items.iter().filter(|it| it["outcome"] == outcome);
        found.map(|it| format!("{}: {}", it["item"], it["seen"])).collect::<Vec<_>>()
    };
    let broken = with("broken");
    assert_eq!(said.code, Some(i32::from(!broken.is_empty())), "{said:?}");
    let announced = if depth == "quiet" { "no board is armed" } else { "0.05 N" };
    letoff::check_words(&said, &[announced]);
    [broken, with("kept")]
}

/// Words of items that a machine without time breaks for a board that lives on it.
const TIMED: [&str; 5] =
    ["at the rate", "times of samples", "fresh", "within 20 ms", "silence takes the forces"];

struct Started<B> {
    board: B,
    task: Task,
    link: String,
}

fn check_kept<B>(folder: &Path, n: usize, start: impl Fn() -> Started<B>, end: impl Fn(B)) {
    judged_with_time("a conforming board", |watch| {
        let Started { board, task, link } = start();
        watch.add(task);
        let [mut broken, kept] = tested(watch, folder, &link, "stop");
        end(board);
        if broken.is_empty() {
            assert!(n <= kept.len(), "{kept:?}");
            return Some(());
        }
        broken.retain(|it| !TIMED.iter().any(|words| it.contains(words)));
        assert!(broken.is_empty(), "{broken:?}");
        None
    });
}

#[test]
fn a_simulated_board_keeps_every_item_and_is_asked_for_no_force_unless_it_is_armed() {
    let _machine = machine();
    let folder = letoff::folder("conformance-simulated");
    let start = || {
        let board = Boards::start(&folder, 1, &[]);
        Started { task: board.task(), link: board.links().remove(1), board }
    };
    let end = |boards: Boards| {
        let told = boards.stop();
        assert_eq!(told[0]["state"], "everything was stopped", "{told:?}");
        assert!(number(&told[0], "/force_while_safe_n") < 1e-3, "{told:?}");
    };
    check_kept(&folder, 22, start, end);
    with_time("a board that is not armed", |watch| {
        let Started { board, task, link } = start();
        watch.add(task);
        let [_broken, kept] = tested(watch, &folder, &link, "quiet");
        assert!(9 < kept.len(), "{kept:?}");
        let told = board.stop();
        let counts = ["/counts/forces", "/counts/armings"].map(|path| count(&told[0], path));
        assert_eq!(counts, [0, 0]);
    });
}

#[test]
fn the_reference_firmware_keeps_every_item() {
    if !has_tools() {
        return;
    }
    let _machine = machine();
    let folder = letoff::folder("conformance-cortex");
    let elf = build(&folder, 3);
    let start = || {
        let board = Processor::start(&elf);
        Started { task: board.task(), link: format!("serial:{}", board.port), board }
    };
    check_kept(&folder, 20, start, drop);
}

const BROKEN: [(&[&str], &str, &[&str]); 16] = [
    (&["--drift", "50000"], "quiet", &["its clock"]),
    (&["--wrong", "flag"], "arm", &["an armed board says so"]),
    (&["--wrong", "key-less"], "quiet", &["samples come at the rate"]),
    (&["--wrong", "wrong-nonce"], "arm", &["an armed board says so"]),
    (&["--wrong", "any-nonce"], "arm", &["Arm with another nonce"]),
    (&["--wrong", "no-ping"], "quiet", &["within 20 ms", "its clock"]),
    (&["--wrong", "late-replies"], "quiet", &["within 20 ms"]),
    (&["--wrong", "late"], "quiet", &["samples are fresh"]),
    (&["--wrong", "no-watchdog"], "arm", &["silence takes the forces away"]),
    (&["--wrong", "no-crc"], "quiet", &["wrong checksum"]),
    (&["--wrong", "mute-unknown"], "quiet", &["unknown operation"]),
    (&["--wrong", "stuck-stamp"], "quiet", &["the times of samples"]),
    (&["--wrong", "stuck-sequence"], "quiet", &["the numbers of samples"]),
    (&["--wrong", "twice"], "quiet", &["the numbers of samples"]),
    (&["--wrong", "unlatched"], "stop", &["a stop is for good"]),
    (&["--say", "quantum_nm=0"], "quiet", &["the values of its hello"]),
];

#[test]
fn a_board_written_from_the_document_keeps_every_item_and_each_fault_is_named() {
    let _machine = machine();
    let folder = letoff::folder("conformance-python");
    let Some(board) = PythonBoard::start(&folder, &[]) else { return };
    drop(board);
    let start = || {
        let board = PythonBoard::start(&folder, &[]).expect("there is Python");
        Started { task: board.task(), link: board.link.clone(), board }
    };
    let end = |board: PythonBoard| {
        let told = board.stop();
        let most = told["after_mn"].as_array().expect("forces").iter().map(Value::as_u64).max();
        assert_eq!(most, Some(Some(50)), "{told}");
    };
    check_kept(&folder, 22, start, end);
    // A busy machine breaks more items and mends none, so several run at a time.
    side_by_side(&folder, 4, &BROKEN, |folder, (arguments, depth, items)| {
        with_time(&format!("a board that breaks {items:?}"), |watch| {
            let board = PythonBoard::start(folder, arguments).expect("there is Python");
            watch.add(board.task());
            let [broken, _kept] = tested(watch, folder, &board.link, depth);
            for item in *items {
                assert!(broken.iter().any(|it| it.contains(item)), "{arguments:?}: {broken:?}");
            }
        });
    });
}

#[test]
fn boards_that_fail_or_whose_link_is_bad_break_items() {
    let _machine = machine();
    let folder = letoff::folder("conformance-fates");
    let fates = [
        (&["--fate", "0@0.2:key-fault"][..], "silence takes the forces away"),
        (&["--fate", "0@0.2:mute=2"], "forces that answer samples"),
        (&["--drift", "-40000"], "its clock"),
        (&["--say-schema", "1"], "the values of its hello"),
    ];
    side_by_side(&folder, 4, &fates, |folder, (arguments, item)| {
        with_time(&format!("a board that breaks \"{item}\""), |watch| {
            let boards = Boards::watched(watch, folder, 1, arguments);
            let [broken, _kept] = tested(watch, folder, &boards.links()[1], "arm");
            assert!(broken.iter().any(|it| it.contains(item)), "{arguments:?}: {broken:?}");
        });
    });
}

#[test]
fn a_key_is_muted_and_unmuted_and_the_board_says_so() {
    let _machine = part_of_machine();
    let folder = letoff::folder("board-health");
    with_time("the health of a board", |watch| {
        let boards = Boards::watched(watch, &folder, 1, &[]);
        let link = boards.links().remove(1);
        let asked = |more: &[&str]| {
            let all =
                [&["devices", "--boards", "--json", "--health", "--link", &link], more].concat();
            let said = run_watched(watch, &folder, &all);
            (said.code, said.report()[0]["boards"][0].clone())
        };
        let (code, board) = asked(&["--mute", "C1"]);
        let (done, health) = (&board["done"], &board["health"]);
        assert_eq!((code, &health["starts"]), (Some(0), &1.into()), "{health}");
        assert_eq!(done[0], "C1 has its motor off until the board starts anew");
        let muted = |health: &Value| {
            let keys = health["keys"].as_array().expect("keys").clone();
            let muted = keys.into_iter().filter(|it| it["is_muted"] == true);
            muted.map(|it| it["key"].clone()).collect::<Vec<_>>()
        };
        assert_eq!(muted(health), ["C1"], "{health}");
        assert_eq!(muted(&asked(&["--unmute", "C1"]).1["health"]), [""; 0]);
        // A simulation has no bootloader.
        let said =
            run_watched(watch, &folder, &["devices", "--boards", "--bootloader", "--link", &link]);
        assert_eq!(said.code, Some(1), "{said:?}");
        letoff::check_words(&said, &["answered Bootloader with \"impossible\""]);
        drop(boards);
    });
}

#[test]
fn a_setting_is_written_to_one_board_and_holds_from_its_next_start() {
    let _machine = part_of_machine();
    let folder = letoff::folder("board-settings");
    with_time("the settings of a board", |watch| {
        let boards = Boards::watched(watch, &folder, 2, &["--fate", "1@0.1:restart=0.1"]);
        let links = boards.links();
        let of = |more: &[&str], links: &[String]| {
            let links = links.iter().map(String::as_str);
            let all: Vec<_> = ["devices", "--boards"].into_iter().chain(links).collect();
            run_watched(watch, &folder, &[&all[..], more].concat())
        };
        let said = of(&["--set", "number=3"], &links);
        assert_eq!(said.code, Some(1), "{said:?}");
        letoff::check_words(&said, &["settings are written to one board"]);
        let said = of(&["--set", "number=3", "--set", "max_force_mn=9000"], &links[2..]);
        assert_eq!(said.code, Some(0), "{said:?}");
        assert!(said.out.contains("number = 3 from its next start on"), "{said:?}");
        assert!(said.out.contains("max_force_mn = 9000;"), "{said:?}");
        // Arming starts the clock of the board's fault.
        let _armed = tested(watch, &folder, &links[3], "arm");
        let said = of(&["--json"], &links[2..]);
        let report = said.report();
        let board = &report[0]["boards"][0];
        assert_eq!((&board["number"], &board["max_force_n"]), (&3.into(), &9.0.into()), "{report}");
        assert_eq!(board["uid"], "53494d010b00", "it is the same board: {report}");
        drop(boards);
    });
}
