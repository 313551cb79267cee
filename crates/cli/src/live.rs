//! Progress of what takes long: the rehearsal, a run, keys that are measured.
//!
//! Drawn on stderr, and only when a person sees it: a pipe gets the report alone.

use std::sync::atomic::Ordering::Relaxed;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use host::adapters::observer::LiveCounters;
use host::session::PianistProgress;

/// Time between two updates of the line.
pub(super) const REFRESH: Duration = Duration::from_millis(200);

/// The rehearsal of a performance.
#[derive(Clone, Debug)]
pub(super) struct RehearsalProgress(ProgressBar);

impl RehearsalProgress {
    pub(super) fn new() -> Self {
        let bar = ProgressBar::new(0).with_message("rehearsing");
        Self(bar.with_style(style("{msg:12} {wide_bar} {pos}/{len} strokes {eta}")))
    }

    pub(super) fn show(&self, progress: PianistProgress) {
        self.0.set_length(progress.total as u64);
        self.0.set_position(progress.done as u64);
    }

    pub(super) fn finish(&self) {
        self.0.finish_and_clear();
    }
}

/// One line about a running host.
#[derive(Debug)]
pub(super) struct StatusLine {
    bar: ProgressBar,
    tick_hz: f64,
}

impl StatusLine {
    /// Returns the line of a run of `ticks` at `tick_hz`; without an end it shows no bar.
    pub(super) fn new(tick_hz: u32, ticks: Option<u64>) -> Self {
        let bar = ticks.map_or_else(ProgressBar::no_length, ProgressBar::new);
        let template = if ticks.is_some() { "{wide_bar} {msg}" } else { "{spinner} {msg}" };
        Self { bar: bar.with_style(style(template)), tick_hz: f64::from(tick_hz) }
    }

    /// Shows time, active keys, tick load, misses and notes.
    pub(super) fn show(&self, counters: &LiveCounters) {
        let ticks = counters.ticks.load(Relaxed);
        let load = counters.work_ns.load(Relaxed) as f64 * self.tick_hz * 1e-7;
        self.bar.set_position(ticks);
        self.bar.set_message(format!(
            "{:6.1} s  {:2} keys active  load {load:4.1} %  {} missed  {} notes",
            ticks as f64 / self.tick_hz,
            counters.active.load(Relaxed),
            counters.missed.load(Relaxed),
            counters.strikes.load(Relaxed),
        ));
    }

    pub(super) fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// Returns the line as a progress bar.
    pub(super) fn bar(&self) -> ProgressBar {
        self.bar.clone()
    }
}

/// Returns a bar for `n` keys that are measured one after the other.
pub(super) fn keys(n: usize) -> ProgressBar {
    ProgressBar::new(n as u64).with_style(style("{msg:34} {wide_bar} {pos}/{len} keys {eta}"))
}

/// Returns the style of `template`; the plain bar, if the template were wrong.
fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_broken| ProgressStyle::default_bar())
}
