//! `letoff run --supervised`: a parent that starts the host again after a crash.
//!
//! It holds nothing itself: notes are the MIDI guardian's, forces the boards' watchdogs'.

use std::collections::VecDeque;
use std::ffi::{OsStr, OsString};
use std::fs;
use std::io;
use std::os::unix::process::ExitStatusExt as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus};
use std::time::{Duration, Instant};

use diagnostics::shown;
use rustix::process::{Pid, Signal, kill_process};
use telemetry::log::Level;
use tokio::signal::unix::{Signal as SignalStream, SignalKind, signal};

use super::log::{LogFormat, tell_as};
use super::run::{RunArgs, black_box_folder};
use super::signals::runtime;
use super::{Failure, system};
use host::control::temporary_folder;

/// Time between two looks whether the host has ended.
const LOOK: Duration = Duration::from_millis(50);

/// Most restarts within [`SPAN`].
const MOST_RESTARTS: usize = 5;

/// The time in which restarts are counted.
const SPAN: Duration = Duration::from_secs(30);

/// Crashes whose last minutes are kept; older ones of this run are removed.
const MOST_KEPT: usize = 5;

/// The greatest exit code with which a host ends of its own accord.
const ORDERLY: i32 = 2;

/// Runs the host until it ends of its own accord, or crashes too often.
pub(super) fn run(args: &RunArgs) -> Result<(), Failure> {
    if args.log_json {
        LogFormat::Json.choose();
    }
    let runtime = runtime()?;
    let folder = black_box_folder(args.black_box.as_deref());
    runtime.block_on(supervise(folder.as_deref()))
}

async fn supervise(folder: Option<&Path>) -> Result<(), Failure> {
    let mut signals = PassedSignals::new().map_err(system)?;
    let scene = LastScene::new();
    let mut crashes = CrashLog::default();
    loop {
        let kept = folder.map(LastMinutes::new);
        let mut host = start(kept.as_ref(), &scene).map_err(system)?;
        let (status, is_told) = attend(&mut host, &mut signals).await.map_err(system)?;
        if let Some(code) = status.code().filter(|code| *code <= ORDERLY) {
            kept.iter().for_each(LastMinutes::remove);
            let code = u8::try_from(code).unwrap_or(u8::MAX);
            return if code == 0 { Ok(()) } else { Err(Failure::Told(code)) };
        }
        // It was told to before it could hear.
        if is_told && is_told_so(status) {
            return Ok(());
        }
        let number = host.id();
        let before = kept.as_ref().map_or_else(String::new, LastMinutes::place);
        tell_as(Level::Error, &format!("the host (process {number}) crashed, {status}{before}"));
        if is_told {
            return Err(Failure::Running("the host crashed while it ended".to_owned()));
        }
        let Some(n) = crashes.restart(Instant::now(), kept) else {
            return Err(Failure::Running(format!(
                "the host crashed {} times in {} s, and is not started again",
                MOST_RESTARTS + 1,
                SPAN.as_secs()
            )));
        };
        let seconds = SPAN.as_secs();
        let text = format!("it is started again, {n} of at most {MOST_RESTARTS} in {seconds} s");
        tell_as(Level::Warning, &text);
    }
}

/// Returns whether a signal that asks for the end has ended the host.
fn is_told_so(status: ExitStatus) -> bool {
    status.signal().is_some_and(|it| [Signal::INT, Signal::TERM].map(Signal::as_raw).contains(&it))
}

/// Starts the host with what was typed.
fn start(kept: Option<&LastMinutes>, scene: &LastScene) -> io::Result<Child> {
    let mut typed: Vec<OsString> = std::env::args_os().skip(1).collect();
    typed.retain(|word| word != OsStr::new("--supervised"));
    let mut command = Command::new(host::guardian::program());
    command.args(typed).arg(format!("--supervisor={}", std::process::id()));
    if let Some(kept) = kept {
        command.arg("--last-minutes").arg(&kept.file);
    }
    if let Some(file) = &scene.file {
        command.arg("--last-scene").arg(file);
    }
    command.spawn()
}

/// Waits for the host, and passes signals on; returns how it ended, and whether a signal had told
/// it to.
async fn attend(host: &mut Child, signals: &mut PassedSignals) -> io::Result<(ExitStatus, bool)> {
    let mut looks = tokio::time::interval(LOOK);
    let mut is_told = false;
    loop {
        tokio::select! {
            signal = signals.next() => {
                is_told |= signal != Signal::HUP;
                // Until it was waited for, its number is not used again.
                let _gone = kill_process(Pid::from_child(host), signal);
            }
            _ = looks.tick() => {
                if let Some(status) = host.try_wait()? {
                    return Ok((status, is_told));
                }
            }
        }
    }
}

