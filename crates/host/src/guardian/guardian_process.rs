//! The guardian's own process: one host at a time, and silence without one.

use std::{
    io, os::fd::AsFd as _, os::unix::net::UnixListener as StdListener, path::Path, time::Duration,
};

use engine::realtime::thread::{ThreadPlan, WantedPolicy};
use engine::realtime::{clock, memory, run::histogram};
use hdrhistogram::Histogram;
use midi::{Message, MidiSendError, NoteGuardian, Unavailable};
use scheduler::time::Nanos;
use tokio::io::{AsyncBufReadExt as _, BufReader, Lines};
use tokio::net::unix::{OwnedReadHalf, OwnedWriteHalf};
use tokio::net::{UnixListener, UnixStream};
use tokio::signal::unix::{Signal, SignalKind, signal};
use tokio::time::MissedTickBehavior;

use super::protocol::{GuardedPort, GuardianLine, HostLine, PassedOn, VERSION, is_missing};
use crate::midi_thread::{AnyOutput, PRIORITY};
use crate::{control::place, report::Quantiles};

/// Interval of the checks of the host's beats and of the port.
const LOOK: Duration = Duration::from_millis(50);

const KEPT: Duration = Duration::from_mins(1);

const BACKLOG: i32 = 16;

/// Time in which the host that started it connects.
const EXPECTED: Duration = Duration::from_secs(10);

/// Holds a port and its notes for hosts that connect to the socket on standard input, whose file
/// is at `path`; returns after a minute without a host, or at a signal.
///
/// # Errors
/// If standard input is no listening socket, or a system call fails.
pub fn attend(path: &Path) -> io::Result<()> {
    let listener = StdListener::from(io::stdin().as_fd().try_clone_to_owned()?);
    listener.local_addr()?;
    // From now on a client sees this process behind the socket, not the host that made it.
    rustix::net::listen(&listener, BACKLOG)?;
    listener.set_nonblocking(true)?;
    // Best effort; without it the guardian is as late as every other program.
    let plan = ThreadPlan { policy: WantedPolicy::Fifo(PRIORITY), cpus: Vec::new() };
    let _granted = (plan.ask(0), memory::lock());
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
    let mut guardian = GuardianProcess::new()?;
    let attended = runtime.block_on(guardian.attend_hosts(listener));
    guardian.close(path);
    attended
}

struct OpenPort {
    port: GuardedPort,
    notes: NoteGuardian<AnyOutput>,
}

struct GuardianProcess {
    begun: Nanos,
    open: Option<OpenPort>,
    passed_on: PassedOn,
    /// Time from the host's write to the port (ns).
    after: Histogram<u64>,
    is_finished: bool,
}

struct ConnectedHost {
    lines: Lines<BufReader<OwnedReadHalf>>,
    writer: OwnedWriteHalf,
}

impl ConnectedHost {
    fn new(stream: UnixStream) -> Self {
        let (reader, writer) = stream.into_split();
        Self { lines: BufReader::new(reader).lines(), writer }
    }

    /// Sends `line`, or drops it if the host has not read for so long that there is no room.
    fn say(&self, line: &GuardianLine) {
        if let Ok(mut text) = serde_json::to_vec(line) {
            text.push(b'\n');
            let _unread = self.writer.try_write(&text);
        }
    }
}

struct EndSignals([Signal; 3]);

impl EndSignals {
    fn new() -> io::Result<Self> {
        let on = |kind: fn() -> SignalKind| signal(kind());
        Ok(Self([on(SignalKind::interrupt)?, on(SignalKind::terminate)?, on(SignalKind::hangup)?]))
    }

    async fn come(&mut self) {
        let [interrupt, terminate, hang_up] = &mut self.0;
        tokio::select! {
            _ = interrupt.recv() => {}
            _ = terminate.recv() => {}
            _ = hang_up.recv() => {}
        }
    }
}

impl GuardianProcess {
    fn new() -> io::Result<Self> {
        Ok(Self {
            begun: clock::monotonic(),
            open: None,
            passed_on: PassedOn::default(),
            after: histogram().map_err(io::Error::other)?,
            is_finished: false,
        })
    }

    /// Returns the time since the start (s).
    fn now(&self) -> f64 {
        clock::monotonic().since(self.begun).as_secs_f64()
    }

    async fn attend_hosts(&mut self, listener: StdListener) -> io::Result<()> {
        let listener = UnixListener::from_std(listener)?;
        let mut signals = EndSignals::new()?;
        let mut looks = tokio::time::interval(LOOK);
        looks.set_missed_tick_behavior(MissedTickBehavior::Skip);
        let mut host: Option<ConnectedHost> = None;
        let mut waits_until = self.now() + EXPECTED.as_secs_f64();
        loop {
            tokio::select! {
                biased;
                () = signals.come() => return Ok(()),
                line = next_line(&mut host) => {
                    let answer = line.as_deref().map(|line| self.hear(line));
                    match (answer, &host) {
                        (Some(Ok(Some(answer))), Some(host)) => host.say(&answer),
                        (Some(Ok(_)), _) => {}
                        (Some(Err(_)) | None, _) => host = None,
                    }
                    if self.is_finished {
                        return Ok(());
                    }
                    if host.is_none() {
                        self.leave();
                        waits_until = self.now() + self.kept().as_secs_f64();
                    }
                }
                Ok((stream, _)) = listener.accept() => admit(stream, &mut host),
                _ = looks.tick() => self.poll(),
            }
            if host.is_none() && waits_until <= self.now() {
                return Ok(());
            }
        }
    }

