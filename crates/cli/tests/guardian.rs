//! Hosts that are killed, stopped and started again, and the bytes that a synthesizer receives
//! meanwhile: real processes, and a cable in a FIFO.

use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions};
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use midi::{Message, Output as _, Smf};
use rustix::process::{Pid, Signal, kill_process};

use crate::typed::{Folder, cable, eventually};

/// An octave, so that its piece is rehearsed at once.
const SCENE: &str = r#"
tick_hz = 1000
[[keys]]
range = "C4..C5"
instrument = "grand-springs"
[links]
kind = "simulated"
[pianist]
performance = "piece.mid"
"#;

const CHORD: [u8; 3] = [60, 64, 67];
const REPEATED: u8 = 72;

/// Writes a chord and the pedal, held for 100 s, and a note that is repeated twice a second.
fn write_piece(path: PathBuf) {
    let mut piece = Smf::new(path);
    let mut send = |ms: u32, bytes: [u8; 3]| {
        let message = Message::decode(&bytes).expect("a message");
        piece.send(f64::from(ms) * 1e-3, message).expect("a time");
    };
    send(0, [0xB0, 64, 127]);
    for note in CHORD {
        send(500, [0x90, note, 70]);
    }
    for at in (1000..100_000).step_by(500) {
        send(at, [0x90, REPEATED, 70]);
        send(at + 250, [0x80, REPEATED, 64]);
    }
    for note in CHORD {
        send(100_000, [0x80, note, 64]);
    }
    piece.finish().expect("a file");
}

/// Notes received at the other end of a FIFO.
#[derive(Default)]
struct Heard {
    messages: Vec<[u8; 3]>,
    sounding: BTreeSet<u8>,
    pedal: u8,
    /// Note-offs of silent notes that no restart explains.
    unasked: usize,
}

impl Heard {
    fn hear(&mut self, message: [u8; 3]) {
        self.messages.push(message);
        match message {
            [0x90, note, _] => _ = self.sounding.insert(note),
            [0x80, note, _] => self.unasked += usize::from(!self.sounding.remove(&note)),
            [0xB0, 64, value] => self.pedal = value,
            _ => {}
        }
    }

    fn is_silent(&self) -> bool {
        self.sounding.is_empty() && self.pedal == 0
    }

    fn holds_the_chord(&self) -> bool {
        CHORD.iter().all(|note| self.sounding.contains(note)) && self.pedal == 127
    }

    fn strikes(&self) -> usize {
        self.messages.iter().filter(|it| it[0] == 0x90).count()
    }
}

/// A folder with a scene, a FIFO, and a thread that reads it.
struct Stand {
    folder: Folder,
    heard: Arc<Mutex<Heard>>,
}

impl Stand {
    fn new(name: &str) -> Self {
        let folder = Folder::new(name);
        folder.write("scene.toml", SCENE);
        write_piece(folder.join("piece.mid"));
        let heard = Arc::<Mutex<Heard>>::default();
        let cable = cable(&folder.join("fifo"));
        let its = Arc::clone(&heard);
        std::thread::spawn(move || listen(cable, &its));
        Self { folder, heard }
    }

    fn start(&self, arguments: &[&str]) -> Host<'_> {
        let usual = ["run", "scene.toml", "--midi", "raw:fifo", "--listen", "none", "--json"];
        let letoff = Path::new(env!("CARGO_BIN_EXE_letoff"));
        let mut command = self.folder.command(letoff, &[&usual[..], arguments].concat());
        command.stdout(File::create(self.folder.join("report")).expect("a file"));
        let complaints = self.folder.join("complaints");
        let complaints = OpenOptions::new().create(true).append(true).open(complaints);
        let complaints = complaints.expect("a file");
        command.stderr(Stdio::from(complaints));
        Host { child: command.spawn().expect("a process"), stand: self }
    }

    fn heard(&self) -> MutexGuard<'_, Heard> {
        self.heard.lock().unwrap_or_else(PoisonError::into_inner)
    }

    #[track_caller]
    fn hears(&self, what: &str, is_so: impl Fn(&Heard) -> bool) {
        eventually(what, || is_so(&self.heard()).then_some(()));
    }

    fn guardians(&self) -> Vec<i32> {
        let path = self.folder.join("socket.midi").display().to_string();
        let is_one = |words: &[String]| {
            words.get(1).is_some_and(|word| word == "midi-guardian")
                && words.get(2).is_some_and(|word| word.starts_with(&path))
        };
        processes().into_iter().filter(|(_, words)| is_one(words)).map(|(pid, _)| pid).collect()
    }

    fn guardian(&self) -> i32 {
        let guardians = self.guardians();
        assert_eq!(guardians.len(), 1, "{guardians:?}");
        guardians[0]
    }

    fn complaints(&self) -> String {
        self.folder.read("complaints")
    }
}

