//! The emergency stop: requests ask for it; the thread that drives the boards does it and answers.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

use telemetry::{Reply, Request};
use tokio::sync::Notify;

use super::{Answer, Answers};

/// The number of armed boards that were sent the command to render no force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BoardsTold {
    /// Boards that took the command.
    pub told: usize,
    /// Boards that were armed.
    pub boards: usize,
}

impl BoardsTold {
    /// The answer before any board is armed.
    pub const NONE_ARMED: Self = Self { told: 0, boards: 0 };

    /// Returns the reply to a request for the stop.
    pub fn reply(self) -> Reply {
        let Self { told, boards } = self;
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
        let count = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        Reply::Stopped { text, told: count(told), boards: count(boards) }
    }
}

/// One stop, from the first request to the answer.
#[derive(Debug, Default)]
pub struct EmergencyStop {
    is_asked: AtomicBool,
    asks: Notify,
    /// Boards are being armed, and the thread that arms them looks at `is_asked` afterwards.
    is_arming: AtomicBool,
    told: Mutex<Option<BoardsTold>>,
    is_told: Condvar,
}

impl EmergencyStop {
    /// Asks for the stop; it is done with the next tick.
    pub fn ask(&self) {
        self.is_asked.store(true, Ordering::Release);
        self.asks.notify_one();
    }

    /// Returns whether it was asked for.
    ///
    /// # Real-time
    /// One load.
    pub fn is_asked(&self) -> bool {
        self.is_asked.load(Ordering::Acquire)
    }

    /// Waits until it is asked for.
    pub async fn asked(&self) {
        while !self.is_asked() {
            self.asks.notified().await;
        }
    }

    /// Arms boards by `arm`, which may take seconds; requests meanwhile are answered after it.
    pub fn while_arming<T>(&self, arm: impl FnOnce() -> T) -> T {
        self.is_arming.store(true, Ordering::Release);
        let armed = arm();
        self.is_arming.store(false, Ordering::Release);
        armed
    }

    /// Answers the requests with what the boards were told.
    pub fn answer(&self, told: BoardsTold) {
        *self.told.lock().unwrap_or_else(PoisonError::into_inner) = Some(told);
        self.is_told.notify_all();
    }

    /// Returns the answer, if it was given.
    pub fn answered(&self) -> Option<BoardsTold> {
        *self.told.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Asks for it, and waits for the answer: a second at most, or until boards are armed.
    ///
    /// # Errors
    /// If it does not come in time; a sentence.
    pub fn ask_and_wait(&self) -> Result<Reply, String> {
        /// Longest time for the tick to see that it was asked.
        const PATIENCE: Duration = Duration::from_secs(1);
        /// Longest time beyond it to wait for boards that are being armed.
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
