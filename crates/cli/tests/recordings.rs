//! `letoff record`, `letoff replay`, `letoff recover` and `letoff dash` on files.

use crate::typed::Folder;

/// Makes a recording of three seconds, in which the piece begins.
fn recorded(folder: &Folder) {
    let arguments = ["record", "a.mcap", "--virtual-time", "--duration", "3"];
    let (code, _out, err) = folder.letoff(&arguments);
    assert_eq!(code, Some(0), "{err}");
}

#[test]
fn a_run_is_recorded_replayed_and_exported() {
    let folder = Folder::new("whole");
    recorded(&folder);
    let (code, out, err) = folder.letoff(&["replay", "a.mcap"]);
    assert_eq!(code, Some(0), "{err}");
    assert!(out.contains("the same to the last bit"), "{out}");
    let (code, out, _err) = folder.letoff(&["replay", "a.mcap", "--json"]);
    assert_eq!(code, Some(0));
    assert!(out.contains("\"different\": 0") && out.contains("\"ticks\": 3000"), "{out}");
    let (code, _out, err) = folder.letoff(&["replay", "a.mcap", "--export", "csv"]);
    assert_eq!(code, Some(0), "{err}");
    let events = std::fs::read_to_string(folder.join("csv/events.csv")).expect("events");
    assert!(events.contains("strike"), "{events}");
}

/// A format 1 file: C4, and E4 on channel 2 of a second track called "left", half a second each.
const SONG: &[u8] = b"MThd\0\0\0\x06\0\x01\0\x02\x01\xf4\
    MTrk\0\0\0\x0d\0\x90\x3c\x40\x83\x74\x80\x3c\x40\0\xff\x2f\0\
    MTrk\0\0\0\x15\0\xff\x03\x04left\0\x91\x40\x40\x83\x74\x81\x40\x40\0\xff\x2f\0";

#[test]
fn a_song_is_checked_played_and_its_recording_gives_the_same_midi_file() {
    let folder = Folder::new("song");
    folder.write("song.mid", SONG);
    let (code, out, err) = folder.letoff(&["check", "song.mid"]);
    assert_eq!(code, Some(0), "{err}");
    for line in [
        "song.mid: a good piece\n  0.5 s, 2 notes, 0 pedal moves\n  track 1 \"\": 1 notes",
        "  track 2 \"left\": 1 notes, channels [2]\n  not played as in the file: nothing\n",
    ] {
        assert!(out.contains(line), "{out}");
    }
    let (_code, out, _err) = folder.letoff(&["check", "--json", "song.mid"]);
    let report: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(report[0]["tracks"][1]["channels"], serde_json::json!([2]), "{report}");
    let song = ["record", "take.mcap", "song.mid", "--track", "2", "--midi", "live.mid"];
    let fast = ["--virtual-time", "--set", "keys.instrument=grand-springs"];
    let (code, out, err) = folder.letoff(&[&song[..], &fast].concat());
    assert_eq!(code, Some(0), "{err}");
    assert!(out.contains("1 of 1 struck") && out.contains("1 notes of other tracks"), "{out}");
    let (code, _out, err) = folder.letoff(&["replay", "take.mcap", "--midi", "take.mid"]);
    assert_eq!(code, Some(0), "{err}");
    let notes = ["live.mid", "take.mid"].map(|file| {
        let bytes = std::fs::read(folder.join(file)).expect("a file");
        pianist::read(&bytes).expect("a score").notes[0]
    });
    let [live, taken] = notes;
    assert_eq!((live.key, live.velocity, live.release), (43, taken.velocity, taken.release));
    let apart = (live.onset - taken.onset).abs().max((live.end - taken.end).abs());
    assert!(apart < 50e-6 && (live.onset - 2.0).abs() < 2e-3, "a bar before: {notes:?}");

    let (code, _out, err) = folder.letoff(&["replay", "take.mcap", "--midi", "take.wav"]);
    assert!(code == Some(2) && err.contains("let it end in .mid"), "{err}");
    let twice = ["run", "song.mid", "--performance", "song.mid"];
    folder.refuses(&twice, 2, &["song.mid and song.mid are both pieces"]);
    folder.refuses(&["run", "song.mid", "--track", "3"], 2, &["has no track 3"]);
}

#[test]
fn a_recording_is_not_written_over() {
    let folder = Folder::new("twice");
    recorded(&folder);
    let before = std::fs::read(folder.join("a.mcap")).expect("a recording");
    let (code, _out, err) = folder.letoff(&["record", "a.mcap", "--duration", "1"]);
    assert_eq!((code, err.contains("a.mcap")), (Some(2), true), "{err}");
    assert_eq!(std::fs::read(folder.join("a.mcap")).expect("a recording"), before);
}

