//! The host's log: lines on stderr, written by a separate thread.
//!
//! A person reads `letoff: TEXT`, journald a level before each line, and programs JSON.

use std::io::{self, Write as _};
use std::os::fd::AsFd as _;
use std::sync::OnceLock;
use std::sync::mpsc::{self, Receiver, SyncSender, TrySendError};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use indicatif::ProgressBar;
use rustix::fs::fstat;
use telemetry::log::Level;
use telemetry::stream::Publisher;
use telemetry::{Log, Update};
use time::OffsetDateTime;

use super::about;

/// Format of the log's lines.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LogFormat {
    Plain,
    /// Level before each line, for journald.
    Journal,
    Json,
}

static FORMAT: OnceLock<LogFormat> = OnceLock::new();

impl LogFormat {
    /// Chooses the format of this process, unless it has written already.
    pub(super) fn choose(self) {
        let _first = FORMAT.set(self);
    }

    /// Returns the format: journald's if that reads stderr.
    fn chosen() -> Self {
        *FORMAT.get_or_init(|| {
            let stream = std::env::var("JOURNAL_STREAM").ok();
            let stderr = fstat(io::stderr().as_fd()).ok();
            let own = stderr.map(|it| format!("{}:{}", it.st_dev, it.st_ino));
            if stream.is_some() && stream == own { Self::Journal } else { Self::Plain }
        })
    }

    /// Formats `text`, without the last line's end.
    fn written(self, level: Level, text: &str) -> String {
        match self {
            Self::Plain => format!("letoff: {text}"),
            Self::Journal => {
                let priority = match level {
                    Level::Error => 3,
                    Level::Warning => 4,
                    Level::Info => 6,
                };
                let lines: Vec<_> =
                    text.lines().map(|line| format!("<{priority}>{line}")).collect();
                lines.join("\n")
            }
            Self::Json => {
                let level = match level {
                    Level::Error => "error",
                    Level::Warning => "warning",
                    Level::Info => "info",
                };
                let time = about::utc(OffsetDateTime::now_utc());
                serde_json::json!({ "time": time, "level": level, "text": text }).to_string()
            }
        }
    }
}

pub(super) fn tell_as(level: Level, text: &str) {
    let _unheard = writeln!(io::stderr(), "{}", LogFormat::chosen().written(level, text));
}

/// Maximum lines that wait for a slow terminal or journal; more are dropped and counted.
const WAITING: usize = 256;

/// Writes lines until it is dropped.
///
/// A pipe without a reader blocks this thread, never the one that waits for signals.
#[derive(Debug)]
pub(super) struct StderrLog {
    lines: Option<SyncSender<(Level, String)>>,
    shared: Arc<LogState>,
    /// Closed after the last line.
    written: Receiver<()>,
}

#[derive(Clone, Debug)]
pub(super) struct LogLines {
    lines: Option<SyncSender<(Level, String)>>,
    shared: Arc<LogState>,
}

#[derive(Debug, Default)]
struct LogState {
    bar: Mutex<Option<ProgressBar>>,
    /// Stream that carries the lines too.
    stream: OnceLock<Publisher>,
    left_out: std::sync::atomic::AtomicU64,
}

impl StderrLog {
    pub(super) fn quiet() -> Self {
        Self { lines: None, shared: Arc::default(), written: mpsc::channel().1 }
    }

    /// Starts the writing thread.
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

    /// Returns a sender of lines for any thread.
    pub(super) fn lines(&self) -> LogLines {
        LogLines { lines: self.lines.clone(), shared: Arc::clone(&self.shared) }
    }

    /// Draws `bar` below the lines from now on.
    pub(super) fn draw_above(&self, bar: ProgressBar) {
        *self.shared.bar.lock().unwrap_or_else(PoisonError::into_inner) = Some(bar);
    }

    pub(super) fn say(&self, text: String) {
        self.lines().say(Level::Info, text);
    }

    /// Returns a sender that publishes lines and does not keep the log open.
    pub(super) fn publisher(&self) -> LogLines {
        LogLines { lines: None, shared: Arc::clone(&self.shared) }
    }

    /// Publishes all later lines on a stream too.
    pub(super) fn stream_to(&self, publisher: Publisher) {
        let _first = self.shared.stream.set(publisher);
    }
}

impl LogLines {
    fn publish(&self, level: Level, text: &str) {
        if let Some(stream) = self.shared.stream.get() {
            let at = OffsetDateTime::now_utc().unix_timestamp_nanos();
            let entry = Log { level: level.into(), text: text.to_owned() };
            stream.publish(u64::try_from(at).unwrap_or(0), &Update::Log(entry));
        }
    }

    /// Publishes and sends a line; never waits.
    pub(super) fn say(&self, level: Level, text: String) {
        use std::sync::atomic::Ordering::Relaxed;
        self.publish(level, &text);
        let Some(lines) = &self.lines else { return };
        if let Err(TrySendError::Full(_)) = lines.try_send((level, text)) {
            self.shared.left_out.fetch_add(1, Relaxed);
        }
    }
}

impl Drop for StderrLog {
    /// Waits until all lines are written, for a limited time if stderr has no reader.
    fn drop(&mut self) {
        /// Upper bound of a terminal's time.
        const GRACE: Duration = Duration::from_millis(500);
        self.lines = None;
        let _closed = self.written.recv_timeout(GRACE);
    }
}

fn write(lines: &Receiver<(Level, String)>, shared: &LogState) {
    use std::sync::atomic::Ordering::Relaxed;
    for (level, line) in lines {
        let left_out = shared.left_out.swap(0, Relaxed);
        let bar = shared.bar.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let say = || {
            tell_as(level, &line);
            if 0 < left_out {
                let text = format!("{left_out} lines were left out of this log: nobody took them");
                tell_as(Level::Warning, &text);
            }
        };
        match bar.filter(|bar| !bar.is_finished()) {
            Some(bar) => bar.suspend(say),
            None => say(),
        }
    }
    let _flushed = io::stderr().flush();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_json_is_one_line_whatever_stands_in_it() {
        let written = LogFormat::Json.written(Level::Info, "a \"b\"\nc");
        let read: serde_json::Value = serde_json::from_str(&written).expect("JSON");
        assert_eq!((&read["level"], &read["text"]), (&"info".into(), &"a \"b\"\nc".into()));
        assert_eq!(written.lines().count(), 1);
    }
}