fn listen(mut cable: File, heard: &Mutex<Heard>) {
    let mut bytes = Vec::new();
    let mut read = [0; 256];
    while let Ok(n) = cable.read(&mut read) {
        bytes.extend(&read[..n]);
        while let Some(message) = bytes.first_chunk::<3>().copied() {
            bytes.drain(..3);
            heard.lock().unwrap_or_else(PoisonError::into_inner).hear(message);
        }
    }
}

fn processes() -> Vec<(i32, Vec<String>)> {
    let entries = fs::read_dir("/proc").expect("/proc").filter_map(Result::ok);
    let process = |path: PathBuf| {
        let pid = path.file_name()?.to_str()?.parse().ok()?;
        let words = fs::read(path.join("cmdline")).ok()?;
        let words = words.split(|byte| *byte == 0);
        Some((pid, words.map(|word| String::from_utf8_lossy(word).into_owned()).collect()))
    };
    entries.filter_map(|entry| process(entry.path())).collect()
}

struct Host<'a> {
    child: Child,
    stand: &'a Stand,
}

impl Host<'_> {
    fn send(&self, signal: Signal) {
        kill_process(Pid::from_child(&self.child), signal).expect("it is there");
    }

    fn end(mut self) -> Option<i32> {
        self.child.wait().expect("it is ours").code()
    }

    /// Ends it as a user does, and asserts silence and no left-over process.
    #[track_caller]
    fn ends_well(self) {
        let stand = self.stand;
        self.send(Signal::TERM);
        assert_eq!(self.end(), Some(0), "{}", stand.complaints());
        stand.hears("silence at the end", Heard::is_silent);
        eventually("no guardian is left", || stand.guardians().is_empty().then_some(()));
        assert!(!stand.folder.join("socket.midi").exists());
    }
}

impl Drop for Host<'_> {
    fn drop(&mut self) {
        if matches!(self.child.try_wait(), Ok(None)) {
            let _gone = self.child.kill();
            let _ended = self.child.wait();
        }
    }
}

impl Drop for Stand {
    fn drop(&mut self) {
        // A stopped process receives nothing else.
        for guardian in self.guardians() {
            let _gone = kill(guardian, Signal::KILL);
        }
    }
}

fn kill(pid: i32, signal: Signal) -> rustix::io::Result<()> {
    kill_process(Pid::from_raw(pid).expect("a process"), signal)
}

#[test]
fn a_host_that_is_killed_leaves_silence_and_its_port_to_the_next_one() {
    let stand = Stand::new("killed");
    let mut host = stand.start(&[]);
    stand.hears("the chord", Heard::holds_the_chord);
    let guardian = stand.guardian();
    host.child.kill().expect("it is there");
    stand.hears("silence", Heard::is_silent);
    assert_eq!(stand.heard().unasked, 0);
    let ended = stand.heard().messages.len();
    let next = stand.start(&[]);
    stand.hears("the chord again", Heard::holds_the_chord);
    assert_eq!(stand.guardian(), guardian, "another process holds the port");
    assert!(ended < stand.heard().messages.len());
    drop(host.child.wait());
    next.ends_well();
}

#[test]
fn a_host_that_is_stopped_has_its_notes_ended_and_goes_on_without_a_stuck_one() {
    let stand = Stand::new("stopped");
    let host = stand.start(&[]);
    stand.hears("the chord", Heard::holds_the_chord);
    host.send(Signal::STOP);
    stand.hears("silence", Heard::is_silent);
    let strikes = stand.heard().strikes();
    host.send(Signal::CONT);
    stand.hears("strikes, with the pedal", |it| strikes + 1 < it.strikes() && it.pedal == 127);
    host.ends_well();
    let heard = stand.heard();
    assert_eq!(heard.unasked, 0, "notes that the guardian had ended were ended again");
    let report: serde_json::Value =
        serde_json::from_str(&stand.folder.read("report")).expect("a report");
    assert!(report["midi"]["interruptions"].as_u64() >= Some(1), "{report}");
    assert!(report["midi"]["passed_on_us"]["p50"].as_f64() > Some(0.0), "{report}");
    assert!(stand.complaints().contains("gave no sign for 0.5 s"), "{}", stand.complaints());
}

