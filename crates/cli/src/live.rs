//! Progress of long work: the rehearsal, a run, the measurement of keys.
//!
//! Drawn on stderr at a terminal. Other readers get the report, a line every few seconds of a
//! rehearsal, and one for each measured key.

use std::sync::Arc;
use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use telemetry::log::Level;

use super::log::LogLines;
use super::tell;
use host::adapters::observer::LiveCounters;
use host::session::{PianistProgress, RunSession};

/// Interval of updates of the line.
pub(super) const REFRESH: Duration = Duration::from_millis(200);

/// Interval of lines about a rehearsal without a terminal.
const LINE_EVERY: Duration = Duration::from_secs(3);

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ProgressLines {
    Told,
    Quiet,
}

#[derive(Clone, Debug)]
pub(super) struct RehearsalProgress {
    bar: ProgressBar,
    lines: ProgressLines,
    log: LogLines,
    n_lines: Arc<AtomicU64>,
}

impl RehearsalProgress {
    pub(super) fn new(lines: ProgressLines, log: LogLines) -> Self {
        let bar = ProgressBar::new(0).with_message("rehearsing");
        let bar = bar.with_style(style("{msg:12} {wide_bar} {pos}/{len} strokes {eta}"));
        Self { bar, lines, log, n_lines: Arc::default() }
    }

    pub(super) fn show(&self, progress: PianistProgress) {
        let PianistProgress { done, total } = progress;
        self.bar.set_length(total as u64);
        self.bar.set_position(done as u64);
        if self.is_line_due() {
            let text = format!("rehearsed {done} of {total} notes");
            self.log.say(Level::Info, text.clone());
            if self.bar.is_hidden() && self.lines == ProgressLines::Told {
                tell(&text);
            }
        }
    }

    /// Returns `true` to one thread when the next line is due.
    fn is_line_due(&self) -> bool {
        let told = self.n_lines.load(Relaxed);
        let due = LINE_EVERY.as_secs() * (told + 1) <= self.bar.elapsed().as_secs();
        due && self.n_lines.compare_exchange(told, told + 1, Relaxed, Relaxed).is_ok()
    }

    pub(super) fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

#[derive(Debug)]
pub(super) struct StatusLine {
    bar: ProgressBar,
    tick_hz: f64,
    /// Ticks of a pass of a repeated play list.
    pass: Option<u64>,
}

impl StatusLine {
    /// Returns the line of a run; without an end it has no bar.
    pub(super) fn new(session: &RunSession) -> Self {
        let ticks = session.plan().ticks;
        let bar = ticks.map_or_else(ProgressBar::no_length, ProgressBar::new);
        let template = if ticks.is_some() { "{wide_bar} {msg}" } else { "{spinner} {msg}" };
        let tick_hz = f64::from(session.plan().tick_hz);
        Self { bar: bar.with_style(style(template)), tick_hz, pass: session.pass() }
    }

    /// Shows time, active keys, tick load, misses, notes, and the pass of a repeated list.
    pub(super) fn show(&self, counters: &LiveCounters) {
        let ticks = counters.ticks.load(Relaxed);
        let load = counters.work_ns.load(Relaxed) as f64 * self.tick_hz * 1e-7;
        self.bar.set_position(ticks);
        let pass =
            self.pass.map_or_else(String::new, |pass| format!("  pass {}", 1 + ticks / pass));
        self.bar.set_message(format!(
            "{:6.1} s  {:2} keys active  load {load:4.1} %  {} missed  {} notes{pass}",
            ticks as f64 / self.tick_hz,
            counters.active.load(Relaxed),
            counters.missed.load(Relaxed),
            counters.strikes.load(Relaxed),
        ));
    }

    pub(super) fn finish(&self) {
        self.bar.finish_and_clear();
    }

    pub(super) fn bar(&self) -> ProgressBar {
        self.bar.clone()
    }
}

#[derive(Debug)]
pub(super) struct KeyProgress(ProgressBar);

impl KeyProgress {
    pub(super) fn new(n: usize) -> Self {
        let style = style("{msg:34} {wide_bar} {pos}/{len} keys {eta}");
        Self(ProgressBar::new(n as u64).with_style(style))
    }

    /// Shows the present key; without a terminal, in its own line.
    pub(super) fn show(&self, what: &str) {
        self.0.set_message(what.to_owned());
        if self.0.is_hidden() {
            let (done, all) = (self.0.position(), self.0.length().unwrap_or_default());
            tell(&format!("measuring {what}, {done} of {all} keys done"));
        }
    }

    pub(super) fn next(&self) {
        self.0.inc(1);
    }

    pub(super) fn finish(&self) {
        self.0.finish_and_clear();
    }

    /// Returns the bar, which is hidden during a question.
    pub(super) const fn bar(&self) -> &ProgressBar {
        &self.0
    }
}

/// Returns the style of `template`, or the plain bar if the template is invalid.
fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_broken| ProgressStyle::default_bar())
}
