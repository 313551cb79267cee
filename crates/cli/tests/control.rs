//! Switching instruments on a running host, over the real socket.

use std::fs::{self, Permissions};
use std::io::{BufRead as _, BufReader, Write as _};
use std::os::unix::fs::PermissionsExt as _;
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::{Path, PathBuf};
use std::time::Duration;

use host::control::{
    Clients, ControlError, ControlServer, Reply, Request, send, send_within, serve,
};
use host::report::RunReport;
use telemetry::request::Change;

use crate::common::{idle_host, run_while};

fn beside_a_host(name: &str, clients: impl FnOnce(&Path)) -> RunReport {
    let (session, requests, runtime) = idle_host();
    let path = socket(name);
    let server = {
        let _inside = runtime.enter();
        ControlServer::listen(&path).expect("a socket")
    };
    runtime.spawn(serve(server, requests, Clients::default()));
    run_while(session, || clients(&path))
}

fn socket(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("letoff-test-{}-{name}", std::process::id())).join("sock")
}

fn request(instrument: &str, keys: Option<&str>) -> Request {
    Request::UseInstrument { instrument: instrument.to_owned(), keys: keys.map(str::to_owned) }
}

/// Asks until the host runs, which takes some milliseconds until its first tick.
fn ask(path: &Path, request: &Request) -> Result<String, String> {
    loop {
        match send(path, request).expect("an answer") {
            Err(why) if why.contains("not running yet") => std::thread::yield_now(),
            Err(why) => return Err(why),
            Ok(Reply::Done { text }) => return Ok(text),
            Ok(
                reply @ (Reply::Stopped { .. }
                | Reply::Scene { .. }
                | Reply::Where { .. }
                | Reply::Figures { .. }
                | Reply::Status { .. }),
            ) => {
                return Err(format!("{reply:?}"));
            }
        }
    }
}

fn say(path: &Path, line: &[u8]) -> String {
    let mut stream = UnixStream::connect(path).expect("a host");
    // A host may close before it has read all.
    let _heard_enough = stream.write_all(line);
    let mut reply = String::new();
    let _closed = BufReader::new(stream).read_line(&mut reply);
    reply
}

#[test]
fn every_key_can_become_another_instrument_while_the_host_runs() {
    let report = beside_a_host("switch", |path| {
        let switched = |instrument, keys| ask(path, &request(instrument, keys)).expect("done");
        assert_eq!(switched("spring-wall", Some("C4..B4")), "12 keys are now spring-wall");
        assert_eq!(switched("grand-reduced", Some("60")), "1 keys are now grand-reduced");
        let refused = ask(path, &request("grand-rigid", Some("60"))).expect_err("not stable");
        let needs = "grand-rigid needs a coupling_stiffness of at most 2000, not none";
        assert!(refused.contains(needs), "{refused}");
        assert_eq!(switched("grand-springs", None), "88 keys are now grand-springs");
    });
    assert_eq!(report.totals.faults, 0);
}

fn set(changes: &[(u8, &str, f64)]) -> Request {
    let change = |(key, parameter, value): &(u8, &str, f64)| Change {
        key: *key,
        parameter: (*parameter).to_owned(),
        value: *value,
    };
    Request::Set { changes: changes.iter().map(change).collect() }
}

#[test]
fn values_change_while_the_host_runs_and_stand_in_its_scene() {
    let report = beside_a_host("tune", |path| {
        let done = ask(path, &set(&[(39, "k2", 900.0), (40, "k2", 901.0)]));
        assert_eq!(done, Ok("2 values on 2 keys".to_owned()));
        let refused = ask(path, &set(&[(39, "k2", 1.0), (39, "nothing", 1.0)]));
        assert!(refused.expect_err("a wrong name").contains("no parameter \"nothing\""));
        let scene = send(path, &Request::Scene {}).expect("an answer");
        let Ok(Reply::Scene { toml }) = scene else { unreachable!("{scene:?}") };
        assert!(toml.contains("k2 = 900.0") && toml.contains("k2 = 901.0"), "all or none");
        assert!(!toml.contains("k2 = 1.0"), "a set that is refused changes nothing");
    });
    assert_eq!(report.totals.faults, 0);
}