/// The signals that are meant for the host.
struct PassedSignals {
    interrupt: SignalStream,
    terminate: SignalStream,
    hang_up: SignalStream,
}

impl PassedSignals {
    fn new() -> io::Result<Self> {
        Ok(Self {
            interrupt: signal(SignalKind::interrupt())?,
            terminate: signal(SignalKind::terminate())?,
            hang_up: signal(SignalKind::hangup())?,
        })
    }

    async fn next(&mut self) -> Signal {
        tokio::select! {
            _ = self.interrupt.recv() => Signal::INT,
            _ = self.terminate.recv() => Signal::TERM,
            _ = self.hang_up.recv() => Signal::HUP,
        }
    }
}

/// The crashes of the last seconds, and what is kept of earlier ones.
#[derive(Default)]
struct CrashLog {
    times: VecDeque<Instant>,
    kept: VecDeque<LastMinutes>,
}

impl CrashLog {
    /// Notes a crash at `now`; returns the number of the restart that it is worth, if there were
    /// not too many.
    fn restart(&mut self, now: Instant, kept: Option<LastMinutes>) -> Option<usize> {
        self.times.retain(|at| now.duration_since(*at) < SPAN);
        self.times.push_back(now);
        self.kept.extend(kept);
        if MOST_KEPT < self.kept.len() {
            self.kept.pop_front().iter().for_each(LastMinutes::remove);
        }
        (self.times.len() <= MOST_RESTARTS).then_some(self.times.len())
    }
}

/// The files in which a host keeps its last minutes.
struct LastMinutes {
    /// The first of them; the others have its name and a number.
    file: PathBuf,
}

impl LastMinutes {
    /// Returns a name in `folder`, which is made if it is not there.
    fn new(folder: &Path) -> Self {
        // A host that cannot write there says so.
        let _told_later = fs::create_dir_all(folder);
        let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
        let now = now.map_or(0, |it| it.as_millis());
        Self { file: folder.join(format!("before-crash-{now}-{}.mcap", std::process::id())) }
    }

    /// Returns its files, the oldest first.
    fn files(&self) -> Vec<PathBuf> {
        let stem = self.file.file_stem().unwrap_or_default().to_string_lossy();
        let entries = self.file.parent().map(fs::read_dir).and_then(Result::ok);
        let paths = entries.into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path()));
        let is_one = |path: &PathBuf| {
            path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(&*stem))
        };
        let mut files: Vec<_> = paths.filter(is_one).collect();
        files.sort();
        files
    }

    /// Returns where they are, as the end of a sentence.
    fn place(&self) -> String {
        let files: Vec<_> = self.files().iter().map(|it| shown(it)).collect();
        if files.is_empty() {
            return "; it had recorded nothing yet".to_owned();
        }
        let files = files.join(" and ");
        format!("; what went before is in {files}: `letoff recover` makes it whole")
    }

    fn remove(&self) {
        for file in self.files() {
            let _gone = fs::remove_file(file);
        }
    }
}

/// The file in which a host keeps the scene that it has taken last, for the one after a crash.
struct LastScene {
    /// None if there is no place that is this user's.
    file: Option<PathBuf>,
}

impl LastScene {
    fn new() -> Self {
        let name = format!("supervised-{}.toml", std::process::id());
        let scene = Self { file: temporary_folder().ok().map(|folder| folder.join(name)) };
        // A process of the same number may have been killed.
        scene.remove();
        scene
    }

    fn remove(&self) {
        let _gone = self.file.as_ref().map(fs::remove_file);
    }
}

impl Drop for LastScene {
    fn drop(&mut self) {
        self.remove();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn five_crashes_in_half_a_minute_are_enough_and_old_ones_are_forgotten() {
        let begun = Instant::now();
        let mut crashes = CrashLog::default();
        let mut at = |seconds| crashes.restart(begun + Duration::from_secs(seconds), None);
        assert_eq!([0, 1, 2, 3, 4].map(&mut at), [1, 2, 3, 4, 5].map(Some));
        assert_eq!(at(5), None);
        assert_eq!(at(100), Some(1));
    }
}