#[test]
fn a_second_file_and_sizes_that_are_none_are_refused() {
    let folder = Folder::new("options");
    let refused = |arguments: &[&str], words: &[&str]| {
        let (code, out, err) = folder.letoff(&[&["record", "a.mcap"], arguments].concat());
        assert_eq!((code, out.as_str()), (Some(2), ""), "{err}");
        assert!(words.iter().all(|word| err.contains(word)), "{err}");
        assert!(!folder.join("a.mcap").exists());
    };
    refused(&["--record", "b.mcap"], &["FILE.mcap", "--record", "cannot be used with"]);
    refused(&["--max-size", "5"], &["`5` is no size"]);
    refused(&["--max-total", "1kB"], &["`1kB` is too small for a recording"]);
    refused(&["--max-duration", "0"], &["is no length"]);
    let full = ["--virtual-time", "--duration", "1", "--min-free", "500000000GB"];
    refused(&full, &["a.mcap is not begun: only ", "--min-free"]);
}

#[test]
fn a_recording_goes_on_in_files_of_the_time_that_was_asked_for() {
    let folder = Folder::new("rotated");
    let length = ["--virtual-time", "--duration", "3", "--max-duration", "1"];
    let (code, _out, err) = folder.letoff(&[&["record", "a.mcap"], &length[..]].concat());
    assert_eq!(code, Some(0), "{err}");
    assert!(folder.join("a-0003.mcap").exists());
    let (code, out, err) = folder.letoff(&["replay", "a.mcap", "--json"]);
    assert_eq!(code, Some(0), "{err}");
    assert!(out.contains("\"different\": 0") && out.contains("\"ticks\": 3000"), "{out}");
}

#[test]
fn a_file_that_may_not_grow_ends_its_recording_and_not_the_run() {
    let folder = Folder::new("limited");
    let limited = |arguments: &str| {
        let letoff = env!("CARGO_BIN_EXE_letoff");
        let script = format!("ulimit -f 200 && exec {letoff} {arguments}");
        let shell = folder.command("/bin/sh".as_ref(), &["-c", &script]).output();
        let output = shell.expect("a shell");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    };
    let (code, out, err) = limited("record a.mcap --virtual-time --duration 3 --json");
    assert_eq!(code, Some(1), "{err}");
    assert!(err.contains("a.mcap cannot be written any further, and ends here: "), "{err}");
    let report: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(report["ticks"], 3000, "the run went on: {report}");
    let (code, _out, err) = folder.letoff(&["recover", "a.mcap"]);
    assert_eq!(code, Some(0), "{err}");
}

#[test]
fn what_is_no_recording_is_refused_in_a_sentence() {
    let folder = Folder::new("bad");
    folder.write("text.mcap", "once upon a time");
    folder.write("empty.mcap", "");
    for file in ["text.mcap", "empty.mcap", "nothing.mcap"] {
        folder.refuses(&["replay", file], 2, &[file]);
        folder.refuses(&["recover", file], 2, &[file]);
        assert!(!folder.join(file.replace('.', "-recovered.")).exists(), "nothing is made of it");
    }
}

/// Records `a.mcap`, and copies its first half to `cut.mcap`.
fn cut(folder: &Folder) {
    recorded(folder);
    let whole = std::fs::read(folder.join("a.mcap")).expect("a recording");
    folder.write("cut.mcap", &whole[..whole.len() / 2]);
}

#[test]
fn a_recording_that_was_cut_is_recovered_beside_it() {
    let folder = Folder::new("recover");
    cut(&folder);
    let before = std::fs::read(folder.join("cut.mcap")).expect("it was cut");
    let (code, out, err) = folder.letoff(&["recover", "cut.mcap"]);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    let lines: Vec<_> = out.lines().collect();
    assert_eq!(lines.len(), 3, "{out}");
    assert!(lines[0].starts_with("cut-recovered.mcap: "), "{out}");
    assert!(lines[0].contains(" messages of "), "{out}");
    assert!(lines[1].contains("cut.mcap breaks off at byte "), "{out}");
    assert!(lines[2].starts_with("  lost: ") && lines[2].contains(" bytes at the end"), "{out}");
    assert_eq!(std::fs::read(folder.join("cut.mcap")).expect("the old one"), before);

    // The recovered file is complete, with the messages of the cut one.
    let ticks = |file| {
        let (_code, out, err) = folder.letoff(&["replay", file, "--json"]);
        assert_eq!(err.contains("breaks off"), file == "cut.mcap", "{err}");
        let mut report: serde_json::Value = serde_json::from_str(&out).expect("JSON");
        let started = report.as_object_mut().expect("a report").remove("started");
        assert!(started.is_some(), "{report}");
        report
    };
    assert_eq!(ticks("cut-recovered.mcap"), ticks("cut.mcap"));
}

#[test]
fn a_program_is_told_what_was_recovered() {
    let folder = Folder::new("recover-json");
    cut(&folder);
    let (code, out, err) = folder.letoff(&["recover", "cut.mcap", "--into", "b.mcap", "--json"]);
    assert_eq!(code, Some(0), "{err}");
    let saved: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(saved["file"], "b.mcap");
    assert!(0 < saved["messages"].as_u64().expect("a number"), "{out}");
    let seconds = saved["seconds"].as_f64().expect("a number");
    assert!((0.1..3.0).contains(&seconds), "{out}");
    assert!(0 < saved["cut_bytes"].as_u64().expect("a number"), "{out}");
    assert_eq!(saved["damaged"], 0);
    assert_eq!(saved["wrong"].as_array().map(Vec::len), Some(1), "{out}");
}

