//! The host's MIDI output, held by a guardian.

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use engine::realtime::clock;
use midi::{HeldNotes, Message, MidiSendError, Output, Unavailable};

use super::channel::GuardianChannel;
use super::protocol::{GuardedPort, GuardianLine, HostLine, PassedOn, VERSION, is_missing};
use crate::report::Quantiles;

/// Longest wait for a port to open or to end; a sequencer takes some milliseconds.
const PATIENCE: Duration = Duration::from_secs(5);

/// Unanswered beats, at twenty per second, after which a guardian counts as hanging.
const MOST_UNANSWERED: u32 = 40;

/// Minimum time between two attempts to start a guardian (s).
const INTERVAL: f64 = 1.0;

#[derive(Debug, thiserror::Error)]
pub(crate) enum GuardianTrouble {
    #[error("{0}")]
    Missing(String),
    #[error("{0}")]
    Refused(String),
    #[error("no MIDI guardian can be started at {path}: {source}")]
    NoGuardian { path: PathBuf, source: io::Error },
}

impl From<Unavailable> for GuardianTrouble {
    fn from(why: Unavailable) -> Self {
        let text = why.to_string();
        if is_missing(&why) { Self::Missing(text) } else { Self::Refused(text) }
    }
}

/// A guardian's account of a run, for its report.
#[derive(Clone, Debug, Default)]
pub(crate) struct GuardianReport {
    pub(crate) n_lost: u64,
    pub(crate) trouble: Option<String>,
    /// Silences of the host so long that its notes were ended.
    pub(crate) n_interruptions: u64,
    /// Time from the host's write to the port.
    pub(crate) passed_on: Option<Quantiles>,
}

pub(crate) type SayLine = Box<dyn Fn(String) + Send>;

/// A port behind a guardian that is replaced if it dies.
pub(crate) struct GuardedOutput {
    path: PathBuf,
    port: GuardedPort,
    channel: Option<GuardianChannel>,
    held: HeldNotes,
    unanswered: u32,
    /// Time of the last start of a replacement (s).
    attempted: Option<f64>,
    report: Arc<Mutex<GuardianReport>>,
    say: SayLine,
}

impl GuardedOutput {
    /// Opens `port` behind the guardian at `path`, or starts one; `say` logs changes.
    pub(crate) fn open(
        path: &Path,
        port: GuardedPort,
        say: SayLine,
    ) -> Result<Self, GuardianTrouble> {
        let (path, channel) = open(path, &port)?;
        Ok(Self {
            path,
            port,
            channel: Some(channel),
            held: HeldNotes::default(),
            unanswered: 0,
            attempted: None,
            report: Arc::default(),
            say,
        })
    }

    /// Returns the shared report, which outlives this output.
    pub(crate) fn report(&self) -> Arc<Mutex<GuardianReport>> {
        Arc::clone(&self.report)
    }

    fn receive(&mut self) -> io::Result<()> {
        let channel = self.channel.as_mut().ok_or(ErrorKind::NotConnected)?;
        while let Some(line) = channel.receive()? {
            if let GuardianLine::Beat(passed_on) = line {
                self.unanswered = 0;
                note(&self.report, &self.say, &passed_on);
            }
        }
        if MOST_UNANSWERED < self.unanswered { Err(ErrorKind::TimedOut.into()) } else { Ok(()) }
    }

    fn send_line(&mut self, line: &HostLine) -> io::Result<()> {
        self.channel.as_mut().ok_or(ErrorKind::NotConnected)?.send(line)
    }

    fn finish_guardian(&mut self) -> io::Result<()> {
        let channel = self.channel.as_mut().ok_or(ErrorKind::NotConnected)?;
        channel.send(&HostLine::Finish)?;
        if let GuardianLine::Finished { passed_on, after_us } = channel.wait(PATIENCE)? {
            note(&self.report, &self.say, &passed_on);
            lock(&self.report).passed_on = after_us;
        }
        Ok(())
    }

    /// Does `work` at time `now` (s), with another guardian if this one fails.
    fn attempt(
        &mut self,
        now: f64,
        work: impl Fn(&mut Self) -> io::Result<()>,
    ) -> Result<(), MidiSendError> {
        work(self).or_else(|error| {
            self.replace(now, &error)?;
            work(self).map_err(|error| MidiSendError::NoGuardian { reason: error.to_string() })
        })
    }

