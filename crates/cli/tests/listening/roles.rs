//! Compares the table of roles in the host's manual, cell by cell, with a real host.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{Read as _, Write as _};
use std::net::TcpStream;

use host::control::{Request, send};
use telemetry::request::{Change, RenderSetting};

use super::{Host, LOOPBACK, OWNER, TUNER, VIEWER, tokens};
use crate::stranger::Stranger;
use crate::typed::{Folder, eventually};

const README: &str = include_str!("../../../host/MANUAL.md");

/// Columns of the table, each with its token.
const COLUMNS: [(&str, Option<&str>); 5] = [
    ("no token", None),
    ("`viewer`", Some(VIEWER)),
    ("`tuner`", Some(TUNER)),
    ("`owner`", Some(OWNER)),
    (SOCKET, None),
];

const SOCKET: &str = "control socket";

/// A host of one key, so that every change is fast.
const SCENE: &str = r#"
keys = [{ range = "C4", instrument = "grand-springs" }]
midi.output = "none"
"#;

/// Returns all requests of clients; the last one stops the host.
fn requests() -> Vec<Request> {
    let changes = vec![Change { key: 39, parameter: "k2".into(), value: 901.0 }];
    let passivity = RenderSetting { name: "render.passivity".into(), value: "control".into() };
    vec![
        Request::Set { changes },
        Request::Render { settings: vec![passivity] },
        Request::UseInstrument { instrument: "spring-wall".into(), keys: Some("C4".into()) },
        Request::FollowBase { instrument: "spring-wall".into(), keys: None },
        Request::Load { description: "absent.toml".into(), keys: None },
        Request::Press { key: 39, newtons: 1.0 },
        Request::Grip { key: 39, depth: Some(0.5) },
        Request::Margin { key: 39 },
        Request::Figures { key: 39 },
        Request::Identify { line: 0, board: 0 },
        Request::Scene {},
        Request::Where {},
        Request::Status {},
        Request::SaveInstrument {
            name: "absent/folder".into(),
            base: "spring-wall".into(),
            differences: Vec::new(),
            overwrite: false,
        },
        Request::Record { file: Some("take.mcap".into()) },
        Request::Stop {},
    ]
}

/// Returns the name of a request in its JSON.
fn name(request: &Request) -> String {
    serde_json::to_value(request).expect("JSON")["service"].as_str().expect("a name").to_owned()
}

/// Returns the names of all requests, as listed in the error on an unknown one.
fn all_names() -> BTreeSet<String> {
    let refusal = serde_json::from_str::<Request>(r#"{"service":"?"}"#).expect_err("no request");
    let refusal = refusal.to_string();
    let listed = refusal.split_once("expected one of ").expect("a list").1;
    listed.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// Returns one cell: `yes` if the operation is allowed.
fn cell(request: &Request, answer: Option<Result<(), String>>) -> &'static str {
    match answer {
        None => "–",
        Some(Ok(())) => "yes",
        Some(Err(why)) if why.contains("may not do this") => "no",
        // There is no board, no such file and no base: this error means that the client may ask.
        Some(Err(_)) if is_in_vain(request) => "yes",
        Some(Err(why)) => unreachable!("{request:?}: {why}"),
    }
}

const fn is_in_vain(request: &Request) -> bool {
    matches!(
        request,
        Request::Identify { .. }
            | Request::Load { .. }
            | Request::FollowBase { .. }
            | Request::SaveInstrument { .. }
    )
}

/// Returns the answer to `request` once the host runs; it listens before.
fn once_it_runs<T>(
    mut ask: impl FnMut() -> Option<Result<T, String>>,
) -> Option<Result<(), String>> {
    eventually("a host that runs", || {
        let answer = ask();
        let is_early = answer
            .as_ref()
            .is_some_and(|it| it.as_ref().is_err_and(|why| why.contains("not running yet")));
        (!is_early).then_some(answer)
    })
    .map(|answer| answer.map(drop))
}

/// Returns the status of a request for the metrics.
fn metrics(address: &str, host: &str, token: Option<&str>) -> &'static str {
    let mut stream = TcpStream::connect(address).expect("a connection");
    let query = token.map(|token| format!("?token={token}")).unwrap_or_default();
    write!(stream, "GET /metrics{query} HTTP/1.1\r\nHost: {host}\r\n\r\n").expect("a request");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("an answer");
    match answer.split(' ').nth(1) {
        Some("200") => "yes",
        Some("401") => "no",
        other => unreachable!("{other:?}"),
    }
}

