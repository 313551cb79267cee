//! The emergency stop: requests set it, the thread that drives the boards executes and answers it.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

use telemetry::{Reply, Request};
use tokio::sync::Notify;

use super::{Answer, Answers};

/// The number of armed boards that were sent the command to render no force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BoardsTold {
    pub told: usize,
    pub boards: usize,
}

impl BoardsTold {
    pub const NONE_ARMED: Self = Self { told: 0, boards: 0 };

    pub fn reply(self) -> Reply {
        let Self { told, boards } = self;
        let [n_told, n_boards] = self.counts();
        let text = if boards == 0 {
            "stopped before any board was armed: nothing will play".to_owned()
        } else if told == boards {
            format!(
                "stopped: {told} of {boards} boards were told, and none renders a force until it \
                 is started anew"
            )
        } else {
            format!(
                "stopped, but only {told} of {boards} boards could be told: cut the power of the \
                 others, or see that their watchdogs have taken their forces away"
            )
        };
        Reply::Stopped { text, told: n_told, boards: n_boards }
    }

    pub(super) fn counts(self) -> [u32; 2] {
        [self.told, self.boards].map(|n| u32::try_from(n).unwrap_or(u32::MAX))
    }
}

/// One stop, from the first request to the answer.
#[derive(Debug, Default)]
pub struct EmergencyStop {
    is_asked: AtomicBool,
    asks: Notify,
    /// `true` while boards are armed; the arming thread checks `is_asked` afterwards.
    is_arming: AtomicBool,
    told: Mutex<Option<BoardsTold>>,
    is_told: Condvar,
}

impl EmergencyStop {
    pub fn ask(&self) {
        self.is_asked.store(true, Ordering::Release);
        self.asks.notify_one();
    }

    /// Returns `true` if the stop was requested.
    ///
    /// # Real-time
    /// One load.
    pub fn is_asked(&self) -> bool {
        self.is_asked.load(Ordering::Acquire)
    }

    pub async fn asked(&self) {
        while !self.is_asked() {
            self.asks.notified().await;
        }
    }

    /// Arms boards by `arm`, which may take seconds; delays the answers to stops until it is done.
    pub fn while_arming<T>(&self, arm: impl FnOnce() -> T) -> T {
        self.is_arming.store(true, Ordering::Release);
        let armed = arm();
        self.is_arming.store(false, Ordering::Release);
        armed
    }

    pub fn answer(&self, told: BoardsTold) {
        *self.told.lock().unwrap_or_else(PoisonError::into_inner) = Some(told);
        self.is_told.notify_all();
    }

    pub fn answered(&self) -> Option<BoardsTold> {
        *self.told.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Requests the stop and waits for the answer: 1 s, or until boards are armed.
    ///
    /// # Errors
    /// A sentence if the answer is late.
    pub fn ask_and_wait(&self) -> Result<Reply, String> {
        /// Longest wait for the tick to see the request.
        const PATIENCE: Duration = Duration::from_secs(1);
        /// Longest further wait for boards that are being armed.
        const ARMING: Duration = Duration::from_millis(3_500);
        self.ask();
        let mut told = self.wait(PATIENCE);
        if told.is_none() && self.is_arming.load(Ordering::Acquire) {
            told = self.wait(ARMING);
        }
        let told = told.map(BoardsTold::reply);
        told.ok_or_else(|| {
            "the host has not told its boards to stop in time: cut their power".into()
        })
    }

    fn wait(&self, patience: Duration) -> Option<BoardsTold> {
        let told = self.told.lock().unwrap_or_else(PoisonError::into_inner);
        let waited = self.is_told.wait_timeout_while(told, patience, |told| told.is_none());
        *waited.unwrap_or_else(PoisonError::into_inner).0
    }
}

/// While keys are calibrated, a stop is the only request that is answered.
impl Answers for EmergencyStop {
    fn reply_to(&self, request: &Request, _connection: u64) -> Answer {
        if matches!(request, Request::Stop {}) {
            return self.ask_and_wait();
        }
        Err("keys are being calibrated here: only `letoff stop` is heard".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_answer_says_how_many_boards_were_told_and_what_to_do_about_the_others() {
        let text = |told, boards| {
            let reply = BoardsTold { told, boards }.reply();
            let Reply::Stopped { text, .. } = reply else { unreachable!("{reply:?}") };
            text
        };
        assert!(text(8, 8).contains("8 of 8 boards were told"));
        assert!(text(6, 8).contains("only 6 of 8") && text(6, 8).contains("cut the power"));
        assert!(text(0, 0).contains("before any board was armed"));
    }

    #[test]
    fn whoever_asks_gets_the_answer_that_came_before() {
        let stop = EmergencyStop::default();
        assert!(!stop.is_asked() && stop.answered().is_none());
        stop.answer(BoardsTold { told: 1, boards: 1 });
        assert!(stop.ask_and_wait().is_ok() && stop.is_asked());
    }
}
