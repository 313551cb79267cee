//! What goes on with every board beside the cyclic frames: it is brought up, kept armed,
//! asked for its time and its counts, and its simulated fingers are moved.
//!
//! | file | what stands there |
//! |---|---|
//! | `arming` | the state machine that brings one board up |
//! | `sample_watch` | what its samples tell of it |
//! | `age_watch` | samples that take longer on their way than at first |
//! | `back_off` | how long to wait before one that fails again and again is armed |
//! | `health` | how it reports that it and its keys are |
//! | `timing` | its clock, learned from round trips |
//! | `gesture_queue` | gestures for its simulated fingers |
//! | `session` | which request is next, and what its answer means |
//!
//! A board whose clock runs too fast or too slow is disarmed until it starts anew.

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

/// The supervision of all boards, in the order in which the bus has them.
#[derive(Clone, Debug)]
pub struct BoardSupervisor {
    sessions: Vec<BoardSession>,
    now: u64,
    /// Host time of the performance's beginning (us).
    origin: Option<u64>,
}

impl BoardSupervisor {
    /// Begins with boards in the order in which the bus has them; `now` (us).
    pub fn new(agreed: Vec<BoardAgreement>, now: u64) -> Self {
        let sessions = agreed.into_iter().map(|agreed| BoardSession::new(agreed, now)).collect();
        Self { sessions, now, origin: None }
    }

    /// Hands these gestures over to the key in `slot` of a board, in time from the origin on.
    ///
    /// Not for the tick.
    pub fn play(&mut self, board: usize, slot: u8, gestures: &[Gesture]) {
        if let Some(session) = self.sessions.get_mut(board) {
            session.gestures.add(slot, gestures);
        }
    }

    /// Hands all gestures over again and again, each pass `length` (s) after the one before.
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

    /// Takes the host time (us).
    pub const fn set_now(&mut self, now: u64) {
        self.now = now;
    }

    /// Looks after the boards on `line`, and sends what is to be sent.
    ///
    /// # Real-time
    /// At most one frame for each board; no heap.
    pub fn attend(&mut self, line: usize, bus: &mut KeybedBus, link: &mut (impl Link + ?Sized)) {
        let (now, origin) = (self.now, self.origin);
        let sessions = self.sessions.iter_mut().enumerate();
        for (board, session) in sessions.filter(|(_, it)| it.agreed.place.line == line) {
            let Some(frame) = session.attend(now, origin, board, bus) else { continue };
            // What the link does not take is asked again.
            if link.try_send(frame).is_ok() {
                bus.saw_sent(line, frame.len());
            }
        }
    }

    /// Tells whether every board renders forces and its clock is known.
    pub fn is_ready(&self) -> bool {
        self.sessions.iter().all(BoardSession::is_ready)
    }

    /// Tells whether a board renders forces and its clock is known.
    pub fn is_board_ready(&self, board: usize) -> bool {
        self.sessions.get(board).is_some_and(BoardSession::is_ready)
    }

    /// Returns the share of its forces that a board may be sent now, 0 to 1.
    pub fn share(&self, board: usize) -> f64 {
        self.sessions.get(board).map_or(0.0, BoardSession::share)
    }

    /// Asks all boards soon for what they have counted; not for the tick.
    pub fn want_counters(&mut self) {
        self.sessions.iter_mut().for_each(BoardSession::want_counters);
    }

    /// Tells whether nothing is waited for: every board is ready, or may not be armed.
    pub fn is_settled(&self) -> bool {
        self.sessions.iter().all(|it| it.is_ready() || it.state().is_barred())
    }

    /// Tells whether a board was stopped or has failed, and stays so until a person sees to it.
    pub fn is_latched(&self, board: usize) -> bool {
        let state = self.sessions.get(board).map(BoardSession::state);
        matches!(state, Some(ArmState::Barred(ArmLockout::Latched(_))))
    }

    /// Returns how long before the host's `at_us` a board took the samples with this stamp (us).
    pub fn age_us(&self, board: usize, at_us: u64, stamp_us: u16) -> Option<i32> {
        self.sessions.get(board)?.timing.clock().age_us(at_us, stamp_us)
    }

    /// Takes the age of samples of a board that have just come (us), `period_us` after those before.
    pub fn take_age(&mut self, board: usize, age_us: i32, period_us: u64) {
        if let Some(session) = self.sessions.get_mut(board) {
            session.take_age(age_us, period_us);
        }
    }

    /// Bars a board whose samples usually come `usual_us` after they were taken, if no force can
    /// answer them in time.
    pub fn watch_lateness(&mut self, board: usize, usual_us: f64) {
        let now = self.now;
        let Some(session) = self.sessions.get_mut(board) else { return };
        if f64::from(session.agreed.terms.valid_ms) * 1e3 < usual_us {
            session.on_late(usual_us, now);
        }
    }

    /// Returns whether a board was never ready since it answered too late.
    pub fn answers_late(&self, board: usize) -> bool {
        self.sessions.get(board).is_some_and(BoardSession::answers_late)
    }

    /// Returns the time since a board's newest answer (us), if it has ever answered.
    pub fn since_answer(&self, board: usize) -> Option<u64> {
        self.sessions.get(board)?.since_answer(self.now)
    }

    /// Lets a board show its light, as soon as it is armed or may not be.
    pub fn request_light(&mut self, board: usize) {
        if let Some(session) = self.sessions.get_mut(board) {
            session.is_light_wanted = true;
        }
    }

    /// Returns how a board is.
    ///
    /// # Real-time
    /// Sorts 15 numbers; no heap.
    pub fn status(&self, board: usize) -> Option<BoardStatus> {
        self.sessions.get(board).map(BoardSession::status)
    }

    /// Returns what a board is like; not for the tick.
    pub fn condition(&self, board: usize) -> Option<Condition> {
        self.sessions.get(board).map(BoardSession::condition)
    }

    /// Returns how often a board was armed, if it is now.
    pub fn armings(&self, board: usize) -> Option<u64> {
        self.sessions.get(board)?.armings()
    }

    /// Returns the operation for whose answer a board is waited for; none if it may not be armed.
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
