//! Supervision of every board beside the cyclic frames.
//!
//! | module | contents |
//! |---|---|
//! | `arming` | state machine that brings one board up |
//! | `sample_watch` | conclusions from its samples |
//! | `age_watch` | samples that take longer on their path than at first |
//! | `back_off` | wait before one that fails repeatedly is armed |
//! | `health` | reports on itself and its keys |
//! | `timing` | its clock, learned from round trips |
//! | `gesture_queue` | gestures for its simulated fingers |
//! | `session` | order of the requests, and effect of the answers |
//!
//! A board whose clock runs too fast or too slow is disarmed until it restarts.

mod age_watch;
mod arm_state;
mod arming;
mod back_off;
mod gesture_queue;
mod health;
mod sample_watch;
mod session;
mod status;
mod timing;

use crate::links::Link;
use firmware_protocol::acyclic::Operation;
use firmware_protocol::frame::{FrameKind, board_of};
use haptics::plant::Gesture;

use super::bus::{AcyclicHandler, KeybedBus};
use super::terms::BoardAgreement;
use session::BoardSession;

pub use arm_state::{ArmLockout, ArmState, SlowSamples};
pub use session::LIGHT_S;
pub use status::{BoardStatus, Condition};

/// Supervision of all boards, in the order of the bus.
#[derive(Clone, Debug)]
pub struct BoardSupervisor {
    sessions: Vec<BoardSession>,
    now: u64,
    /// Host time of the performance's beginning (us).
    origin: Option<u64>,
}

impl BoardSupervisor {
    /// Begins with boards in the order of the bus; `now` (us).
    pub fn new(agreed: Vec<BoardAgreement>, now: u64) -> Self {
        let sessions = agreed.into_iter().map(|agreed| BoardSession::new(agreed, now)).collect();
        Self { sessions, now, origin: None }
    }

    /// Sends gestures to the key in `slot` of a board, timed from the origin; not for the tick.
    pub fn play(&mut self, board: usize, slot: u8, gestures: &[Gesture]) {
        if let Some(session) = self.sessions.get_mut(board) {
            session.gestures.add(slot, gestures);
        }
    }

    /// Repeats all gestures with the period `length` (s).
    pub fn repeat_after(&mut self, length: f64) {
        self.sessions.iter_mut().for_each(|session| session.gestures.repeat_after(length));
    }

    /// Sets the host time from which gestures count (us).
    pub const fn begin_at(&mut self, origin: u64) {
        self.origin = Some(origin);
    }

    /// Returns the host time of the last call (us).
    pub const fn now(&self) -> u64 {
        self.now
    }

    /// Sets the host time (us).
    pub const fn set_now(&mut self, now: u64) {
        self.now = now;
    }

    /// Receives from the boards on `line`, and sends their requests.
    ///
    /// # Real-time
    /// At most one frame for each board; no heap.
    pub fn attend(&mut self, line: usize, bus: &mut KeybedBus, link: &mut (impl Link + ?Sized)) {
        let (now, origin) = (self.now, self.origin);
        let sessions = self.sessions.iter_mut().enumerate();
        for (board, session) in sessions.filter(|(_, it)| it.agreed.place.line == line) {
            let Some(frame) = session.attend(now, origin, board, bus) else { continue };
            // A request that the link rejects is repeated.
            if link.try_send(frame).is_ok() {
                bus.saw_sent(line, frame.len());
            }
        }
    }

    pub fn is_ready(&self) -> bool {
        self.sessions.iter().all(BoardSession::is_ready)
    }

    pub fn is_board_ready(&self, board: usize) -> bool {
        self.sessions.get(board).is_some_and(BoardSession::is_ready)
    }

    /// Returns the permitted share of a board's forces, 0 to 1.
    pub fn share(&self, board: usize) -> f64 {
        self.sessions.get(board).map_or(0.0, BoardSession::share)
    }

    /// Requests the counters of all boards soon; not for the tick.
    pub fn want_counters(&mut self) {
        self.sessions.iter_mut().for_each(BoardSession::want_counters);
    }

    /// Returns `true` if every board is ready, or may not be armed.
    pub fn is_settled(&self) -> bool {
        self.sessions.iter().all(|it| it.is_ready() || it.state().is_barred())
    }

    /// Returns `true` if a board was stopped or has failed, until a person fixes the cause.
    pub fn is_latched(&self, board: usize) -> bool {
        let state = self.sessions.get(board).map(BoardSession::state);
        matches!(state, Some(ArmState::Barred(ArmLockout::Latched(_))))
    }

    /// Returns the age of a board's samples with this stamp at the host's `at_us` (us).
    pub fn age_us(&self, board: usize, at_us: u64, stamp_us: u16) -> Option<i32> {
        self.sessions.get(board)?.timing.clock().age_us(at_us, stamp_us)
    }

    /// Adds the age of a board's new samples (us), `period_us` after those before.
    pub fn take_age(&mut self, board: usize, age_us: i32, period_us: u64) {
        if let Some(session) = self.sessions.get_mut(board) {
            session.take_age(age_us, period_us);
        }
    }

    /// Bars a board whose samples usually arrive `usual_us` late, too late for any force.
    pub fn watch_lateness(&mut self, board: usize, usual_us: f64) {
        let now = self.now;
        let Some(session) = self.sessions.get_mut(board) else { return };
        if f64::from(session.agreed.terms.valid_ms) * 1e3 < usual_us {
            session.on_late(usual_us, now);
        }
    }

    /// Returns `true` if a board was never ready because it answered too late.
    pub fn answers_late(&self, board: usize) -> bool {
        self.sessions.get(board).is_some_and(BoardSession::answers_late)
    }

    /// Returns the time since a board's newest answer (us), if any.
    pub fn since_answer(&self, board: usize) -> Option<u64> {
        self.sessions.get(board)?.since_answer(self.now)
    }

    /// Requests a board's light, as soon as it is armed or barred.
    pub fn request_light(&mut self, board: usize) {
        if let Some(session) = self.sessions.get_mut(board) {
            session.is_light_wanted = true;
        }
    }

    /// Returns the status of a board.
    ///
    /// # Real-time
    /// Sorts 15 numbers; no heap.
    pub fn status(&self, board: usize) -> Option<BoardStatus> {
        self.sessions.get(board).map(BoardSession::status)
    }

    pub fn condition(&self, board: usize) -> Option<Condition> {
        self.sessions.get(board).map(BoardSession::condition)
    }

    pub fn armings(&self, board: usize) -> Option<u64> {
        self.sessions.get(board)?.armings()
    }

    /// Returns the operation whose answer is awaited from a board; `None` if it may not be armed.
    pub fn asked(&self, board: usize) -> Option<Operation> {
        let state = self.sessions.get(board)?.state();
        (!state.is_barred()).then(|| state.waits_for().unwrap_or(Operation::Ping))
    }
}

impl AcyclicHandler for BoardSupervisor {
    fn take(&mut self, line: usize, frame: &[u8]) {
        let board = board_of(frame);
        let is_it = |it: &&mut BoardSession| {
            it.agreed.place.line == line && Some(it.agreed.place.board) == board
        };
        let Some(session) = self.sessions.iter_mut().find(is_it) else { return };
        if FrameKind::of(frame) == Some(FrameKind::Hello) {
            session.take_hello(frame, self.now);
        } else {
            session.take_reply(frame, self.now);
        }
    }
}
