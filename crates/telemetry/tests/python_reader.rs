//! The Python packages `mcap` and `mcap-protobuf-support` read our recordings.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::{Value, json};
use telemetry::{KEYS, Update};

use crate::common::{at, block, performance, record, unrecorded};

const PACKAGES: [&str; 2] = ["mcap==1.6.0", "mcap-protobuf-support==0.6.0"];

fn run(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    Err(format!("{command:?}: {}", String::from_utf8_lossy(&output.stderr)))
}

fn python() -> Result<PathBuf, String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("python-mcap");
    let python = folder.join("bin/python3");
    let is_there = || run(Command::new(&python).args(["-c", "import mcap, mcap_protobuf"]));
    if is_there().is_err() {
        run(Command::new("python3").args(["-m", "venv", "--clear"]).arg(&folder))?;
        let install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
        run(Command::new(&python).args(install).args(PACKAGES))?;
    }
    Ok(python)
}

/// Returns a number's bits, which no printing or reading rounds.
fn bits(value: f64) -> String {
    format!("{:016x}", value.to_bits())
}

#[test]
fn python_reads_what_was_recorded() {
    let python = match python() {
        Ok(python) => python,
        Err(reason) => {
            // Not by a macro, whose output is shown of failing tests only.
            let words = format!("skipped: no Python with {PACKAGES:?}: {reason}\n");
            io::stderr().write_all(words.as_bytes()).expect("somewhere to say it");
            return;
        }
    };
    let (_folder, path) = unrecorded();
    let told = performance(2000);
    record(&path, &told);
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/read_mcap.py");
    let printed = run(Command::new(&python).arg(script).arg(&path)).expect("it reads");
    check(&serde_json::from_str(&printed).expect("JSON"), &told);
}

#[track_caller]
fn check(found: &Value, told: &[(u64, Update)]) {
    assert_eq!(found["profile"], "letoff");
    // Metadata, catalogue and voices are repeated behind the first chunk and at the end.
    let labels = json!({"format": "1.0", "part": "1", "run": "the run"});
    assert_eq!(found["metadata"], json!([labels, labels, labels, labels]));
    let again = |update: &Update| matches!(update, Update::Catalogue(_) | Update::Voice(_));
    let times = |update: &Update| if again(update) { 3 } else { 1 };
    assert_eq!(found["messages"], told.iter().map(|it| times(&it.1)).sum::<usize>());
    assert_eq!(found["chunks"], true);
    assert_eq!(found["schemas"].as_array().map(Vec::len), Some(11));
    assert_eq!(found["models"], json!(["springs", "wall"].repeat(3)));
    let grand = |_| [38, 39, 40].map(|key| json!([key, "grand"]));
    assert_eq!(found["voices"], json!((0..3).flat_map(grand).collect::<Vec<_>>()));
    assert_eq!(found["last"], json!([1980]));
    let strikes: Vec<_> =
        (0..20).map(|strike| json!([strike * 100, bits(0.1 + 0.2), 39, 1.25])).collect();
    assert_eq!(found["strikes"], json!(strikes));
    let blocks = || (0..2000).step_by(20).map(|tick| (at(tick + 20), block(39, tick)));
    let (mut positions, mut signals) = (Vec::new(), Vec::new());
    for (when, update) in blocks() {
        let Update::Block(block) = update else { unreachable!() };
        positions.extend(block.position.iter().map(|position| json!([when, bits(*position)])));
        signals
            .extend(block.signals.iter().map(|signal| json!(format!("{:08x}", signal.to_bits()))));
    }
    assert!(found["positions"] == json!(positions), "positions differ");
    assert!(found["signals"] == json!(signals), "signals differ");
    let topics = found["topics"].as_object().expect("topics");
    assert!(topics.len() <= 9 + 2 * KEYS);
    for (topic, count) in topics {
        let is_it = |(_, update): &&(u64, Update)| {
            update.topic().is_some_and(|it| it.to_string() == *topic)
        };
        let count_told: usize = told.iter().filter(is_it).map(|it| times(&it.1)).sum();
        assert_eq!(*count, count_told, "{topic}");
    }
}