    /// Returns the time to wait for another host; zero without a port.
    fn kept(&self) -> Duration {
        if self.open.is_some() { KEPT } else { Duration::ZERO }
    }

    fn hear(&mut self, line: &str) -> serde_json::Result<Option<GuardianLine>> {
        let now = self.now();
        match serde_json::from_str(line)? {
            HostLine::Hello { version, .. } if version != VERSION => {
                let why = format!("it is of version {VERSION}, and the host of {version}");
                return Ok(Some(GuardianLine::Declined { why }));
            }
            HostLine::Hello { port, .. } => return Ok(Some(self.greet(now, port))),
            HostLine::Message { bytes, handed_over } => self.play(now, &bytes, handed_over),
            HostLine::Beat => {
                let heard = self.open.as_mut().map(|open| open.notes.hear(now));
                self.note(heard);
                return Ok(Some(GuardianLine::Beat(self.passed_on.clone())));
            }
            HostLine::Finish => {
                self.leave();
                self.open = None;
                self.is_finished = true;
                let after_us = (!self.after.is_empty()).then(|| Quantiles::of(&self.after));
                let passed_on = self.passed_on.clone();
                return Ok(Some(GuardianLine::Finished { passed_on, after_us }));
            }
        }
        Ok(None)
    }

    fn greet(&mut self, now: f64, port: GuardedPort) -> GuardianLine {
        self.passed_on = PassedOn::default();
        self.after.reset();
        if let Err(why) = self.open(port) {
            let (is_missing, why) = (is_missing(&why), why.to_string());
            let refused = GuardianLine::Refused { why: why.clone() };
            return if is_missing { GuardianLine::Missing { why } } else { refused };
        }
        let begun = self.open.as_mut().map(|open| open.notes.begin(now));
        self.note(begun);
        GuardianLine::Opened {}
    }

    fn open(&mut self, port: GuardedPort) -> Result<(), Unavailable> {
        if self.open.as_ref().is_some_and(|open| open.port == port) {
            return Ok(());
        }
        // The old one first: a device may be open only once.
        self.open = None;
        let (output, trouble) = port.open()?;
        self.passed_on.trouble = trouble;
        self.open = Some(OpenPort { port, notes: NoteGuardian::new(output) });
        Ok(())
    }

    fn play(&mut self, now: f64, bytes: &[u8], handed_over: u64) {
        let (Some(open), Ok(message)) = (&mut self.open, Message::decode(bytes)) else { return };
        let played = open.notes.play(now, message);
        self.after.saturating_record(clock::monotonic().as_u64().saturating_sub(handed_over));
        self.note(Some(played));
    }

    fn poll(&mut self) {
        let now = self.now();
        let Some(open) = &mut self.open else { return };
        let polled = open.notes.poll(now);
        self.passed_on.n_interruptions = open.notes.n_interruptions();
        if let Err(away) = polled {
            // Polling loses no message.
            self.passed_on.trouble.get_or_insert_with(|| away.to_string());
        }
    }

    fn leave(&mut self) {
        let now = self.now();
        let left = self.open.as_mut().map(|open| open.notes.leave(now));
        self.note(left);
    }

    fn note(&mut self, result: Option<Result<(), MidiSendError>>) {
        if let Some(Err(error)) = result {
            self.passed_on.n_lost += 1;
            self.passed_on.trouble.get_or_insert_with(|| error.to_string());
        }
    }

    fn close(&mut self, path: &Path) {
        self.leave();
        self.open = None;
        if place::owner(path) == Some(place::user()) {
            let _gone = std::fs::remove_file(path);
        }
    }
}

/// Returns the next line of the host; `None` when it is gone. Never returns without a host.
async fn next_line(host: &mut Option<ConnectedHost>) -> Option<String> {
    match host {
        Some(host) => host.lines.next_line().await.ok().flatten(),
        None => std::future::pending().await,
    }
}

/// Accepts a host of this user if there is none, else declines it.
fn admit(stream: UnixStream, host: &mut Option<ConnectedHost>) {
    let is_ours = stream.peer_cred().is_ok_and(|peer| peer.uid() == place::user());
    if !is_ours {
        return;
    }
    let newcomer = ConnectedHost::new(stream);
    if host.is_some() {
        newcomer.say(&GuardianLine::Declined { why: "it serves another host".to_owned() });
    } else {
        *host = Some(newcomer);
    }
}
