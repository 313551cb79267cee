//! The state of the host in the window: its pill, its boards, its end and its restart.

use std::fs::{self, Permissions};
use std::io::Write as _;
use std::os::unix::fs::PermissionsExt as _;
use std::time::{Duration, Instant};

use dashboard::Pane;
use dashboard::open::WindowTarget;
use eframe::egui::accesskit::Role;

use super::program::{HostProgram, Program};
use super::user::UserWindow;
use crate::letoff::folder;

/// Time after its restart within which a host is live in the window.
const LIVE: Duration = Duration::from_secs(5);

const BUSY: Duration = Duration::from_secs(25);

/// Prints a time above `wanted`, and panics above [`BUSY`].
fn judge(what: &str, took: Duration, wanted: Duration) {
    assert!(took < BUSY, "{what} after {took:.1?}");
    if wanted < took {
        let text = format!("{what} after {took:.1?} instead of {wanted:?}: was this machine busy?");
        let _closed = writeln!(std::io::stderr(), "{text}");
    }
}

fn stop(window: &mut UserWindow) {
    window.click("  STOP  ");
    window.wait("confirmation", |window| window.says("STOPPED"));
    window.wait("end of the host", |window| window.says("Stopped") || window.says("No host"));
}

#[test]
fn a_restarted_host_is_live_again_by_its_socket() {
    let mut host = HostProgram::start("window-restart", &["--performance", "none"]);
    let mut window = UserWindow::open(&WindowTarget::Socket(host.socket()));
    window.wait("a host", |window| window.has("Playing"));
    stop(&mut window);
    host.kill();
    for _crash in 0..2 {
        host.start_again();
        let begun = Instant::now();
        window.wait("the next host", |window| window.has("Playing"));
        judge("live", begun.elapsed(), LIVE);
        assert!(!window.says("STOPPED"), "another host was not stopped");
        host.kill();
        window.wait("the loss", |window| window.has("No host"));
    }
}

#[test]
fn the_banner_of_a_stop_ends_when_a_host_runs_that_rejects_the_window() {
    let mut host = HostProgram::start("window-refused", &["--performance", "none"]);
    let mut window = UserWindow::open(&host.target());
    window.app().show_only(Pane::Tuning);
    window.wait("a host", |window| window.has("Playing"));
    stop(&mut window);
    host.kill();
    // It has another secret.
    host.start_again();
    window.wait("the refusal", |window| window.has("Refused"));
    assert!(window.has("A HOST RUNS AGAIN") && !window.says("STOPPED"));
    assert!(window.says("does not know the given token"));
}

#[test]
fn a_rehearsal_is_counted_and_every_panel_names_it() {
    let host = HostProgram::start_scene("window-rehearsal", "default", &[]);
    let mut window = UserWindow::open(&host.target());
    window.app().show_only(Pane::Tuning);
    window.wait("strokes", |window| window.says("Rehearsing") && !window.says("Rehearsing 0"));
    assert!(window.says("The host rehearses its piece"), "{:?}", window.texts());
    window.app().show_only(Pane::Log);
    window.wait("the log", |window| window.says("client 1 (owner) at 127.0.0.1 has come"));
}

#[test]
fn the_end_of_a_piece_is_no_error() {
    let host = HostProgram::start("window-over", &["--performance", "none", "--duration", "2"]);
    let mut window = UserWindow::open(&host.target());
    window.wait("the end", |window| window.has("Piece over"));
    window.app().show_only(Pane::Log);
    window.settle();
    assert!(window.has("Piece over") && !window.says("Connection refused"));
}

#[test]
fn a_viewer_changes_nothing_and_no_message_moves_a_panel() {
    const VIEWER: &str = "see-0123456789abcdef";
    let tokens = folder("window-viewer").join("tokens");
    fs::write(&tokens, format!("viewer {VIEWER}\nowner own-0123456789abcdef\n")).expect("a file");
    fs::set_permissions(&tokens, Permissions::from_mode(0o600)).expect("a file");
    let host =
        HostProgram::start("window-viewer", &["--performance", "none", "--tokens", "tokens"]);
    let WindowTarget::Host { address, .. } = host.target() else { panic!("a host") };
    let mut window = UserWindow::open(&WindowTarget::of(&address, Some(VIEWER.into()), None));
    window.app().show_grid(vec![Pane::Overview, Pane::Keyboard]);
    window.wait("its role", |window| window.has("Playing · viewer"));
    window.wait("keys", |window| window.has("press C4") && window.says("keys are well"));
    assert!(window.is_disabled(Role::Button, "press C4"));
    assert!(window.is_disabled(Role::Button, "Record"));
    let places = |window: &UserWindow| ["key C4", "press C4"].map(|name| window.rect(name));
    let before = places(&window);
    stop(&mut window);
    assert_eq!(places(&window), before, "panels moved");
}

#[test]
fn a_board_that_dies_is_named_on_the_keyboard() {
    let place = folder("window-boards");
    let fate = ["--fate", "1@4:die"];
    let count = ["board", "--count", "2", "--links", "links", "--duration", "300"];
    let _boards = Program::start(&place, "boards", &[&count[..], &fate].concat());
    let links = ["serial:links/board0", "serial:links/board1"];
    let begun = Instant::now();
    while !place.join("links/board1").exists() {
        assert!(begun.elapsed() < BUSY, "no boards");
        std::thread::park_timeout(Duration::from_millis(20));
    }
    let arguments = ["--performance", "none", "--link", links[0], "--link", links[1]];
    let host = HostProgram::start("window-boards", &arguments);
    let mut window = UserWindow::open(&host.target());
    window.app().show_only(Pane::Overview);
    window.wait("keys without a board", |window| window.says("no board"));
    let mut logged = None;
    window.wait("the silent board", |window| {
        if logged.is_none() && host.log().contains("links/board1: silent") {
            logged = Some(Instant::now());
        }
        window.text_with("have no force").is_some_and(|it| it.contains("links/board1 silent"))
    });
    judge("named", logged.map_or(Duration::ZERO, |it| it.elapsed()), Duration::from_secs(1));
    assert!(window.says("key A1, no force: board 1 on"), "{:?}", window.texts());
    window.app().show_only(Pane::Log);
    window.wait("the log", |window| window.says("links/board1: silent"));
}
