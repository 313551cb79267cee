//! Switching instruments on a running host, over the real socket.

#![expect(clippy::expect_used, reason = "helpers of tests")]

use std::io::{BufRead as _, BufReader, Write as _};
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use host::config::Scene;
use host::control::{Clients, ControlError, Reply, Request, Server, Switchboard, send, serve};
use host::report::Report;
use host::session::{Options, Session};

/// Runs a host without a pianist, and `clients` beside it; returns its report.
fn beside_a_host(name: &str, clients: impl FnOnce(&Path)) -> Report {
    let silent = [("pianist.performance".to_owned(), "none".to_owned())];
    let scene = Scene::load("default", &silent).expect("the default scene");
    let session = Session::prepare(&scene, Options::default(), &|_| {}).expect("a session");
    let switchboard = Arc::new(Switchboard::new(scene, session.patchbay()));
    let path = socket(name);
    let stop = AtomicBool::new(false);
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(1)
        .enable_all()
        .build()
        .expect("a runtime");
    let server = {
        let _inside = runtime.enter();
        Server::listen(&path).expect("a socket")
    };
    runtime.spawn(serve(server, switchboard, Clients::default()));
    std::thread::scope(|scope| {
        let host = scope.spawn(|| session.run(&stop));
        clients(&path);
        stop.store(true, Ordering::Release);
        host.join().expect("no panic").expect("a report")
    })
}

fn socket(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("letoff-test-{}-{name}", std::process::id())).join("sock")
}

fn request(instrument: &str, keys: Option<&str>) -> Request {
    Request { instrument: instrument.to_owned(), keys: keys.map(str::to_owned) }
}

/// Asks until the host runs; it needs some milliseconds for its first tick.
fn ask(path: &Path, request: &Request) -> Reply {
    loop {
        match send(path, request).expect("a reply") {
            Reply::Refused(why) if why.contains("not running yet") => std::thread::yield_now(),
            reply @ (Reply::Switched(_) | Reply::Refused(_) | Reply::Stopped) => return reply,
        }
    }
}

/// Sends `line` as it is and returns what comes back.
fn say(path: &Path, line: &[u8]) -> String {
    let mut stream = UnixStream::connect(path).expect("a host");
    // A host that has heard enough may close before all is said.
    let _heard_enough = stream.write_all(line);
    let mut reply = String::new();
    let _closed = BufReader::new(stream).read_line(&mut reply);
    reply
}

#[test]
fn every_key_can_become_another_instrument_while_the_host_runs() {
    let report = beside_a_host("switch", |path| {
        assert_eq!(ask(path, &request("spring-wall", Some("C4..B4"))), Reply::Switched(12));
        assert_eq!(ask(path, &request("grand-rigid", Some("60"))), Reply::Switched(1));
        assert_eq!(ask(path, &request("grand-springs", None)), Reply::Switched(88));
    });
    assert_eq!(report.faults, 0);
}

#[test]
fn nonsense_is_refused_with_the_reason_and_disturbs_nobody() {
    let report = beside_a_host("nonsense", |path| {
        let refused = |request: &Request| match ask(path, request) {
            Reply::Refused(why) => why,
            done @ (Reply::Switched(_) | Reply::Stopped) => panic!("{done:?}"),
        };
        assert!(refused(&request("organ", None)).contains("no instrument \"organ\""));
        assert!(refused(&request("spring-wall", Some("B4..C4"))).contains("backwards"));
        assert!(refused(&request("spring-wall", Some("H9"))).contains("is no note"));
        assert!(say(path, b"hello\n").contains("no request"));
        assert!(say(path, b"{\"instrument\":\"x\",\"limit\":1}\n").contains("unknown field"));
        assert!(!say(path, "x".repeat(100_000).as_bytes()).contains("switched"));
        assert_eq!(ask(path, &request("grand-springs", Some("A0"))), Reply::Switched(1));
    });
    assert_eq!(report.faults, 0);
}

#[test]
fn a_second_host_does_not_take_the_socket_and_an_old_one_is_replaced() {
    let path = socket("second");
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().expect("one");
    let _inside = runtime.enter();
    let first = Server::listen(&path).expect("a socket");
    assert!(Server::listen(&path).is_err(), "two hosts listen at one place");
    drop(first);
    assert!(matches!(send(&path, &request("x", None)), Err(ControlError::NoHost { .. })));
    // As after SIGKILL: the file is there, nobody listens.
    drop(std::os::unix::net::UnixListener::bind(&path).expect("a left-over"));
    assert!(Server::listen(&path).is_ok());
}