    /// Replaces a guardian that failed for `why`, at time `now` (s): sends note-offs first, then
    /// the pedals that are down.
    fn replace(&mut self, now: f64, why: &io::Error) -> Result<(), MidiSendError> {
        if let Some(channel) = self.channel.take() {
            (self.say)(format!("the MIDI guardian is gone ({why}): another one is started"));
            // A guardian that is gone has closed its socket; one that still holds it hangs.
            if matches!(why.kind(), ErrorKind::TimedOut | ErrorKind::WouldBlock) {
                channel.kill();
            }
        }
        let failed = |reason: String| MidiSendError::NoGuardian { reason };
        if self.attempted.is_some_and(|at| now - at < INTERVAL) {
            return Err(failed(why.to_string()));
        }
        self.attempted = Some(now);
        let pedals = self.held.pedals();
        let opened = open(&self.path, &self.port);
        let (path, channel) = opened.map_err(|error| failed(error.to_string()))?;
        (self.path, self.channel, self.unanswered) = (path, Some(channel), 0);
        self.held = HeldNotes::default();
        (self.say)("another MIDI guardian has ended the notes of the one before".to_owned());
        pedals.into_iter().try_for_each(|pedal| self.send(now, pedal))
    }
}

impl Output for GuardedOutput {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        let line = HostLine::Message {
            bytes: message.encode().to_vec(),
            handed_over: clock::monotonic().as_u64(),
        };
        self.attempt(at, |it| it.send_line(&line))?;
        self.held.follow(message);
        Ok(())
    }

    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        self.unanswered += 1;
        let beaten = self.receive().and_then(|()| self.send_line(&HostLine::Beat));
        beaten.or_else(|error| self.replace(now, &error))
    }

    /// Finishes the guardian; one that fails is replaced, since its notes would remain.
    fn finish(&mut self) -> Result<(), MidiSendError> {
        if self.channel.is_none() {
            return Ok(());
        }
        // However soon after the last replacement.
        let finished = self.attempt(f64::INFINITY, Self::finish_guardian);
        self.channel = None;
        finished
    }
}

impl Drop for GuardedOutput {
    /// Lets the guardian end if a prepared run does not begin. After a panic it stays, so that
    /// the port is still there for the next host.
    fn drop(&mut self) {
        if !std::thread::panicking() {
            let _gone = self.send_line(&HostLine::Finish);
        }
    }
}

/// Opens `port` behind the guardian at `path`, or behind this process's own if that one declines.
fn open(path: &Path, port: &GuardedPort) -> Result<(PathBuf, GuardianChannel), GuardianTrouble> {
    let no_guardian =
        |path: &Path, source| GuardianTrouble::NoGuardian { path: path.to_owned(), source };
    let mut own = path.as_os_str().to_owned();
    own.push(format!(".{}", std::process::id()));
    let hello = HostLine::Hello { version: VERSION, port: port.clone() };
    let mut trouble = io::Error::from(ErrorKind::NotConnected);
    // The first may be about to end with its host; the second is another host's.
    for path in [path, path, Path::new(&own)] {
        match greet(path, &hello) {
            Ok((channel, GuardianLine::Opened {})) => return Ok((path.to_owned(), channel)),
            Ok((_, GuardianLine::Missing { why })) => return Err(GuardianTrouble::Missing(why)),
            Ok((_, GuardianLine::Refused { why })) => return Err(GuardianTrouble::Refused(why)),
            Ok((_, GuardianLine::Declined { why })) => trouble = io::Error::other(why),
            Ok((_, GuardianLine::Beat(_) | GuardianLine::Finished { .. })) => {
                trouble = ErrorKind::InvalidData.into();
            }
            Err(error) => trouble = error,
        }
    }
    Err(no_guardian(path, trouble))
}

/// Sends `hello` to the guardian at `path`; returns its answer, or kills it if it hangs.
fn greet(path: &Path, hello: &HostLine) -> io::Result<(GuardianChannel, GuardianLine)> {
    let mut channel = GuardianChannel::reach(path)?;
    channel.send(hello)?;
    match channel.wait(PATIENCE) {
        Ok(answer) => Ok((channel, answer)),
        Err(error) if error.kind() == ErrorKind::TimedOut => {
            channel.kill();
            Err(error)
        }
        Err(error) => Err(error),
    }
}

fn note(report: &Mutex<GuardianReport>, say: &SayLine, passed_on: &PassedOn) {
    let mut report = lock(report);
    let PassedOn { n_lost, trouble, n_interruptions } = passed_on.clone();
    if report.n_interruptions < n_interruptions {
        say(format!(
            "the host gave no sign for {} s: the notes that it held were ended meanwhile",
            midi::guardian::SILENT_AFTER
        ));
    }
    if report.n_lost < n_lost {
        let why = trouble.as_deref().unwrap_or("the port does not take them");
        say(format!("{} MIDI messages were lost: {why}", n_lost - report.n_lost));
    }
    report.n_interruptions = report.n_interruptions.max(n_interruptions);
    report.n_lost = report.n_lost.max(n_lost);
    report.trouble = report.trouble.take().or(trouble);
}

fn lock(report: &Mutex<GuardianReport>) -> MutexGuard<'_, GuardianReport> {
    report.lock().unwrap_or_else(PoisonError::into_inner)
}
