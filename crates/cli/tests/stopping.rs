//! `letoff stop` beside several hosts in any state.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use rustix::process::{Pid, Signal, kill_process};

use crate::typed::{Folder, eventually};

struct Host(Child);

impl Host {
    fn start(folder: &Folder, arguments: &[&str]) -> Self {
        let nothing = ["--midi", "none", "--listen", "none", "--black-box", "none", "--quiet"];
        let run = [&["run"], arguments, &nothing].concat();
        let mut command = folder.command(Path::new(env!("CARGO_BIN_EXE_letoff")), &run);
        command.stdout(Stdio::null()).stderr(Stdio::null());
        Self(command.spawn().expect("a process"))
    }

    /// Returns `true` if the system lists the name at which it receives stops.
    fn is_listening(&self) -> bool {
        let name = format!("@letoff/{}/{}", rustix::process::getuid().as_raw(), self.0.id());
        fs::read_to_string("/proc/net/unix").expect("a list").lines().any(|it| it.ends_with(&name))
    }

    fn end(mut self) -> Option<i32> {
        eventually("it ends", || self.0.try_wait().expect("it is ours")).code()
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        let _gone = self.0.kill();
        let _ended = self.0.wait();
    }
}

#[test]
fn every_host_is_stopped_and_one_that_hangs_is_named() {
    let folder = Folder::new("stop-all");
    let plays = ["springs", "--performance", "none"];
    // The second host finds the first at their socket.
    let playing = [Host::start(&folder, &plays), Host::start(&folder, &plays)];
    let hanging = Host::start(&folder, &plays);
    for host in playing.iter().chain([&hanging]) {
        eventually("it listens", || host.is_listening().then_some(()));
    }
    kill_process(Pid::from_child(&hanging.0), Signal::STOP).expect("it is there");
    let rehearsing = Host::start(&folder, &["bach"]);
    eventually("it listens", || rehearsing.is_listening().then_some(()));
    let (code, out, err) = folder.letoff(&["stop"]);
    assert_eq!(code, Some(1), "{out}{err}");
    let named = |host: &Host| out.contains(&format!("host {}: stopped", host.0.id()));
    assert!(playing.iter().chain([&rehearsing]).all(named), "{out}{err}");
    let of_ours = err.lines().filter(|line| !line.contains("plays on"));
    assert_eq!(of_ours.count(), 1, "{err}");
    let pid = hanging.0.id();
    assert!(err.contains(&format!("host {pid}: the host (process {pid}) gave no answer")), "{err}");
    assert!(err.contains(&format!("`kill -KILL {pid}`")), "{err}");
    for host in playing.into_iter().chain([rehearsing]) {
        assert_eq!(host.end(), Some(0));
    }
}

/// Uses its own network, where no other test's host receives it.
#[test]
fn hosts_at_other_sockets_are_stopped_too() {
    let folder = Folder::new("stop-elsewhere");
    let isolated = |script: &str| {
        let mut command = Command::new("/usr/bin/unshare");
        command.args(["--net", "--map-root-user", "/bin/sh", "-c", script]).current_dir(&*folder);
        command.env("letoff", env!("CARGO_BIN_EXE_letoff")).env_remove("LETOFF_SOCKET");
        command.env("XDG_RUNTIME_DIR", &*folder).env("HOME", &*folder).stdin(Stdio::null());
        command.output()
    };
    if !isolated("true").is_ok_and(|tried| tried.status.success()) {
        println!("SKIPPED: this system lets nobody have a network of their own");
        return;
    }
    let script = r#"
        run="$letoff run springs --performance none --midi none --listen none --black-box none --quiet"
        LETOFF_SOCKET=$PWD/one $run >/dev/null 2>&1 &
        LETOFF_SOCKET=/etc/passwd $run >/dev/null 2>&1 &
        $run >/dev/null 2>&1 &
        while [ "$(grep -c '@letoff/' /proc/net/unix)" -lt 3 ]; do sleep 0.05; done
        "$letoff" stop && wait
    "#;
    let stopped = isolated(script).expect("it runs");
    let out = String::from_utf8_lossy(&stopped.stdout);
    assert!(stopped.status.success(), "{stopped:?}");
    assert_eq!(out.matches(": stopped").count(), 3, "{stopped:?}");
}

#[test]
fn a_host_that_was_told_to_use_a_file_as_its_socket_is_stopped_by_its_name() {
    let folder = Folder::new("stop-file");
    folder.write("socket", "no socket");
    let host = Host::start(&folder, &["springs", "--performance", "none"]);
    eventually("it listens", || host.is_listening().then_some(()));
    let (code, out, err) = folder.letoff(&["stop"]);
    assert_eq!(code, Some(0), "{out}{err}");
    assert_eq!(host.end(), Some(0));
    assert_eq!(folder.read("socket"), "no socket");
}