/// Sends `signal` to the guardian while a chord is held, and asserts that another one ends it.
#[track_caller]
fn check_replaced(name: &str, signal: Signal) {
    let stand = Stand::new(name);
    let host = stand.start(&[]);
    stand.hears("the chord", Heard::holds_the_chord);
    let (guardian, heard) = (stand.guardian(), stand.heard().messages.len());
    kill(guardian, signal).expect("it is there");
    eventually("another guardian", || (stand.guardians() != [guardian]).then_some(()));
    stand.hears("its note-offs", |it| CHORD.iter().all(|note| !it.sounding.contains(note)));
    stand.hears("strikes", |it| it.messages[heard..].iter().filter(|m| m[0] == 0x90).count() > 4);
    let said = stand.complaints();
    assert!(said.contains("another one is started"), "{said}");
    let ended = stand.heard().messages[heard..].to_vec();
    for note in CHORD {
        assert!(ended.contains(&[0x80, note, 64]), "{note} was not ended: {ended:?}");
    }
    assert_eq!(stand.heard().pedal, 127, "the pedal is still held");
    host.ends_well();
}

#[test]
fn a_guardian_that_is_killed_is_replaced_note_offs_first() {
    check_replaced("guardian-killed", Signal::KILL);
}

#[test]
fn a_guardian_that_hangs_is_replaced_note_offs_first() {
    check_replaced("guardian-hangs", Signal::STOP);
}

/// Signals to the host and its guardian, and `true` if the host's comes first.
type Deaths = (Option<Signal>, Option<Signal>, bool);

/// Returns every subset of host and guardian, every signal, both orders.
fn deaths() -> Vec<Deaths> {
    let signals = [None, Some(Signal::KILL), Some(Signal::STOP), Some(Signal::TERM)];
    let pairs = signals.iter().flat_map(|host| signals.iter().map(move |it| (*host, *it)));
    let all = pairs.flat_map(|(host, guardian)| [(host, guardian, true), (host, guardian, false)]);
    let is_one = |&(host, guardian, host_first): &Deaths| match (host, guardian) {
        (None, None) => false,
        (None, _) | (_, None) => host_first,
        (Some(_), Some(_)) => true,
    };
    all.filter(is_one).collect()
}

/// Applies `deaths` to a host and a guardian that hold a chord and the pedal, and asserts that both
/// end, at the latest when the next host opens the port.
fn check_ended(name: &str, deaths: Deaths) {
    let (host_signal, guardian_signal, host_first) = deaths;
    let stand = Stand::new(name);
    let host = stand.start(&[]);
    stand.hears("the chord", Heard::holds_the_chord);
    let (guardian, heard) = (stand.guardian(), stand.heard().messages.len());
    let reach_host = || _ = host_signal.map(|signal| host.send(signal));
    let reach_guardian = || _ = guardian_signal.map(|signal| kill(guardian, signal));
    if host_first {
        reach_host();
        reach_guardian();
    } else {
        reach_guardian();
        reach_host();
    }
    // A surviving host continues to play, with its pedal.
    let has_ended = || {
        let heard = &stand.heard().messages[heard..];
        let ends = CHORD.iter().all(|note| heard.contains(&[0x80, *note, 64]));
        ends && heard.contains(&[0xB0, 64, 0])
    };
    let begun = Instant::now();
    while !has_ended() && begun.elapsed() < Duration::from_secs(3) {
        std::thread::sleep(Duration::from_millis(10));
    }
    if has_ended() {
        return;
    }
    let next = stand.start(&["--performance", "none"]);
    let what = format!("{deaths:?}: the end at the next opening: {}", stand.complaints());
    eventually(&what, || has_ended().then_some(()));
    drop(next);
}

#[test]
fn notes_and_pedals_end_whatever_dies_in_whatever_order() {
    let all = deaths();
    assert_eq!(all.len(), 24);
    std::thread::scope(|scope| {
        for first in 0..4 {
            let mine = all.iter().enumerate().skip(first).step_by(4);
            let check = |(index, deaths): (usize, &Deaths)| {
                check_ended(&format!("deaths-{index}"), *deaths);
            };
            scope.spawn(move || mine.for_each(check));
        }
    });
}

