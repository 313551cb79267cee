//! Signals, for commands that run until they are stopped.

use host::control::{BoardsTold, EmergencyStop};

use rustix::process::Signal;

use super::Failure;

/// The signals that end a run well: all notes off, forces down, then the report.
pub(super) struct Signals {
    interrupt: tokio::signal::unix::Signal,
    terminate: tokio::signal::unix::Signal,
    hang_up: tokio::signal::unix::Signal,
    /// A file has become larger than `RLIMIT_FSIZE` allows, which would end the process if nobody
    /// listened: who writes the file is told so by its error.
    _file_too_large: tokio::signal::unix::Signal,
}

impl Signals {
    /// Listens from now on.
    pub(super) fn new() -> std::io::Result<Self> {
        use tokio::signal::unix::{SignalKind, signal};
        Ok(Self {
            interrupt: signal(SignalKind::interrupt())?,
            terminate: signal(SignalKind::terminate())?,
            hang_up: signal(SignalKind::hangup())?,
            _file_too_large: signal(SignalKind::from_raw(Signal::XFSZ.as_raw()))?,
        })
    }

    /// Waits for the next of `looks`; says whether a signal came first.
    pub(super) async fn come_before(&mut self, looks: &mut tokio::time::Interval) -> bool {
        tokio::select! {
            biased;
            () = self.next() => true,
            _now = looks.tick() => false,
        }
    }

    /// Does `work`, which arms no board, on a thread of its own; nothing comes of it if an
    /// emergency stop, which is answered here, or a signal comes before it is done.
    ///
    /// # Errors
    /// If `work` panicked.
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

    /// Waits for the next signal.
    pub(super) async fn next(&mut self) {
        tokio::select! {
            _ = self.interrupt.recv() => {}
            _ = self.terminate.recv() => {}
            _ = self.hang_up.recv() => {}
        }
    }
}
