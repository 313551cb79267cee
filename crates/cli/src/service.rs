//! Messages to a service manager: readiness, a status line, and a watchdog for timely ticks.

use std::pin::pin;
use std::sync::Arc;
use std::time::{Duration, Instant};

use host::control::RunHandle;
use sd_notify::{NotifyState, notify, watchdog_enabled};
use telemetry::HostState;

/// Interval between checks for changes.
const LOOK: Duration = Duration::from_secs(1);

/// Maximum time of a rehearsal without progress before a start counts as failed (us).
const REHEARSAL_US: u32 = 60_000_000;

/// Notifies the service manager that started this process, if any. Off the tick: the main thread
/// calls it between two checks of its counters.
#[derive(Debug)]
pub(super) struct ServiceNotifier {
    handle: Arc<RunHandle>,
    tick_watch: TickWatch,
    /// Interval of watchdog messages, if requested.
    feeding: Option<Duration>,
    fed: Instant,
    looked: Option<Instant>,
    line: String,
    is_ready: bool,
}

impl ServiceNotifier {
    pub(super) fn new(handle: Arc<RunHandle>) -> Self {
        // Three messages in the allowed time: one busy moment does not end the service.
        let feeding = watchdog_enabled().map(|longest| longest / 3);
        Self {
            handle,
            tick_watch: TickWatch::default(),
            feeding,
            fed: Instant::now(),
            looked: None,
            line: String::new(),
            is_ready: false,
        }
    }

    pub(super) async fn beside<T>(&mut self, work: impl Future<Output = T>) -> T {
        let mut work = pin!(work);
        let mut looks = tokio::time::interval(LOOK);
        loop {
            tokio::select! {
                done = &mut work => return done,
                _now = looks.tick() => self.attend(Instant::now(), 0, 0),
            }
        }
    }

    /// Reports changes at `now`; `missed` counts ticks that were late or never run.
    pub(super) fn attend(&mut self, now: Instant, ticks: u64, missed: u64) {
        if !self.is_ready && 0 < ticks {
            self.is_ready = true;
            self.tick_watch.look(ticks, missed);
            (self.fed, self.looked) = (now, None);
            say(&[NotifyState::Ready]);
        }
        if self.looked.is_none_or(|looked| LOOK <= now - looked) {
            self.looked = Some(now);
            self.tell_status();
        }
        if self.is_ready && self.feeding.is_some_and(|feeding| feeding <= now - self.fed) {
            self.fed = now;
            if self.tick_watch.look(ticks, missed) {
                say(&[NotifyState::Watchdog]);
            }
        }
    }

    fn tell_status(&mut self) {
        let status = self.handle.status.read();
        let line = status.line();
        if line == self.line {
            return;
        }
        say(&[NotifyState::Status(&line)]);
        if status.state == HostState::Rehearsing {
            // A long piece is no failed start.
            say(&[NotifyState::ExtendTimeoutUsec(REHEARSAL_US)]);
        }
        self.line = line;
    }
}

pub(super) fn stopping() {
    say(&[NotifyState::Stopping, NotifyState::Status("forces fade, notes end")]);
}

pub(super) fn reloading() {
    if let Ok(now) = NotifyState::monotonic_usec_now() {
        say(&[NotifyState::Reloading, now]);
    }
}

pub(super) fn reloaded(text: &str) {
    let line = text.lines().next().unwrap_or_default();
    say(&[NotifyState::Ready, NotifyState::Status(line)]);
}

fn say(states: &[NotifyState<'_>]) {
    let _unheard = notify(states);
}

#[derive(Debug, Default)]
struct TickWatch {
    ticks: u64,
    missed: u64,
}

/// Allowed share of late or missed ticks: one in this many.
const MISSED_ONE_IN: u64 = 10;

impl TickWatch {
    /// Returns `true` if ticks advanced since the last check, and at most one in ten was missed.
    const fn look(&mut self, ticks: u64, missed: u64) -> bool {
        let passed = ticks.saturating_sub(self.ticks);
        let late = missed.saturating_sub(self.missed);
        (self.ticks, self.missed) = (ticks, missed);
        0 < passed && late.saturating_mul(MISSED_ONE_IN) <= passed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_that_go_on_in_time_are_a_sign_of_life() {
        let mut watch = TickWatch::default();
        assert!(!watch.look(0, 0), "no tick yet");
        assert!(watch.look(1000, 0));
        assert!(watch.look(2000, 100), "one in ten");
        assert!(!watch.look(3000, 201), "more than one in ten");
        assert!(watch.look(4000, 201), "each look is about its own time");
    }

    #[test]
    fn ticks_that_stand_still_are_none() {
        let mut watch = TickWatch::default();
        assert!(watch.look(1000, 0));
        assert!(!watch.look(1000, 0));
        assert!(!watch.look(1000, 0));
    }
}
