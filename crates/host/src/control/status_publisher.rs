//! The host's status on the stream, from before its first tick until after its last.

use std::{io, sync::Arc, time::Duration};

use telemetry::{Status, Update, status, stream::Publisher};

use super::{RepeatedLook, RequestHandler, RunHandle, run_status::nanos_now};

const INTERVAL: Duration = Duration::from_millis(100);

/// Checks after which an unchanged status is sent again: 1 s.
const UNCHANGED: u32 = 10;

/// Checks without a tick after which a playing host counts as hanging: 0.3 s.
const STALLED: u32 = 3;

/// Publishes each change of the status, and the status once a second.
#[derive(Debug)]
pub struct StatusPublisher {
    run: Arc<RunHandle>,
    publisher: Publisher,
    _checks: RepeatedLook,
}

#[derive(Default)]
struct StatusWatch {
    last: Option<Status>,
    unchanged: u32,
    ticks: u64,
    without_tick: u32,
}

impl StatusPublisher {
    pub fn start(requests: &RequestHandler, publisher: Publisher) -> io::Result<Self> {
        let (run, its_publisher) = (Arc::clone(&requests.run), publisher.clone());
        let mut watch = StatusWatch::default();
        let check = move || {
            if let Some(status) = watch.check(&run) {
                publish(&its_publisher, status);
            }
        };
        let checks = RepeatedLook::start("letoff-status", INTERVAL, check)?;
        Ok(Self { run: Arc::clone(&requests.run), publisher, _checks: checks })
    }

    /// Publishes the last status, and waits until it is in the clients' queues.
    pub async fn finish(self) {
        publish(&self.publisher, self.run.status.message());
        self.publisher.flush().await;
    }
}

impl StatusWatch {
    fn check(&mut self, run: &RunHandle) -> Option<Status> {
        let mut now = run.status.message();
        let ticks = run.status.read().run.deadlines.ticks;
        self.without_tick = if ticks == self.ticks { self.without_tick + 1 } else { 0 };
        self.ticks = ticks;
        if now.state() == status::State::Playing && STALLED <= self.without_tick {
            now.set_state(status::State::Stalled);
        }
        self.unchanged += 1;
        if self.last.as_ref() == Some(&now) && self.unchanged < UNCHANGED {
            return None;
        }
        self.unchanged = 0;
        self.last = Some(now.clone());
        Some(now)
    }
}

fn publish(publisher: &Publisher, status: Status) {
    publisher.publish(nanos_now(), &Update::Status(status));
}
