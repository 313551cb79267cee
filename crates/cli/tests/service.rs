//! The host as a service: status, notifications, reloads and metrics; with real processes.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{Read as _, Write as _};
use std::net::TcpStream;
use std::os::linux::fs::MetadataExt as _;
use std::os::unix::net::UnixDatagram;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use rustix::process::Signal;
use serde_json::Value;
use telemetry::stream::{Client, Dial};
use telemetry::{Arrival, Source as _, Topic, Update};

use crate::running::{Host, signal};
use crate::typed::{Folder, eventually};

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

/// Returns the output of `letoff status --json`, once the host plays.
fn playing(folder: &Folder) -> Value {
    eventually("a host that plays", || {
        let (code, out, _err) = folder.letoff(&["status", "--json"]);
        let status = (code == Some(0)).then(|| json(&out))?;
        (status["state"] == "playing" && status["boards"][0]["state"] == "armed").then_some(status)
    })
}

#[test]
fn the_version_names_the_commit_and_reports_the_program_and_when_it_was_started() {
    let folder = Folder::new("version");
    let (code, out, _err) = folder.letoff(&["--version"]);
    let (head, commit) =
        out.trim().split_once(" (commit ").expect("a commit, or that it is unknown");
    assert_eq!((code, head), (Some(0), concat!("letoff ", env!("CARGO_PKG_VERSION"))));
    let commit = commit.trim_end_matches(')');
    let is_hash = commit.len() == 12 && commit.bytes().all(|it| it.is_ascii_hexdigit());
    assert!(is_hash || commit == "unknown", "{out}");
    let simulate = ["simulate", "bouncing-ball", "--until", "0.01", "--step", "1e-3", "--json"];
    let run = ["run", "springs", "--virtual-time", "--duration", "0.05", "--json"];
    for arguments in [&simulate[..], &run[..]] {
        let (code, out, err) = folder.letoff(arguments);
        assert_eq!(code, Some(0), "{err}");
        let report = json(&out);
        assert_eq!(report["format"], 1);
        let version = report["version"].as_str().expect("a text");
        assert_eq!(format!("letoff {version}"), format!("{head} (commit {commit})"));
        let started = report["started"].as_str().expect("a text");
        assert!(started.len() == 20 && started.ends_with('Z'), "{started}");
    }
}

#[test]
fn a_service_manager_hears_of_readiness_of_the_boards_of_ticks_in_time_and_of_the_end() {
    let folder = Folder::new("notify");
    let manager = UnixDatagram::bind(folder.join("notify")).expect("a socket");
    manager.set_read_timeout(Some(Duration::from_mins(1))).expect("a time limit");
    let notify = folder.join("notify").display().to_string();
    let environment = [("NOTIFY_SOCKET", notify.as_str()), ("WATCHDOG_USEC", "900000")];
    let mut host = Host::start(&folder, &["--quiet"], &environment);
    let mut heard = Vec::new();
    let mut hear = |wanted: &str| {
        while !heard.iter().any(|it: &String| it.contains(wanted)) {
            let mut buffer = [0; 4096];
            let n = manager.recv(&mut buffer).expect("one more message");
            heard.push(String::from_utf8_lossy(&buffer[..n]).into_owned());
        }
        heard.clone()
    };
    let before = hear("READY=1");
    assert!(before.iter().any(|it| it.starts_with("STATUS=springs: ")), "{before:?}");
    assert!(!before.iter().any(|it| it.contains("WATCHDOG=1")), "{before:?}");
    hear("STATUS=springs: plays, 8 of 8 boards armed");
    hear("WATCHDOG=1");
    signal(&host.child, Signal::TERM);
    hear("STOPPING=1");
    assert!(host.child.wait().expect("it ends").success());
}