#[test]
fn a_whole_recording_is_copied_and_nothing_is_lost() {
    let folder = Folder::new("recover-whole");
    recorded(&folder);
    let (code, out, err) = folder.letoff(&["recover", "a.mcap", "--into", "b.mcap"]);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    assert!(out.contains("a.mcap was complete"), "{out}");
    assert!(!out.contains("lost"), "{out}");
    let (code, _out, err) = folder.letoff(&["replay", "b.mcap"]);
    assert_eq!(code, Some(0), "{err}");
}

type Damage = fn(&mut Vec<u8>);

const DAMAGES: [(&str, Damage); 3] = [
    ("bit", |bytes| {
        let middle = bytes.len() / 2;
        bytes[middle] ^= 4;
    }),
    ("zeros", |bytes| {
        let middle = bytes.len() / 2;
        bytes[middle..middle + (64 << 10)].fill(0);
    }),
    ("beginning", |bytes| bytes[..64 << 10].fill(0)),
];

#[test]
fn what_was_recovered_is_replayed_as_what_it_was_recovered_from() {
    let folder = Folder::new("recover-replay");
    recorded(&folder);
    let whole = std::fs::read(folder.join("a.mcap")).expect("a recording");
    let replayed = |file: &str| {
        let (code, _out, err) = folder.letoff(&["replay", file]);
        (code, err.lines().last().unwrap_or_default().to_owned())
    };
    for (name, damage) in DAMAGES {
        let mut bytes = whole.clone();
        damage(&mut bytes);
        let (old, new) = (format!("{name}.mcap"), format!("{name}-recovered.mcap"));
        folder.write(&old, &bytes);
        let (code, out, err) = folder.letoff(&["recover", &old]);
        assert_eq!((code, err.as_str()), (Some(0), ""));
        assert!(!out.contains("`letoff recover"), "it was done: {out}");
        let (was, is) = (replayed(&old), replayed(&new));
        assert!(
            is.1.contains(&format!("{new} was recovered from {old}, which is damaged")),
            "{is:?}"
        );
        if name == "beginning" {
            assert_eq!((was.0, is.0), (Some(2), Some(2)));
            assert!(is.1.contains("what it had at its beginning is left out"), "{}", is.1);
            assert!(is.1.contains("can be exported, but not replayed"), "{}", is.1);
        } else {
            let end = |said: &str| said.split(": ").nth(1).map(str::to_owned);
            assert_eq!((was.0, is.0), (Some(1), Some(1)), "{was:?} {is:?}");
            assert_eq!(end(&was.1), end(&is.1), "{name}");
            assert!(was.1.contains(" ticks, the same so far: "), "{}", was.1);
            assert!(was.1.contains(&format!("`letoff recover {old}`")), "{}", was.1);
        }
        // Tables contain both parts, before and after the hole.
        for file in [&old, &new] {
            let csv = format!("{file}-csv");
            let (code, _out, err) = folder.letoff(&["replay", file, "--export", &csv]);
            assert_eq!(code, Some(0), "{err}");
            let events = folder.read(&format!("{csv}/events.csv"));
            let last = events.lines().last().and_then(|line| line.split(',').next());
            assert!(last.and_then(|it| it.parse().ok()) > Some(2.5), "{last:?}");
        }
    }
}

#[test]
fn only_what_is_named_is_overwritten_by_what_was_recovered() {
    let folder = Folder::new("recover-over");
    cut(&folder);
    let before = std::fs::read(folder.join("cut.mcap")).expect("it was cut");
    for into in ["cut.mcap", "a.mcap"] {
        folder.refuses(&["recover", "cut.mcap", "--into", into], 2, &[into, "is there already"]);
    }
    folder.refuses(&["recover", "cut.mcap", "--into", "no/b.mcap"], 2, &["no/b.mcap"]);
    assert_eq!(std::fs::read(folder.join("cut.mcap")).expect("the old one"), before);
    // With the option it even replaces the old file, and leaves nothing else behind.
    let over = ["recover", "cut.mcap", "--into", "cut.mcap", "--overwrite"];
    let (code, _out, err) = folder.letoff(&over);
    assert_eq!(code, Some(0), "{err}");
    let (_code, out, _err) = folder.letoff(&["recover", "cut.mcap", "--into", "b.mcap"]);
    assert!(out.contains("cut.mcap was complete"), "{out}");
    let files = std::fs::read_dir(&*folder).expect("the folder").count();
    assert_eq!(files, 3, "a, cut and b");
}

#[test]
fn without_a_window_or_a_host_dash_says_what_to_do() {
    let folder = Folder::new("dash");
    let (code, _out, err) = folder.letoff(&["dash"]);
    assert_eq!(code, Some(1));
    let is_said = err.contains("cargo build") || err.contains("letoff run");
    assert!(is_said && err.lines().count() == 1, "{err}");
}
