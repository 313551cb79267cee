//! `letoff dash` and its programs: a window, replaced by a script, and a host.

use std::fs::Permissions;
use std::os::unix::fs::PermissionsExt as _;
use std::process::{Child, ExitStatus, Stdio};
use std::sync::{Mutex, PoisonError};

use rustix::process::{Pid, Signal, kill_process, test_kill_process};

use crate::typed::{Folder, eventually};

/// Prints its arguments and process id, and stays open.
const STAYS: &str = "#!/bin/sh
echo \"$@\" >said
echo \"token $LETOFF_TOKEN\" >>said
echo $$ >number.new
mv number.new number
exec sleep 600
";

/// Starts `letoff` with `arguments`; its window is the script `window`. Serialised: a script that
/// is open for writing cannot be run, and a process that starts meanwhile would hold it open.
fn start(folder: &Folder, window: &str, arguments: &[&str]) -> Child {
    static ONE: Mutex<()> = Mutex::new(());
    let _alone = ONE.lock().unwrap_or_else(PoisonError::into_inner);
    // It finds its window beside itself.
    let letoff = folder.join("letoff");
    if !letoff.exists() {
        let built = env!("CARGO_BIN_EXE_letoff");
        std::fs::hard_link(built, &letoff)
            .or_else(|_other_disk| std::fs::copy(built, &letoff).map(drop))
            .expect("the program");
    }
    let window = folder.write("letoff-dashboard", window);
    std::fs::set_permissions(window, Permissions::from_mode(0o755)).expect("a script");
    let mut command = folder.command(&letoff, arguments);
    command.env("PATH", "/usr/bin:/bin").stdout(Stdio::null()).stderr(Stdio::piped());
    command.spawn().expect("a process")
}

fn window(folder: &Folder) -> Pid {
    let number = eventually("a window", || std::fs::read_to_string(folder.join("number")).ok());
    Pid::from_raw(number.trim().parse().expect("a number")).expect("a process")
}

fn signal(child: &Child, signal: Signal) {
    let id = i32::try_from(child.id()).ok().and_then(Pid::from_raw).expect("a process");
    kill_process(id, signal).expect("it is there");
}

fn end(child: Child) -> (ExitStatus, String) {
    let output = child.wait_with_output().expect("it ends");
    (output.status, String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn a_signal_closes_the_window_too() {
    let folder = Folder::new("dash-signal");
    for by in [Signal::TERM, Signal::INT, Signal::HUP] {
        let dash = start(&folder, STAYS, &["dash", "a.mcap"]);
        let window = window(&folder);
        signal(&dash, by);
        let (status, err) = end(dash);
        assert_eq!((status.code(), err.as_str()), (Some(0), ""), "{by:?}");
        assert!(test_kill_process(window).is_err(), "after {by:?} the window is still there");
        std::fs::remove_file(folder.join("number")).expect("the window's number");
    }
}

#[test]
fn a_signal_ends_the_host_that_was_started_for_the_window() {
    let folder = Folder::new("dash-start");
    let dash = start(&folder, STAYS, &["dash", "--start"]);
    let window = window(&folder);
    assert!(folder.socket().exists(), "a host listens");
    let socket = format!("--socket {}", folder.socket().display());
    assert!(folder.read("said").starts_with(&socket), "{}", folder.read("said"));
    signal(&dash, Signal::TERM);
    let (status, err) = end(dash);
    assert_eq!(status.code(), Some(0), "{err}");
    assert!(test_kill_process(window).is_err(), "the window is still there");
    // Only an orderly end removes the socket.
    assert!(!folder.socket().exists(), "the host is still there, or was killed");
}

#[test]
fn the_host_that_was_started_ends_with_the_window() {
    let folder = Folder::new("dash-close");
    let (status, err) = end(start(&folder, "#!/bin/sh\nexit 0\n", &["dash", "--start"]));
    assert_eq!(status.code(), Some(0), "{err}");
    assert!(!folder.socket().exists(), "the host is still there, or was killed");
}

#[test]
fn a_window_that_fails_is_a_failure() {
    let folder = Folder::new("dash-fails");
    let (status, err) = end(start(&folder, "#!/bin/sh\nexit 3\n", &["dash", "a.mcap"]));
    assert_eq!(status.code(), Some(1));
    assert!(err.contains("the window ended: exit status: 3"), "{err}");
}

#[test]
fn the_window_gets_the_socket_and_no_secret() {
    let folder = Folder::new("dash-token");
    let tokens =
        folder.write("tokens", "viewer see-0123456789abcdef\nowner own-0123456789abcdef\n");
    std::fs::set_permissions(tokens, Permissions::from_mode(0o600)).expect("a file");
    let run =
        ["run", "springs", "--performance", "none", "--midi", "none", "--listen", "127.0.0.1:0"];
    let guarded = ["--tokens", "tokens", "--tls", "self-made"];
    let host = start(&folder, STAYS, &[&run[..], &guarded[..]].concat());
    eventually("a host", || folder.socket().exists().then_some(()));
    let dash = start(&folder, STAYS, &["dash"]);
    let _window = window(&folder);
    let said = folder.read("said");
    signal(&dash, Signal::TERM);
    assert_eq!(end(dash).0.code(), Some(0));
    signal(&host, Signal::INT);
    end(host);
    // The window asks the socket for address, secret and fingerprint at each connection.
    assert_eq!(said, format!("--socket {}\ntoken \n", folder.socket().display()));
}