#[test]
fn status_says_how_it_goes_and_by_its_exit_code_whether_a_host_runs_or_hangs() {
    let folder = Folder::new("status");
    let (code, out, err) = folder.letoff(&["status"]);
    assert_eq!((code, out.as_str()), (Some(3), ""), "{err}");
    assert!(err.contains("no host is running here"), "{err}");
    let mut host = Host::start(&folder, &["--record", "take.mcap"], &[]);
    let status = playing(&folder);
    assert_eq!(status["process"], host.child.id());
    assert_eq!((&status["voices"], &status["tick_hz"]), (&88.into(), &1000.into()));
    assert_eq!(status["boards"].as_array().map(Vec::len), Some(8));
    assert_eq!((&status["midi"], &status["recording"]), (&"none".into(), &"take.mcap".into()));
    let (code, out, _err) = folder.letoff(&["status"]);
    assert_eq!(code, Some(0));
    for line in ["springs: plays, 8 of 8 boards armed (since 2", "voices      88,", "take.mcap"] {
        assert!(out.contains(line), "{out}");
    }
    signal(&host.child, Signal::STOP);
    let (code, out, err) = folder.letoff(&["status"]);
    signal(&host.child, Signal::CONT);
    assert_eq!((code, out.as_str()), (Some(1), ""));
    for words in [&format!("(process {})", host.child.id()), "it hangs", "watchdogs"] {
        assert!(err.contains(words), "{err}");
    }
    playing(&folder);
    signal(&host.child, Signal::TERM);
    assert!(host.child.wait().expect("it ends").success());
}

#[test]
fn a_host_says_that_it_rehearses() {
    let folder = Folder::new("status-early");
    let run = ["run", "bach", "--midi", "none", "--listen", "none"];
    let host = Host::spawn(&folder, &run, &[]);
    let status = eventually("a rehearsal", || {
        let (code, out, _err) = folder.letoff(&["status", "--json"]);
        let status = (code == Some(0)).then(|| json(&out))?;
        (status["state"] == "rehearsing").then_some(status)
    });
    assert_eq!((&status["scene"], &status["voices"]), (&"bach".into(), &0.into()));
    assert!(status["rehearsed"][1].as_u64() > Some(0), "{status}");
    let (_code, out, _err) = folder.letoff(&["status"]);
    assert!(out.starts_with("bach: "), "{out}");
    drop(host);
}

/// Returns the deepest position of key 39 in the last thirtieth of a second (m).
fn depth(client: &mut Client) -> f32 {
    eventually("an overview", || match client.next()? {
        Arrival::Update { update, .. } => {
            let Update::Overview(it) = *update else { return None };
            it.position_max.get(39).copied()
        }
        Arrival::Reply { .. } | Arrival::Anew => None,
    })
}

#[test]
fn a_key_is_pressed_as_long_as_the_command_runs_and_let_go_if_it_is_killed() {
    let folder = Folder::new("press");
    let host = Host::start(&folder, &[], &[]);
    playing(&folder);
    let dial = Dial { address: host.address(), token: host.token.clone(), ..Dial::default() };
    let client = &mut Client::connect(dial, None);
    client.follow(&BTreeSet::from([Topic::Overview]));
    let deep =
        |client: &mut Client| eventually("it goes down", || (depth(client) > 5e-3).then_some(()));
    let up =
        |client: &mut Client| eventually("it comes up", || (depth(client) < 2e-3).then_some(()));
    up(client);
    let letoff = Path::new(env!("CARGO_BIN_EXE_letoff"));
    let mut press = folder.command(letoff, &["press", "C4", "--force", "8"]);
    let mut press = press.stdout(std::process::Stdio::null()).spawn().expect("a process");
    deep(client);
    playing(&folder);
    press.kill().expect("it runs");
    press.wait().expect("it ends");
    up(client);
    let (code, out, err) = folder.letoff(&["press", "60", "--for", "0.2"]);
    assert_eq!((code, out.as_str()), (Some(0), "C4 is pressed with 5.00 N\n"), "{err}");
    up(client);
    let struck = |status: &Value| status["strikes"].as_u64().expect("a number");
    let before = struck(&playing(&folder));
    let (code, out, err) = folder.letoff(&["press", "C4", "--velocity", "70", "--for", "0.4"]);
    let newtons = out.trim_start_matches("C4 is pressed with ").trim_end_matches(" N\n");
    let newtons: f64 = newtons.parse().expect("a weight");
    assert!(code == Some(0) && (0.5..50.0).contains(&newtons), "{out}{err}");
    assert_eq!(struck(&playing(&folder)), before + 1);
    up(client);
    let (code, _out, err) = folder.letoff(&["press", "H4"]);
    assert!(code == Some(2) && err.contains("`H4` is no key: write its name"), "{err}");
    let (code, _out, err) = folder.letoff(&["press", "C4", "--force", "99"]);
    assert!(code == Some(2) && err.contains("0 to 50 N"), "{err}");
}