#[test]
fn what_another_host_holds_at_the_same_port_is_not_ended() {
    let stand = Stand::new("beside");
    let host = stand.start(&[]);
    stand.hears("the chord", Heard::holds_the_chord);
    let beside = stand.start(&["--performance", "none", "--duration", "0.5"]);
    assert_eq!(beside.end(), Some(0), "{}", stand.complaints());
    assert!(stand.heard().holds_the_chord());
    assert_eq!(stand.heard().unasked, 0);
    host.ends_well();
    assert!(!stand.complaints().contains("guardian is gone"), "{}", stand.complaints());
}

#[test]
fn a_guardian_that_dies_while_its_host_ends_is_replaced_before_the_end() {
    let stand = Stand::new("dies-at-the-end");
    let host = stand.start(&[]);
    stand.hears("the chord", Heard::holds_the_chord);
    let guardian = stand.guardian();
    kill(guardian, Signal::STOP).expect("it is there");
    host.send(Signal::TERM);
    // The host waits for an answer that does not come.
    std::thread::sleep(Duration::from_millis(500));
    kill(guardian, Signal::KILL).expect("it is there");
    host.ends_well();
}

const KEPT: [&str; 4] = ["--last-scene", "last.toml", "--black-box", "none"];

#[test]
fn a_host_that_was_killed_plays_the_scene_that_was_accepted_last() {
    let stand = Stand::new("accepted-last");
    let mut host = stand.start(&KEPT);
    stand.hears("the chord", Heard::holds_the_chord);
    let accepts = |host: &Host<'_>, end: &str| {
        stand.folder.write("scene.toml", format!("{SCENE}{end}"));
        host.send(Signal::HUP);
        let is_kept = || stand.folder.read("last.toml").ends_with(end);
        eventually("the scene is accepted", || is_kept().then_some(()));
    };
    accepts(&host, "# accepted\n");
    stand.folder.write("scene.toml", "half a sce");
    host.send(Signal::HUP);
    let rejected = || stand.complaints().contains("the scene is wrong, and the one that plays");
    eventually("the new scene is rejected", || rejected().then_some(()));
    host.child.kill().expect("it is there");
    stand.hears("silence", Heard::is_silent);
    drop(host.child.wait());
    // The same command line again, as from a service manager.
    host = stand.start(&KEPT);
    stand.hears("the chord again", Heard::holds_the_chord);
    let said = stand.complaints();
    assert!(said.contains("last.toml has the scene that it played"), "{said}");
    assert!(stand.folder.read("last.toml").ends_with("# accepted\n"));
    // The corrected file is read with the overrides of the command line.
    accepts(&host, "# right again\n");
    host.ends_well();
    assert!(!stand.folder.join("last.toml").exists(), "a good end forgets the scene");
}

#[test]
fn a_stop_between_a_crash_and_the_next_start_is_heard() {
    let stand = Stand::new("stop-between");
    let mut host = stand.start(&KEPT);
    stand.hears("the chord", Heard::holds_the_chord);
    host.child.kill().expect("it is there");
    drop(host.child.wait());
    std::thread::scope(|scope| {
        let stop = scope.spawn(|| stand.folder.letoff(&["stop"]));
        let next = stand.start(&KEPT);
        let (code, out, err) = stop.join().expect("no panic");
        assert_eq!(code, Some(0), "{out}{err}");
        assert_eq!(next.end(), Some(0), "{}", stand.complaints());
    });
    stand.hears("silence", Heard::is_silent);
}

#[test]
fn a_port_that_is_not_there_is_told_and_leaves_no_guardian() {
    let stand = Stand::new("absent");
    let midi = ["run", "springs", "--performance", "none", "--midi", "raw:nothing"];
    stand.folder.refuses(&midi, 1, &["no MIDI can be written to", "there is no such file"]);
    eventually("no guardian is left", || stand.guardians().is_empty().then_some(()));
}

#[test]
fn a_host_without_a_place_for_sockets_plays_and_says_that_nothing_guards_its_notes() {
    let stand = Stand::new("no-place");
    let arguments = ["run", "scene.toml", "--midi", "raw:fifo", "--listen", "none", "--json"];
    let letoff = Path::new(env!("CARGO_BIN_EXE_letoff"));
    let mut command =
        stand.folder.command(letoff, &[&arguments[..], &["--duration", "3"]].concat());
    let output = command.env("LETOFF_SOCKET", "/no/such/folder/socket").output().expect("it runs");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).expect("a report");
    let words = report["midi"]["output"].as_str().expect("words");
    assert!(words.contains("unguarded: no MIDI guardian"), "{words}");
    assert!(stand.heard().strikes() >= CHORD.len());
}
