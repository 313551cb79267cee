//! A client in another language, which shares no code with ours, works with the server.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicBool, Ordering};
use std::{io::Write as _, sync::Arc, time::Duration};

use telemetry::stream::Publisher;

use crate::test_server::{TestServer, synthetic};

const PACKAGES: [&str; 2] = ["protobuf>=5", "websockets>=14"];

fn python() -> Result<PathBuf, String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("stream-python");
    let python = folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    let has_all = |python: &Path| {
        run(Command::new(python).args(["-c", "import websockets.sync.client, google.protobuf"]))
    };
    if has_all(&python).is_ok() {
        return Ok(python);
    }
    run(Command::new("python3").args(["-m", "venv", "--clear"]).arg(&folder))?;
    let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
    run(Command::new(&python).args(pip).args(PACKAGES))?;
    has_all(&python)?;
    Ok(python)
}

fn run(command: &mut Command) -> Result<String, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let Output { status, stdout, stderr } =
        command.output().map_err(|error| format!("{name} cannot be run: {error}"))?;
    let (stdout, stderr) = (String::from_utf8_lossy(&stdout), String::from_utf8_lossy(&stderr));
    if status.success() {
        return Ok(stdout.into_owned());
    }
    Err(format!("{name} ended with {status}: {stdout}{stderr}"))
}

fn publish(publisher: &Publisher, is_over: &AtomicBool) {
    let mut tick = 0;
    while !is_over.load(Ordering::Relaxed) {
        publisher.publish(tick + 1, &synthetic::block(tick, 33));
        tick += 33;
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn an_independent_client_watches_sets_and_calls() {
    let python = match python() {
        Ok(python) => python,
        Err(reason) => {
            // Past the test harness, which shows no output of tests that pass.
            let text = format!("skipped: no client in Python: {reason}\n");
            return std::io::stderr().write_all(text.as_bytes()).expect("stderr");
        }
    };
    let test_server = TestServer::new();
    test_server.publisher.publish(1, &synthetic::catalogue());
    let is_over = Arc::new(AtomicBool::new(false));
    let publishing = {
        let (publisher, is_over) = (test_server.publisher.clone(), Arc::clone(&is_over));
        std::thread::spawn(move || publish(&publisher, &is_over))
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/client.py");
    let printed = run(Command::new(python).arg(script).arg(&test_server.url));
    is_over.store(true, Ordering::Relaxed);
    publishing.join().expect("it published");
    let expected = "\
channels: 186
messages: decoded by their own schema
parameters: set, and seen by another client
refused string: the value for \"/key/39/m\" is no finite number: send a number in the parameter's unit
refused limit: m is between 0.01 and 1 kg, and not 2
refused name: key 39 has no parameter mass
refused path: there is no parameter \"mass\": names are as /key/39/k2, keys 0 (A0) to 87 (C8)
refused null: the value for \"/key/39/m\" is no finite number: send a number in the parameter's unit
refused nan: what came is no message of the protocol: expected value at line 1 column 108
refused none: the value for \"/key/39/m\" is no finite number: send a number in the parameter's unit
refused call: /letoff/press was asked wrongly: invalid type: string \"much\", expected f64
services: 13
ok
";
    assert_eq!(printed.expect("it ended well"), expected);
}
