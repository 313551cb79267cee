//! A supervised host beside a trial, in processes of its own: it is killed with `SIGKILL`, and what
//! outlives it is looked at.

use std::fs::{self, File};
use std::io::{self, Read as _};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use links::random::Random;
use realtime::clock;
use rustix::process::{Pid, Signal, kill_process};
use telemetry::recording::recover;

use crate::host_files::{HostFiles, SupervisedProgram};
use crate::synthesizer::Sounds;

/// How long a host plays before it is killed (s): a supervisor gives up after more than five
/// crashes in 30 s.
const PLAYS: (f64, f64) = (5.0, 11.0);
/// Time in which a host that was killed plays again, on a busy machine (s).
const BACK: f64 = 30.0;
/// Time in which the notes of a host that was killed end (s); the test's own are not real ones.
const SILENT: f64 = if cfg!(test) { 0.2 } else { 2.0 };
/// Time between two looks whether a supervisor has ended (s).
const ENDED: f64 = 0.1;
/// Time between two looks.
const LOOK: Duration = Duration::from_millis(2);
/// Crashes whose last minutes a supervisor keeps.
const KEPT: usize = 5;

/// What became of a host that was killed again and again.
#[derive(Clone, Debug, Default)]
pub(crate) struct KilledFindings {
    pub(crate) kills: usize,
    /// What is wrong with its coming back, its notes and what it left, in words.
    pub(crate) absent: Vec<String>,
    pub(crate) stuck: Vec<String>,
    pub(crate) unrecovered: Vec<String>,
    /// Notes that were heard of it.
    pub(crate) notes: u64,
}

/// A supervisor with its host, and what is heard of it.
struct KillTrial {
    supervisor: Child,
    cable: File,
    /// What came of a message so far.
    bytes: Vec<u8>,
    sounds: Sounds,
    /// Notes that were heard before the last kill.
    before: u64,
    /// Whether all was silent since then: the next host may play before somebody looks.
    was_silent: bool,
    found: KilledFindings,
}

/// Starts a supervised host and kills it at random until `is_over`, once at least.
pub(crate) fn kill_at_random(
    program: &SupervisedProgram,
    files: &HostFiles,
    seed: u64,
    is_over: &AtomicBool,
) -> io::Result<KilledFindings> {
    let cable = files.make()?;
    let mut command = Command::new(&program.program);
    command.args(&program.arguments).envs(program.environment.iter().cloned());
    let complaints = File::create(files.folder.join("complaints"))?;
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(complaints);
    let supervisor = command.spawn()?;
    let (sounds, found) = (Sounds::default(), KilledFindings::default());
    let bytes = Vec::new();
    let mut trial =
        KillTrial { supervisor, cable, bytes, sounds, before: 0, was_silent: true, found };
    let mut random = Random(seed);
    while trial.plays() && !(0 < trial.found.kills && is_over.load(Ordering::Acquire)) {
        let pause = PLAYS.0 + (PLAYS.1 - PLAYS.0) * random.unit();
        trial.wait(pause, |_trial| is_over.load(Ordering::Acquire));
        if trial.found.kills == 0 || !is_over.load(Ordering::Acquire) {
            trial.kill();
        }
    }
    trial.end();
    let mut found = trial.found;
    found.notes = trial.sounds.notes;
    found.unrecovered = unrecovered(files, found.kills.min(KEPT));
    Ok(found)
}

impl KillTrial {
    /// Hears until `is_so`, for `seconds` at most; tells whether it was.
    fn wait(&mut self, seconds: f64, is_so: impl Fn(&Self) -> bool) -> bool {
        let end = clock::monotonic().after(clock::from_seconds(seconds));
        loop {
            self.hear();
            if is_so(self) {
                return true;
            }
            if end <= clock::monotonic() {
                return false;
            }
            links::pause(LOOK);
        }
    }

    /// Takes what has come.
    fn hear(&mut self) {
        let now = clock::monotonic().as_u64() / 1_000_000;
        let mut read = [0; 256];
        // Nothing is there, or nothing more.
        while let Ok(n @ 1..) = self.cable.read(&mut read) {
            self.bytes.extend(&read[..n]);
        }
        let whole = self.bytes.len() / 3 * 3;
        for message in self.bytes.drain(..whole).collect::<Vec<_>>().chunks(3) {
            self.sounds.take(message, now);
            if !self.was_silent && self.sounds.sounding() == 0 {
                // What was on its way when the host was killed is heard by now.
                (self.was_silent, self.before) = (true, self.sounds.notes);
            }
        }
    }

    /// Waits until a note is heard since the last kill, or the supervisor has ended.
    fn plays(&mut self) -> bool {
        let end = clock::monotonic().after(clock::from_seconds(BACK));
        while !self.wait(ENDED, |it| it.before < it.sounds.notes) {
            let has_ended = !matches!(self.supervisor.try_wait(), Ok(None));
            if has_ended || end <= clock::monotonic() {
                let kills = self.found.kills;
                self.found.absent.push(format!("no note within {BACK} s after kill {kills}"));
                return false;
            }
        }
        true
    }

