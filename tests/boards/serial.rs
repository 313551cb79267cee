//! Pseudo-terminals and the real serial driver.

use std::path::Path;
use std::time::Duration;

use crate::letoff;
use crate::machine_time::{Guarded, WaitWatch, judged_with_time, with_time};
use crate::rig::{
    Boards, arguments, check_exchange, count, had_time, machine, number, print_figures, report,
    run, run_watched, wait_for,
};

/// A host in the middle of its piece: the tick's thread exists once the rehearsal is over.
fn playing(watch: &WaitWatch, folder: &Path, links: &[String]) -> Guarded {
    let host = watch.guard(letoff::start(folder, &arguments(links, &["--duration", "20"])));
    let tasks = format!("/proc/{}/task", host.id());
    let is_tick = |task: std::io::Result<std::fs::DirEntry>| {
        let name = task.and_then(|task| std::fs::read_to_string(task.path().join("comm")));
        name.is_ok_and(|name| name.trim() == "letoff-tick")
    };
    wait_for("the host's tick", || {
        std::fs::read_dir(&tasks).is_ok_and(|mut tasks| tasks.any(is_tick))
    });
    std::thread::sleep(Duration::from_secs(3));
    host
}

fn boards_of_a_killed_host(watch: &WaitWatch, folder: &Path) -> (Boards, Vec<String>) {
    let boards = Boards::watched(watch, folder, 8, &[]);
    let links = boards.links();
    let mut host = playing(watch, folder, &links);
    host.kill().expect("it lives");
    let _killed = host.wait();
    (boards, links)
}

/// Largest age of a force that a board may apply (us): validity plus one tick.
const VALID_US: f64 = 21e3;

#[test]
fn a_piece_is_played_over_eight_ports() {
    let _machine = machine();
    let folder = letoff::folder("boards-piece");
    judged_with_time("a piece over eight ports", |watch| {
        let boards = Boards::watched(watch, &folder, 8, &[]);
        let report = run(watch, &folder, &boards.links(), &["--duration", "8"]);
        let told = boards.stop();
        for board in &told {
            assert!(number(board, "/counts/oldest_us") <= VALID_US, "{board}");
            assert_eq!(count(board, "/counts/corrupt"), 0, "{board}");
            assert!(number(board, "/force_while_safe_n") < 1e-3, "{board}");
        }
        if !had_time(&report, &told) {
            return None;
        }
        print_figures("eight ports, 88 keys", &report);
        check_exchange(&report, 0..8);
        assert!(5 < count(&report, "/notes/played"), "{report}");
        assert_eq!(count(&report, "/notes/struck"), count(&report, "/notes/played"), "{report}");
        assert_eq!(count(&report, "/notes/extra"), 0, "{report}");
        assert_eq!(count(&report, "/links/gaps"), 0, "{report}");
        assert_eq!(count(&report, "/links/refused"), 0, "{report}");
        // Unreported stolen time counts as own work: up to a third of the reported time.
        let own_work = count(&report, "/deadline/missed_own_work");
        let told = count(&report, "/deadline/missed_woken_late")
            + count(&report, "/deadline/missed_preempted");
        assert!(own_work <= count(&report, "/ticks") / 1000 + told / 3, "{report}");
        Some(())
    });
}

#[test]
fn bytes_that_are_lost_or_flipped_cost_frames_and_never_a_force() {
    let _machine = machine();
    let folder = letoff::folder("boards-noise");
    with_time("links with lost and flipped bytes", |watch| {
        let boards = Boards::watched(watch, &folder, 2, &["--loss", "0.001", "--flip", "0.001"]);
        let report = run(watch, &folder, &boards.links(), &["--duration", "4"]);
        // A frame of 43 bytes is hit with a probability of 8 %.
        assert!(20 < count(&report, "/links/gaps"), "{report}");
        assert!(20 < count(&report, "/links/refused"), "{report}");
        for board in boards.stop() {
            assert!(20 < count(&board, "/counts/corrupt"), "{board}");
            assert!(number(&board, "/counts/oldest_us") <= VALID_US, "{board}");
            assert!(500 < count(&board, "/counts/forces"), "{board}");
        }
    });
}

#[test]
fn a_host_that_is_killed_leaves_every_board_without_force_and_latched() {
    let _machine = machine();
    let folder = letoff::folder("boards-killed");
    with_time("boards of a host that was killed", |watch| {
        let (boards, _links) = boards_of_a_killed_host(watch, &folder);
        std::thread::sleep(Duration::from_millis(500));
        for board in boards.stop() {
            assert_eq!(board["state"], "its forces expired", "{board}");
            assert!(number(&board, "/force_n") < 1e-3, "{board}");
            assert!(number(&board, "/force_while_safe_n") < 1e-3, "{board}");
            assert!(100 < count(&board, "/counts/forces"), "{board}");
            // 10 ms of fading, the motor's lag, and the wake-up of the boards' own process.
            assert!(number(&board, "/quiet_after_ms") < 60.0, "{board}");
        }
    });
}

#[test]
fn after_a_kill_the_next_host_arms_the_boards_and_plays() {
    let _machine = machine();
    let folder = letoff::folder("boards-again");
    with_time("the next host after a kill", |watch| {
        let (boards, links) = boards_of_a_killed_host(watch, &folder);
        let report = run(watch, &folder, &links, &["--duration", "4"]);
        assert!(report["boards"].as_array().is_some_and(|it| it.len() == 8), "{report}");
        assert!(1 < count(&report, "/notes/struck"), "{report}");
        for board in boards.stop() {
            assert!(2 <= count(&board, "/counts/armings"), "{board}");
        }
    });
}

