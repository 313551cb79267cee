use std::io;
use std::os::unix::net::UnixStream;

use host::control::{BoardsTold, EmergencyStop};

use rustix::process::Signal;
use tokio::runtime::Runtime;

use super::{Failure, system};

/// Meaning of a hang-up (SIGHUP).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum HangUp {
    /// End, as when a terminal is closed.
    Ends,
    Reloads,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum RunSignal {
    End,
    Reload,
}

/// Signals that end a run in order: all notes off, forces down, then the report.
pub(super) struct Signals {
    hang_up_means: HangUp,
    interrupt: tokio::signal::unix::Signal,
    terminate: tokio::signal::unix::Signal,
    hang_up: tokio::signal::unix::Signal,
    /// A file exceeds `RLIMIT_FSIZE`. Without a listener the signal would end the process; the
    /// writer of the file gets an error.
    _file_too_large: tokio::signal::unix::Signal,
}

impl Signals {
    pub(super) fn new() -> io::Result<Self> {
        Self::with(HangUp::Ends)
    }

    /// Like [`Self::new`], with a meaning of a hang-up.
    pub(super) fn with(hang_up_means: HangUp) -> io::Result<Self> {
        use tokio::signal::unix::{SignalKind, signal};
        Ok(Self {
            hang_up_means,
            interrupt: signal(SignalKind::interrupt())?,
            terminate: signal(SignalKind::terminate())?,
            hang_up: signal(SignalKind::hangup())?,
            _file_too_large: signal(SignalKind::from_raw(Signal::XFSZ.as_raw()))?,
        })
    }

    /// Waits for the next of `looks`; returns `true` if a signal came first.
    pub(super) async fn come_before(&mut self, looks: &mut tokio::time::Interval) -> bool {
        tokio::select! {
            biased;
            () = self.next() => true,
            _now = looks.tick() => false,
        }
    }

    /// Does `work`, which arms no board, on its own thread; discards it if a signal or an emergency
    /// stop, which is answered here, comes first.
    pub(super) async fn unless_stopped<T: Send + 'static>(
        &mut self,
        emergency: &EmergencyStop,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Result<Option<T>, Failure> {
        let working = tokio::task::spawn_blocking(work);
        let done = tokio::select! {
            biased;
            () = emergency.asked() => None,
            () = self.next() => None,
            done = working => Some(done),
        };
        let Some(done) = done.filter(|_| !emergency.is_asked()) else {
            emergency.answer(BoardsTold::NONE_ARMED);
            return Ok(None);
        };
        done.map(Some).map_err(|panic| Failure::Running(panic.to_string()))
    }

    /// Waits for the next signal to end; a reload stays pending.
    pub(super) async fn next(&mut self) {
        tokio::select! {
            _ = self.interrupt.recv() => {}
            _ = self.terminate.recv() => {}
            _ = self.hang_up.recv(), if self.hang_up_means == HangUp::Ends => {}
        }
    }

    /// Waits for the next signal to a running host.
    pub(super) async fn next_of_run(&mut self) -> RunSignal {
        tokio::select! {
            _ = self.interrupt.recv() => RunSignal::End,
            _ = self.terminate.recv() => RunSignal::End,
            _ = self.hang_up.recv() => match self.hang_up_means {
                HangUp::Ends => RunSignal::End,
                HangUp::Reloads => RunSignal::Reload,
            },
        }
    }
}

/// Returns the runtime of a command that runs until it is stopped.
///
/// # Errors
/// If threads or descriptors are too few: the runtime would panic later.
pub(super) fn runtime() -> Result<Runtime, Failure> {
    check_limits().map_err(system)?;
    tokio::runtime::Builder::new_current_thread().enable_all().build().map_err(system)
}

/// Allocates once the descriptors and threads of a running command.
fn check_limits() -> io::Result<()> {
    /// Pairs of descriptors: a host with a stream and one client has 14.
    const PAIRS: usize = 8;
    /// Threads beside this one.
    const THREADS: usize = 4;
    let _pairs = (0..PAIRS).map(|_| UnixStream::pair()).collect::<io::Result<Vec<_>>>()?;
    // All exist at once: each waits until its lock is dropped.
    let mut threads = Vec::new();
    for _ in 0..THREADS {
        let (held, end) = std::sync::mpsc::channel::<()>();
        threads.push((held, std::thread::Builder::new().spawn(move || end.recv())?));
    }
    for (held, thread) in threads {
        drop(held);
        let _ended = thread.join();
    }
    Ok(())
}