/// Returns a scene with `values` of its keys and `more` in it.
fn scene(values: &str, more: &str) -> String {
    format!(
        "tick_hz = 1000\n{more}\n[[keys]]\nrange = \"A0..C8\"\ninstrument = \"grand-springs\"\n\
         {values}\n[links]\nkind = \"simulated\"\n"
    )
}

#[test]
fn at_sighup_the_scene_is_read_again_and_a_wrong_one_changes_nothing() {
    let folder = Folder::new("reload");
    folder.write("own.toml", scene("", ""));
    let host = Host::start_scene(&folder, "own.toml", &["--listen", "127.0.0.1:0"], &[]);
    playing(&folder);
    let logged = |words: &str| {
        eventually(words, || {
            let log = folder.read("complaints");
            log.contains(words).then_some(log)
        })
    };
    let hang_up = |text: String| {
        folder.write("own.toml", text);
        signal(&host.child, Signal::HUP);
    };
    hang_up(scene("parameters = { g = 9.5 }", "[render]\npassivity = \"control\""));
    logged("SIGHUP: the scene was read again: 88 keys changed");
    let now = host.scene();
    assert!(now.contains("9.5") && now.contains("passivity = \"control\""), "{now}");
    hang_up(scene("parameters = { g = 9.25 }", "[render]\npassivity = \"control\""));
    eventually("the new value", || host.scene().contains("9.25").then_some(()));
    // Changes that need a restart are rejected as a whole.
    hang_up(scene("parameters = { g = 8.0 }", "lanes = 1\n[render]\nforce_limit = \"20 N\""));
    logged("the scene was not taken, since lanes, force_limit or slew_limit cannot change");
    hang_up(scene("parameters = { gg = 8.0, k2 = -1.0 }", ""));
    let log = logged("the scene is wrong, and the one that plays goes on");
    eventually("all mistakes", || {
        let log = folder.read("complaints");
        (log.contains("\"gg\"") && log.contains("k2")).then_some(())
    });
    assert!(log.contains("own.toml"), "{log}");
    assert!(host.scene().contains("9.25"), "{}", host.scene());
    playing(&folder);
}

#[test]
fn without_a_scene_of_its_own_a_hang_up_ends_the_host() {
    let folder = Folder::new("hang-up");
    let mut host = Host::start(&folder, &["--listen", "none"], &[]);
    signal(&host.child, Signal::HUP);
    assert!(host.child.wait().expect("it ends").success());
}

/// Returns the HTTP answer: status, header fields and text.
fn http(address: &str, request: &str) -> (u16, String, String) {
    let mut stream = TcpStream::connect(address).expect("a connection");
    stream.set_read_timeout(Some(Duration::from_mins(1))).expect("a time limit");
    stream.write_all(request.as_bytes()).expect("a request");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("an answer");
    let (head, text) = answer.split_once("\r\n\r\n").expect("a head");
    let status = head.split(' ').nth(1).expect("a status").parse().expect("a number");
    (status, head.to_owned(), text.to_owned())
}

/// A family of figures: its type, and its samples by label.
type Family = (String, BTreeMap<String, f64>);

/// Parses the text format of Prometheus strictly.
fn families(text: &str) -> BTreeMap<String, Family> {
    assert!(text.ends_with('\n'), "the last line ends");
    let mut families = BTreeMap::<String, Family>::new();
    let (mut current, mut has_help) = (String::new(), false);
    for line in text.lines() {
        if let Some(help) = line.strip_prefix("# HELP ") {
            let (name, help) = help.split_once(' ').expect("a name and its help");
            assert!(!help.is_empty() && !families.contains_key(name), "{line}");
            (current, has_help) = (name.to_owned(), true);
        } else if let Some(kind) = line.strip_prefix("# TYPE ") {
            let (name, kind) = kind.split_once(' ').expect("a name and its type");
            assert!(name == current && has_help, "{line}");
            assert!(["gauge", "counter"].contains(&kind), "{line}");
            assert_eq!(kind == "counter", name.ends_with("_total"), "{line}");
            families.insert(current.clone(), (kind.to_owned(), BTreeMap::new()));
        } else {
            let (series, value) = line.rsplit_once(' ').expect("a value");
            let value: f64 = value.parse().expect("a number");
            let (name, labels) = series.split_once('{').unwrap_or((series, "}"));
            assert_eq!(name, current, "the samples of a family stand together");
            let is_name = |it: char| it.is_ascii_lowercase() || it.is_ascii_digit() || it == '_';
            assert!(name.starts_with("letoff_") && name.chars().all(is_name), "{line}");
            let labels = labels.strip_suffix('}').expect("the end of the labels");
            let samples = &mut families.get_mut(name).expect("its type stands before").1;
            assert!(value.is_finite() && samples.insert(labels.to_owned(), value).is_none());
        }
    }
    families
}