#[test]
fn a_board_that_dies_leaves_the_others_playing() {
    let _machine = machine();
    let folder = letoff::folder("boards-dies");
    // Board 0 plays nothing, boards 3 and 4 play much.
    judged_with_time("a board dies", |watch| {
        let boards =
            Boards::watched(watch, &folder, 8, &["--fate", "0@3:die", "--fate", "7@3:mute=0.3"]);
        let report = run(watch, &folder, &boards.links(), &["--duration", "8"]);
        let told = boards.stop();
        if !had_time(&report, &told) {
            return None;
        }
        let trips: Vec<_> = told[1..7].iter().map(|it| count(it, "/counts/trips")).collect();
        assert_eq!(trips, [0; 6], "{told:?}");
        check_exchange(&report, 1..7);
        assert_eq!(count(&report, "/notes/struck"), count(&report, "/notes/played"), "{report}");
        assert_eq!(count(&report, "/notes/extra"), 0, "{report}");
        let state = |n: usize| report["boards"][n]["state"].clone();
        assert_ne!(state(0), "armed", "{report}");
        assert!((1..8).all(|n| state(n) == "armed"), "{report}");
        assert_eq!(count(&report["boards"][7], "/rearmed"), 1, "{report}");
        let gaps: Vec<_> = (1..7).map(|n| count(&report["boards"][n], "/gaps")).collect();
        assert_eq!(gaps, [0; 6], "{report}");
        Some(())
    });
}

#[test]
fn a_board_that_is_stopped_stays_stopped() {
    let _machine = machine();
    let folder = letoff::folder("boards-fault");
    with_time("a board whose key fails", |watch| {
        let boards = Boards::watched(watch, &folder, 2, &["--fate", "1@1:key-fault"]);
        let links = boards.links();
        let more = ["--duration", "4", "--performance", "none"];
        let said = run_watched(watch, &folder, &arguments(&links, &more));
        let report = report(&said);
        assert_eq!(report["boards"][1]["state"], "a key, motor or sensor failed", "{report}");
        assert_eq!(report["boards"][0]["state"], "armed", "{report}");
        // The host reports it when it happens, and again in the end.
        let sentence = format!("board 1 on {}: a key,", links[3].trim_start_matches("serial:"));
        assert_eq!(said.err.matches(&sentence).count(), 2, "{said:?}");
        assert_eq!(report["boards"][0]["calibrated"], false, "{report}");
        letoff::check_words(
            &said,
            &["no calibration file: board 0 on", "`letoff calibrate --link"],
        );
        let told = boards.stop();
        assert_eq!(count(&told[1], "/counts/armings"), 1, "{told:?}");
        assert!(number(&told[1], "/force_while_safe_n") < 1e-3, "{told:?}");
    });
}

#[test]
fn a_clock_that_runs_backwards_is_noticed_and_learned_anew() {
    let _machine = machine();
    let folder = letoff::folder("boards-clock");
    with_time("a clock that runs backwards", |watch| {
        let fates = ["--fate", "0@1.5:backwards=2", "--drift", "5000"];
        let boards = Boards::watched(watch, &folder, 1, &fates);
        let more = ["--duration", "5", "--performance", "none"];
        let report = run(watch, &folder, &boards.links(), &more);
        let board = &report["boards"][0];
        assert!(1 <= count(board, "/clock_jumps"), "{report}");
        assert_eq!(board["state"], "armed", "{report}");
        let drift = number(board, "/drift_ppm");
        // Round trips are known to half a tick, over the 3 s since.
        assert!((drift - 5000.0).abs() < 1e3, "{drift} ppm");
    });
}

#[test]
fn a_board_that_starts_anew_is_armed_again() {
    let _machine = machine();
    let folder = letoff::folder("boards-restart");
    with_time("a board that starts again", |watch| {
        let boards = Boards::watched(watch, &folder, 2, &["--fate", "1@1.5:restart=0.5"]);
        let more = ["--duration", "5", "--performance", "none"];
        let report = run(watch, &folder, &boards.links(), &more);
        assert_eq!(report["boards"][1]["state"], "armed", "{report}");
        assert_eq!(count(&report["boards"][1], "/rearmed"), 1, "{report}");
        assert_eq!(count(&report["boards"][0], "/rearmed"), 0, "{report}");
    });
}

#[test]
fn an_emergency_stop_takes_every_force_away_and_is_latched() {
    let _machine = machine();
    let folder = letoff::folder("boards-stop");
    with_time("an emergency stop", |watch| {
        let boards = Boards::watched(watch, &folder, 2, &[]);
        let links = boards.links();
        let host = playing(watch, &folder, &links);
        let said = run_watched(watch, &folder, &["stop"]);
        assert_eq!(said.code, Some(0), "{said:?}");
        let said = letoff::end(host.into_child());
        assert_eq!(said.code, Some(0), "{said:?}");
        let report = said.report();
        assert_eq!(report["stopped"], true, "{report}");
        for _ in 0..2 {
            let said = run_watched(watch, &folder, &arguments(&links, &["--performance", "none"]));
            assert_eq!(said.code, Some(1), "{said:?}");
            assert!(said.err.contains("everything was stopped"), "{said:?}");
        }
        for board in boards.stop() {
            assert_eq!(board["state"], "everything was stopped", "{board}");
            assert!(number(&board, "/force_n") < 1e-3, "{board}");
        }
    });
}