#[test]
fn nonsense_is_refused_with_the_reason_and_disturbs_nobody() {
    let report = beside_a_host("nonsense", |path| {
        let refused = |request: &Request| ask(path, request).expect_err("nonsense");
        assert!(refused(&request("theremin", None)).contains("no instrument \"theremin\""));
        assert!(refused(&request("spring-wall", Some("B4..C4"))).contains("backwards"));
        assert!(refused(&request("spring-wall", Some("H9"))).contains("is no note"));
        assert!(say(path, b"hello\n").contains("no request"));
        let more = b"{\"service\":\"stop\",\"limit\":1}\n";
        assert!(say(path, more).contains("unknown field"));
        assert!(!say(path, "x".repeat(100_000).as_bytes()).contains("Ok"));
        let done = ask(path, &request("grand-springs", Some("A0")));
        assert_eq!(done, Ok("1 keys are now grand-springs".to_owned()));
    });
    assert_eq!(report.totals.faults, 0);
}

#[test]
fn a_second_host_does_not_take_the_socket_and_an_old_one_is_replaced() {
    let path = socket("second");
    let runtime = runtime();
    let _inside = runtime.enter();
    let first = ControlServer::listen(&path).expect("a socket");
    assert!(ControlServer::listen(&path).is_err(), "two hosts listen at one place");
    drop(first);
    assert!(matches!(send(&path, &request("x", None)), Err(ControlError::NoHost { .. })));
    // As after SIGKILL: the file exists without a listener.
    drop(UnixListener::bind(&path).expect("a left-over"));
    assert!(ControlServer::listen(&path).is_ok());
}

fn runtime() -> tokio::runtime::Runtime {
    tokio::runtime::Builder::new_current_thread().enable_all().build().expect("a runtime")
}

/// Returns the reason why `path` cannot be listened at.
fn refused(path: &Path) -> String {
    ControlServer::listen(path).expect_err("it is refused").to_string()
}

#[test]
fn what_is_no_socket_of_this_user_s_is_left_alone() {
    let (path, runtime) = (socket("left-alone"), runtime());
    let _inside = runtime.enter();
    let folder = path.parent().expect("a folder");
    fs::create_dir_all(folder).expect("a folder");
    fs::set_permissions(folder, Permissions::from_mode(0o700)).expect("a folder");
    let file = folder.join("precious");
    fs::write(&file, "a year's work").expect("a file");
    assert!(refused(&file).contains("no socket, and is left alone"), "{}", refused(&file));
    std::os::unix::fs::symlink(&file, &path).expect("a link");
    assert!(refused(&path).contains("no socket"), "{}", refused(&path));
    assert_eq!(fs::read_to_string(&file).expect("the file"), "a year's work");
    fs::remove_file(&path).expect("the link");
    // Another file at the path is not removed at the end, either.
    let server = ControlServer::listen(&path).expect("a socket");
    let mode = fs::metadata(&path).expect("a socket").permissions().mode();
    assert_eq!(mode & 0o777, 0o600);
    fs::remove_file(&path).expect("the socket");
    fs::write(&path, "another's").expect("a file");
    drop(server);
    assert!(path.exists());
}

#[test]
fn a_folder_in_which_others_can_put_a_socket_is_refused_and_none_is_made_out_of_nothing() {
    let (path, runtime) = (socket("others"), runtime());
    let _inside = runtime.enter();
    let folder = path.parent().expect("a folder");
    fs::create_dir_all(folder).expect("a folder");
    fs::set_permissions(folder, Permissions::from_mode(0o777)).expect("a folder");
    assert!(refused(&path).contains("others can write into"), "{}", refused(&path));
    fs::set_permissions(folder, Permissions::from_mode(0o700)).expect("a folder");
    assert!(ControlServer::listen(&path).is_ok());
    let nowhere = folder.join("no/such/folder/sock");
    assert!(refused(&nowhere).contains("there is no folder"), "{}", refused(&nowhere));
    assert!(!folder.join("no").exists());
}

#[test]
fn a_host_that_hangs_is_named_by_its_process_with_what_to_do() {
    let path = socket("hangs");
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    let _left_over = fs::remove_file(&path);
    let _hangs = UnixListener::bind(&path).expect("a socket");
    let said = send_within(Duration::from_millis(50), &path, &Request::Stop {});
    let said = said.expect_err("nobody answers").to_string();
    let own = std::process::id();
    for words in [&format!("(process {own})"), "watchdogs", &format!("`kill -KILL {own}`")] {
        assert!(said.contains(words), "{said}");
    }
}