    /// Kills the host, and waits until its notes have ended.
    fn kill(&mut self) {
        let Some(host) = child_of(Pid::from_child(&self.supervisor)) else {
            self.found.absent.push("the supervisor has no host".to_owned());
            return;
        };
        if kill_process(host, Signal::KILL).is_err() {
            return;
        }
        self.found.kills += 1;
        self.before = self.sounds.notes;
        self.falls_silent(&format!("kill {}", self.found.kills));
    }

    fn falls_silent(&mut self, what: &str) {
        self.was_silent = self.sounds.sounding() == 0;
        if !self.wait(SILENT, |it| it.was_silent) {
            let sounding = self.sounds.sounding();
            self.found.stuck.push(format!("{sounding} notes sound {SILENT} s after {what}"));
        }
    }

    /// Ends the supervisor, which ends its host.
    fn end(&mut self) {
        // One that is gone is waited for as well.
        let _gone = kill_process(Pid::from_child(&self.supervisor), Signal::TERM);
        let end = clock::monotonic().after(clock::from_seconds(BACK));
        let status = loop {
            match self.supervisor.try_wait() {
                Ok(None) if clock::monotonic() < end => links::pause(LOOK),
                Ok(status) => break status,
                Err(_no_child) => break None,
            }
            self.hear();
        };
        match status {
            Some(status) if status.success() => {}
            Some(status) => self.found.absent.push(format!("its supervisor ended with {status}")),
            None => {
                let _gone = self.supervisor.kill();
                self.found.absent.push(format!("its supervisor did not end within {BACK} s"));
            }
        }
        self.falls_silent("the end");
    }
}

/// Returns a process that `parent` has started.
fn child_of(parent: Pid) -> Option<Pid> {
    let entries = fs::read_dir("/proc").ok()?.filter_map(Result::ok);
    let mut numbers = entries.filter_map(|entry| entry.file_name().to_str()?.parse().ok());
    let is_child = |number: &i32| {
        let line = fs::read_to_string(format!("/proc/{number}/stat")).unwrap_or_default();
        // Behind the name, which may contain anything, come the state and the parent.
        let behind = line.rsplit(')').next().unwrap_or_default();
        let its = behind.split_whitespace().nth(1).and_then(|word| word.parse().ok());
        its == Some(parent.as_raw_nonzero().get())
    };
    numbers.find(is_child).and_then(Pid::from_raw)
}

/// Returns what cannot be recovered of the minutes before the last `kept` kills.
fn unrecovered(files: &HostFiles, kept: usize) -> Vec<String> {
    let entries = fs::read_dir(&files.last_minutes).into_iter().flatten().filter_map(Result::ok);
    let paths: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    let mut wrong = Vec::new();
    if paths.len() < kept {
        wrong.push(format!("{} files are there of the last {kept} kills", paths.len()));
    }
    for path in &paths {
        match recover(path, &path.with_extension("whole.mcap")) {
            Ok(recovered) if recovered.messages == 0 => {
                wrong.push(format!("nothing is saved of {}", path.display()));
            }
            Ok(_recovered) => {}
            Err(error) => wrong.push(error.to_string()),
        }
    }
    wrong
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    /// What is found of a shell that plays a note by a child, and does `after` each of its ends.
    fn found(name: &str, after: &str) -> KilledFindings {
        let folder = format!("letoff-killed-{}-{name}", std::process::id());
        let folder = std::env::temp_dir().join(folder);
        let files = HostFiles::in_folder(&folder);
        let script = format!(
            r#"off() {{ {after}; }}
            trap 'off; kill $!; exit 0' TERM
            while :; do
                sh -c 'printf "\220\074\106" > "$0"; exec sleep 60' "$0" & wait $!
                off
            done"#
        );
        let arguments = vec!["-c".into(), script.into(), files.midi.clone().into()];
        let program = Path::new("/bin/sh").to_owned();
        let program = SupervisedProgram { program, arguments, environment: Vec::new() };
        let found = kill_at_random(&program, &files, 1, &AtomicBool::new(true)).expect("a shell");
        fs::remove_dir_all(folder).expect("its folder");
        found
    }

    #[test]
    fn a_note_that_outlives_its_host_is_stuck_and_one_that_is_ended_is_not() {
        let good = found("good", r#"printf "\200\074\100" > "$0""#);
        assert_eq!((good.kills, good.notes), (1, 2), "{good:?}");
        assert_eq!((&good.absent, &good.stuck), (&Vec::new(), &Vec::new()));
        assert_eq!(good.unrecovered, ["0 files are there of the last 1 kills"]);
        let bad = found("bad", ":");
        let stuck = ["kill 1", "the end"].map(|it| format!("1 notes sound 0.2 s after {it}"));
        assert_eq!(bad.stuck, stuck, "{bad:?}");
    }
}