#[test]
fn the_metrics_are_prometheus_text_and_say_what_status_says() {
    let folder = Folder::new("metrics");
    let host = Host::start(&folder, &[], &[]);
    eventually("the first second", || {
        (playing(&folder)["deadlines"]["lateness_us"].is_array()).then_some(())
    });
    let address = host.address().replace("ws://", "");
    let get = format!("GET /metrics HTTP/1.1\r\nHost: {address}\r\n\r\n");
    let (status, head, text) = http(&address, &get);
    assert!(status == 200 && head.contains("Content-Type: text/plain; version=0.0.4"), "{head}");
    assert!(head.contains(&format!("Content-Length: {}", text.len())), "{head}");
    let families = families(&text);
    let one = |name: &str| {
        let family = families.get(&format!("letoff_{name}")).expect(name);
        *family.1.get("").expect(name)
    };
    let after = playing(&folder);
    let ticks = after["deadlines"]["ticks"].as_f64().expect("a number");
    assert!(0.0 < one("ticks_total") && one("ticks_total") <= ticks);
    let exact = [("voices", 88.0), ("tick_hertz", 1000.0), ("playing", 1.0), ("recording", 0.0)];
    for (name, value) in exact {
        assert!((one(name) - value).abs() < 1e-9, "{name}");
    }
    for zero in ["faults_total", "muted_keys", "clients", "stream_lost_messages_total"] {
        assert!(one(zero).abs() < 1e-9, "{zero}");
    }
    for name in ["skipped_ticks_total", "voices_asleep", "strikes_total", "dropped_events_total"] {
        assert!(0.0 <= one(name), "{name}");
    }
    let labels = |name: &str| -> Vec<String> {
        families[&format!("letoff_{name}")].1.keys().cloned().collect()
    };
    let causes = ["cause=\"own_work\"", "cause=\"preempted\"", "cause=\"woken_late\""];
    assert_eq!(labels("missed_ticks_total"), causes);
    assert_eq!(labels("lateness_seconds").len(), 4);
    assert_eq!(labels("board_armed").len(), 8);
    assert_eq!(labels("board_gaps_total"), labels("board_armed"));
    assert!(labels("info")[0].contains("scene=\"springs\""), "{:?}", labels("info"));
}

#[test]
fn who_may_read_the_metrics_and_what_other_plain_requests_get() {
    let folder = Folder::new("plain-http");
    let host = Host::start(&folder, &[], &[]);
    playing(&folder);
    let address = host.address().replace("ws://", "");
    let ask = |method: &str, path: &str, fields: &str| {
        http(&address, &format!("{method} {path} HTTP/1.1\r\nHost: {address}\r\n{fields}\r\n"))
    };
    let token = host.token.clone().expect("a secret of this run");
    let (status, head, text) = ask("GET", "/", "");
    assert_eq!(status, 426);
    assert!(head.contains("Upgrade: websocket") && text.contains("/metrics"), "{head} {text}");
    assert_eq!(ask("GET", "/favicon.ico", "").0, 404);
    let (status, head, _text) = ask("POST", "/metrics", "");
    assert!(status == 405 && head.contains("Allow: GET"), "{head}");
    let (status, _head, text) = ask("HEAD", "/metrics", "");
    assert_eq!((status, text.as_str()), (200, ""));
    assert_eq!(http(&address, "what\r\n\r\n").0, 400);
    // A page is accepted only if it is listed, for any secret.
    let page = "Origin: https://evil.example\r\n";
    assert_eq!(ask("GET", "/metrics", page).0, 403);
    assert_eq!(ask("GET", &format!("/metrics?token={token}"), page).0, 403);
    // A page with a rebound name is rejected, too.
    let rebound = |path: &str| {
        http(&address, &format!("GET {path} HTTP/1.1\r\nHost: evil.example\r\n\r\n")).0
    };
    assert_eq!(rebound("/metrics"), 401);
    assert_eq!(rebound("/metrics?token=guess"), 401);
    assert_eq!(rebound(&format!("/metrics?token={token}")), 200);
}

