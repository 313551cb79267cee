use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use host::adapters::observer::LiveCounters;
use telemetry::HostState;
use tokio::task::JoinHandle;

use super::endpoints::Endpoints;
use super::live::{REFRESH, StatusLine};
use super::log::StderrLog;
use super::reload::SceneFile;
use super::service::{self, ServiceNotifier};
use super::signals::{RunSignal, Signals};
use host::control::RunHandle;

/// Duties of the main thread during a run.
pub(super) struct RunAttendant<'a> {
    pub(super) signals: Signals,
    pub(super) notifier: ServiceNotifier,
    pub(super) handle: Arc<RunHandle>,
    pub(super) endpoints: &'a Endpoints,
    pub(super) log: &'a StderrLog,
    pub(super) counters: Arc<LiveCounters>,
    pub(super) line: StatusLine,
    /// Lines for the log, after the first tick.
    pub(super) news: Vec<String>,
    pub(super) stop: Arc<AtomicBool>,
    pub(super) file: Option<SceneFile>,
    /// `true` if the file must be read again as soon as the run can be changed.
    pub(super) is_reload_due: bool,
}

impl RunAttendant<'_> {
    pub(super) async fn until_over<T>(
        &mut self,
        mut running: JoinHandle<T>,
    ) -> Result<T, tokio::task::JoinError> {
        let mut every = tokio::time::interval(REFRESH);
        loop {
            tokio::select! {
                done = &mut running => {
                    self.line.finish();
                    service::stopping();
                    return done;
                }
                signal = self.signals.next_of_run() => match signal {
                    RunSignal::End => self.end(),
                    RunSignal::Reload => self.is_reload_due = true,
                },
                _ = every.tick() => self.look(),
            }
        }
    }

    fn end(&self) {
        self.stop.store(true, Ordering::Release);
        self.handle.status.enter(HostState::Ending);
        service::stopping();
        self.log.say("a signal ends the run: forces fade, notes end".to_owned());
    }

    fn reload(&self) {
        if let (Some(file), Some(requests)) = (&self.file, self.endpoints.requests()) {
            tokio::spawn(file.clone().reload(requests, self.log.lines()));
        }
    }

    fn look(&mut self) {
        self.line.show(&self.counters);
        let count = |counter: &std::sync::atomic::AtomicU64| counter.load(Ordering::Relaxed);
        let (ticks, missed) = (count(&self.counters.ticks), count(&self.counters.missed));
        if 0 < ticks {
            self.news.drain(..).for_each(|text| self.log.say(text));
            if std::mem::take(&mut self.is_reload_due) {
                self.reload();
            }
        }
        self.notifier.attend(Instant::now(), ticks, missed);
    }
}