/// Returns one column: the rights with this `token`, or at the socket.
fn column(
    host: &mut Host<'_>,
    name_of: &str,
    token: Option<&str>,
) -> BTreeMap<String, &'static str> {
    let is_socket = name_of == SOCKET;
    let mut client = token.map(|token| {
        let bearer = format!("Bearer {token}");
        Stranger::knock(&host.address, &[("Authorization", &bearer)]).expect("a known token")
    });
    if client.is_none() {
        assert_eq!(Stranger::knock(&host.address, &[]).err(), Some(401));
    }
    let address = host.address.replace("ws://", "");
    let mut cells = BTreeMap::new();
    for (operation, name) in
        [("metrics of this machine", "localhost"), ("metrics from elsewhere", "piano.example")]
    {
        let met = if is_socket { "–" } else { metrics(&address, name, token) };
        cells.insert(operation.to_owned(), met);
    }
    for operation in ["watch", "values"] {
        let heard = client
            .as_mut()
            .map(|client| if operation == "watch" { client.watch() } else { client.read_values() });
        cells.insert(
            operation.to_owned(),
            heard.map_or(if is_socket { "–" } else { "no" }, |()| "yes"),
        );
    }
    for request in requests() {
        let before = host.scene();
        let cell = match &mut client {
            Some(client) => cell(&request, once_it_runs(|| client.ask(&request))),
            None if is_socket => {
                cell(&request, once_it_runs(|| send(&host.folder.socket(), &request).ok()))
            }
            None => "no",
        };
        if cell == "no" {
            assert_eq!(host.scene(), before, "{name_of} was refused {request:?}, and it was done");
        }
        cells.insert(name(&request), cell);
    }
    // The host waits for connected clients to receive its end.
    drop(client);
    let may_record = cells["record"] == "yes" && !is_socket;
    assert_eq!(host.folder.join("takes/take.mcap").exists(), may_record, "{name_of}");
    if cells["stop"] == "yes" {
        assert!(host.child.wait().expect("it ends").success(), "{name_of}");
    }
    cells
}

/// Parses the table of the manual: its columns, and the cells of each operation.
fn written() -> (Vec<String>, BTreeMap<String, Vec<String>>) {
    let cells = |line: &str| -> Vec<String> {
        line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    let mut lines = README.lines().skip_while(|line| !line.starts_with("| operation |"));
    let head = cells(lines.next().expect("the table of roles")).split_off(1);
    let rows = lines.skip(1).take_while(|line| line.starts_with('|')).map(|line| {
        let mut row = cells(line);
        let rest = row.split_off(1);
        let name = row[0].split('`').nth(1).expect("a name in backticks");
        (name.to_owned(), rest)
    });
    (head, rows.collect())
}

#[test]
fn every_cell_of_the_table_of_roles_is_so() {
    let tried: BTreeSet<_> = requests().iter().map(name).collect();
    assert_eq!(tried, all_names(), "a request is not tried");
    let (head, rows) = written();
    assert_eq!(head, COLUMNS.map(|(name, _)| name));
    let mut found = BTreeMap::<String, Vec<String>>::new();
    for (name, token) in COLUMNS {
        let folder = Folder::new(&format!("column-{}", name.replace(' ', "-").replace('`', "")));
        tokens(&folder, &format!("viewer {VIEWER}\ntuner {TUNER}\nowner {OWNER}\n"));
        folder.write("scene.toml", SCENE);
        let options = ["--tokens", "tokens", "--recordings", "takes", "--black-box", "none"];
        let run = [&["run", "scene.toml"], &LOOPBACK[..], &options].concat();
        let mut host = Host::run(&folder, &run);
        for (operation, cell) in column(&mut host, name, token) {
            found.entry(operation).or_default().push(cell.to_owned());
        }
    }
    assert_eq!(found, rows, "the host's README says otherwise");
}