#[test]
fn journald_gets_levels_and_programs_get_json() {
    let folder = Folder::new("log");
    let run = ["run", "springs", "--performance", "none", "--midi", "none", "--duration", "0.3"];
    let letoff = Path::new(env!("CARGO_BIN_EXE_letoff"));
    let log = |name: &str, more: &[&str], journal: Option<&str>| {
        let file = std::fs::File::create(folder.join(name)).expect("a file");
        let its = file.metadata().expect("a file");
        let own = format!("{}:{}", its.st_dev(), its.st_ino());
        let mut command = folder.command(letoff, &[&run[..], &["--listen", "none"], more].concat());
        command.env("JOURNAL_STREAM", journal.unwrap_or(&own)).stderr(file);
        assert!(command.output().expect("a process").status.success());
        folder.read(name)
    };
    let journal = log("journal", &[], None);
    assert!(journal.contains("<6>plays \"springs\": 88 voices"), "{journal}");
    assert!(journal.lines().all(|line| line.starts_with("<6>")), "{journal}");
    // Another stream than that of journald.
    let plain = log("plain", &[], Some("1:2"));
    assert!(plain.contains("letoff: plays \"springs\""), "{plain}");
    let lines = log("json", &["--log-json"], None);
    assert!(!lines.is_empty());
    for line in lines.lines() {
        let line = json(line);
        assert!(line["time"].as_str().is_some_and(|it| it.ends_with('Z')), "{line}");
        assert_eq!(line["level"], "info");
        assert!(line["text"].is_string());
    }
}

#[test]
fn the_unit_is_right_and_exposes_little() {
    let unit = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../configs/service/letoff.service");
    let text = std::fs::read_to_string(unit).expect("the unit");
    for line in ["Type=notify", "WatchdogSec=10", "ExecReload=/bin/kill -HUP $MAINPID"] {
        assert!(text.lines().any(|it| it == line), "{line}");
    }
    let folder = Folder::new("unit");
    let installed = text.replace("/usr/bin/letoff", env!("CARGO_BIN_EXE_letoff"));
    let file = folder.write("letoff.service", installed);
    let analyze = |arguments: &[&str]| {
        Command::new("systemd-analyze").args(arguments).arg(&file).output().ok()
    };
    let Some(verified) = analyze(&["verify"]) else {
        println!("SKIPPED: systemd-analyze is not installed");
        return;
    };
    let said = String::from_utf8_lossy(&verified.stderr).into_owned();
    assert!(verified.status.success() && said.is_empty(), "{said}");
    let security = analyze(&["security", "--offline=true"]).expect("it is there");
    let said = String::from_utf8_lossy(&security.stdout).into_owned();
    let level = said.rsplit_once("letoff.service: ").expect("a verdict").1;
    let level: f64 = level.split(' ').next().and_then(|it| it.parse().ok()).expect("a number");
    assert!(level < 2.5, "{said}");
}

/// Failing starts with their exit codes: 1 if waiting can help, 2 if files are wrong.
#[test]
fn the_exit_code_says_whether_waiting_can_heal() {
    let folder = Folder::new("exit-codes");
    folder.write("a-file", "no device");
    folder.write("wrong.toml", "tick_hz = 0");
    let _end = crate::typed::cable(&folder.join("pipe.mid"));
    let silent = ["--performance", "none", "--listen", "none"];
    let rows: [(&[&str], i32, &str); 9] = [
        (&["springs", "--link", "serial:no-such-port"], 1, "no-such-port"),
        (&["springs", "--link", "can:no-such-can"], 1, "no-such-can"),
        (&["springs", "--midi", "raw:no-such-device"], 1, "no such file"),
        (&["springs", "--midi", "raw:a-file"], 2, "neither a device nor a FIFO"),
        (&["springs", "--midi", "pipe.mid"], 2, "is a pipe"),
        (&["springs", "--midi", "no-folder/played.mid"], 2, "no folder"),
        (&["wrong.toml"], 2, "tick_hz"),
        (&["no-such-scene"], 2, "no-such-scene"),
        (&["default", "--set", "tick_hz=500"], 2, "with grand"),
    ];
    std::thread::scope(|scope| {
        for (run, code, words) in rows {
            let (folder, all) = (&folder, [&["run"], run, &silent].concat());
            scope.spawn(move || {
                let (ended, out, err) = folder.letoff(&all);
                assert_eq!((ended, out.as_str()), (Some(code), ""), "{all:?}: {err}");
                assert!(err.contains(words), "{all:?}: {err}");
            });
        }
    });
}
