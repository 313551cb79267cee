//! Other programs read our MIDI files: mido, `pretty_midi` and music21 find the notes, the tempo
//! and the bars of the piece, and every note is heard in the WAV file of the same run.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::letoff::{folder, run};

const PACKAGES: [&str; 3] = ["mido>=1.3", "pretty_midi>=0.2.10", "music21>=9"];

/// Runs a Python program; the error contains the reason.
fn python(python: &Path, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new(python).args(arguments).output();
    let output = output.map_err(|error| format!("{}: {error}", python.display()))?;
    let [out, err] =
        [output.stdout, output.stderr].map(|it| String::from_utf8_lossy(&it).into_owned());
    if output.status.success() { Ok(out) } else { Err(format!("{arguments:?}: {out}{err}")) }
}

/// Returns a Python with the packages, made once for all runs of the tests.
fn environment() -> Result<PathBuf, String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("python-midi");
    let program = folder.join("bin/python3");
    let has_all = || python(&program, &["-c", "import mido, music21, pretty_midi"]);
    if has_all().is_err() {
        let path = folder.to_str().expect("a path that is text");
        python(Path::new("python3"), &["-m", "venv", "--clear", path])?;
        let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
        python(&program, &[&pip[..], &PACKAGES].concat())?;
        has_all()?;
    }
    Ok(program)
}

#[test]
fn other_programs_read_the_notes_the_tempo_and_the_bars_of_the_piece() {
    let program = match environment() {
        Ok(program) => program,
        Err(reason) => {
            // Past the test harness, which shows no output of tests that pass.
            let words = format!("SKIPPED: no Python with {PACKAGES:?}: {reason}\n");
            return io::stderr().write_all(words.as_bytes()).expect("a place to say it");
        }
    };
    let folder = folder("daw");
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/daw.py");
    let [source, written] = ["source.mid", "written.mid"].map(|it| folder.join(it));
    let [source, written] = [&source, &written].map(|it| it.to_str().expect("text"));
    python(&program, &[script, "make", source]).expect("a piece");
    let arguments = ["run", "source.mid", "--virtual-time", "--midi", "written.mid"];
    let font = concat!(env!("CARGO_MANIFEST_DIR"), "/crates/midi/tests/font/cosine.sf2");
    let heard = ["--wav", "written.wav", "--font", font];
    let silent = ["--set", "keys.instrument=grand-springs", "--listen", "none"];
    let said = run(&folder, &[&arguments[..], &heard, &silent].concat());
    assert!(said.code == Some(0) && said.out.contains("40 of 40 struck"), "{said:?}");
    let compared = python(&program, &[script, "compare", source, written]);
    assert_eq!(compared, Ok("40 notes, 1 bar before\n".to_owned()));
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/heard.py");
    let wav = folder.join("written.wav");
    let heard = python(&program, &[script, written, wav.to_str().expect("text")]);
    assert_eq!(heard, Ok("40 notes are heard\n".to_owned()));
}
