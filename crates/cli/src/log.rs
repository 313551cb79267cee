//! The host's log: plain lines on stderr, written by a thread of its own.

use std::io::{self, Write as _};
use std::sync::mpsc::{self, Receiver, SyncSender, TrySendError};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use indicatif::ProgressBar;

use super::tell;

/// Lines that may wait for a terminal or a journal that is slow; more are left out and counted.
const WAITING: usize = 256;

/// Writes lines until it is dropped.
///
/// A pipe without a reader blocks the thread that writes into it: that is this one, and never the
/// one that waits for signals.
#[derive(Debug)]
pub(super) struct StderrLog {
    lines: Option<SyncSender<String>>,
    shared: Arc<LogState>,
    /// Closed when all is written.
    written: Receiver<()>,
}

/// Hands lines to the log.
#[derive(Clone, Debug)]
pub(super) struct LogLines {
    lines: Option<SyncSender<String>>,
    shared: Arc<LogState>,
}

#[derive(Debug, Default)]
struct LogState {
    /// The bar that is drawn at the end of the terminal.
    bar: Mutex<Option<ProgressBar>>,
    left_out: std::sync::atomic::AtomicU64,
}

impl StderrLog {
    /// Returns a log that writes nothing.
    pub(super) fn quiet() -> Self {
        Self { lines: None, shared: Arc::default(), written: mpsc::channel().1 }
    }

    /// Begins to write.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(super) fn start() -> io::Result<Self> {
        let shared = Arc::new(LogState::default());
        let (ended, written) = mpsc::channel();
        let (lines, to_write) = mpsc::sync_channel(WAITING);
        let its = Arc::clone(&shared);
        std::thread::Builder::new().name("letoff-log".into()).spawn(move || {
            write(&to_write, &its);
            drop(ended);
        })?;
        Ok(Self { lines: Some(lines), shared, written })
    }

    /// Returns a way to hand it lines from any thread.
    pub(super) fn lines(&self) -> LogLines {
        LogLines { lines: self.lines.clone(), shared: Arc::clone(&self.shared) }
    }

    /// Draws `bar` below the lines from now on.
    pub(super) fn draw_above(&self, bar: ProgressBar) {
        *self.shared.bar.lock().unwrap_or_else(PoisonError::into_inner) = Some(bar);
    }

    /// Writes a line without waiting for the terminal.
    pub(super) fn say(&self, text: String) {
        self.lines().say(text);
    }
}

impl LogLines {
    /// Hands over a line; never waits.
    pub(super) fn say(&self, text: String) {
        use std::sync::atomic::Ordering::Relaxed;
        let Some(lines) = &self.lines else { return };
        if let Err(TrySendError::Full(_)) = lines.try_send(text) {
            self.shared.left_out.fetch_add(1, Relaxed);
        }
    }
}

impl Drop for StderrLog {
    /// Waits until all lines are written, for a limited time if stderr has no reader.
    fn drop(&mut self) {
        /// Longer than a terminal takes.
        const GRACE: Duration = Duration::from_millis(500);
        self.lines = None;
        let _closed = self.written.recv_timeout(GRACE);
    }
}

fn write(lines: &Receiver<String>, shared: &LogState) {
    use std::sync::atomic::Ordering::Relaxed;
    for line in lines {
        let left_out = shared.left_out.swap(0, Relaxed);
        let bar = shared.bar.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let say = || {
            tell(&line);
            if 0 < left_out {
                tell(&format!("{left_out} lines were left out of this log: nobody took them"));
            }
        };
        match bar.filter(|bar| !bar.is_finished()) {
            Some(bar) => bar.suspend(say),
            None => say(),
        }
    }
    let _flushed = io::stderr().flush();
}
