//! Requests to one board beside the cyclic frames: their order, and the effect of the answers.

use firmware_protocol::acyclic::{
    Operation, Status, counters::Counters, finger::Finger, health::BoardHealth, light::Light,
    ping::Pong,
};
use firmware_protocol::frame::hello::{Introduction, safe_reason};
use firmware_protocol::{Nothing, Record as _};

use super::arm_state::{ArmLockout, ArmState};
use super::status::{BoardStatus, Condition};
use super::{
    age_watch::AgeWatch, arming::Arming, gesture_queue::GestureQueue, health::HealthWatch,
    sample_watch::SampleWatch, timing::BoardTiming,
};
use crate::request_channel::{ReceivedReply, RequestChannel};
use crate::{
    periods::COUNTERS_US, rt::board::BoardStatistics, rt::bus::KeybedBus, rt::key_fault::KeyFault,
    rt::sample_interval::IntervalFault, rt::terms::BoardAgreement,
};

/// Time for which a light identifies its board (s).
pub const LIGHT_S: u8 = 10;

#[derive(Clone, Debug)]
pub(super) struct BoardSession {
    pub(super) agreed: BoardAgreement,
    pub(super) gestures: GestureQueue,
    pub(super) is_light_wanted: bool,
    channel: RequestChannel,
    arming: Arming,
    pub(super) timing: BoardTiming,
    samples: SampleWatch,
    counters: CounterWatch,
    replies: ReplyStatistics,
    /// `true` if the board has restarted, and the numbers of its samples with it.
    is_anew: bool,
    /// Restarts since the first arming, and the last reason.
    restarts: u64,
    reset_reason: u8,
    health: HealthWatch,
    ages: AgeWatch,
}

#[derive(Clone, Debug, Default)]
struct CounterWatch {
    newest: Option<Counters>,
    /// `true` if most forces between the two newest answers were stale.
    is_stale: bool,
    next_us: u64,
}

impl CounterWatch {
    fn take(&mut self, counters: Option<Counters>) {
        self.is_stale = self.newest.zip(counters).is_some_and(|(before, after)| {
            let stale = after.stale.saturating_sub(before.stale);
            after.forces.saturating_sub(before.forces) < stale
        });
        self.newest = counters;
    }
}

#[derive(Clone, Debug, Default)]
struct ReplyStatistics {
    /// Requests that the board declined while it was armed.
    declined: u64,
    /// Answers to requests that had been sent twice.
    late: u64,
    newest_us: Option<u64>,
}

impl BoardSession {
    pub(super) fn new(agreed: BoardAgreement, now: u64) -> Self {
        // Another host's last request may have had any number.
        let [first, ..] = now.to_le_bytes();
        Self {
            channel: RequestChannel::new(agreed.place.board, first),
            health: HealthWatch::new(&agreed),
            agreed,
            gestures: GestureQueue::default(),
            is_light_wanted: false,
            arming: Arming::new(now),
            timing: BoardTiming::default(),
            samples: SampleWatch::new(now),
            counters: CounterWatch::default(),
            replies: ReplyStatistics::default(),
            is_anew: false,
            restarts: 0,
            reset_reason: 0,
            ages: AgeWatch::default(),
        }
    }

    pub(super) const fn state(&self) -> ArmState {
        self.arming.state()
    }

    /// Returns `true` if the board is armed, its clock known, and every failed key explained.
    pub(super) fn is_ready(&self) -> bool {
        self.state() == ArmState::Armed && self.timing.is_known() && self.health.is_settled()
    }

    pub(super) fn share(&self) -> f64 {
        /// Share for a board whose samples arrive unevenly.
        const SOFT: f64 = 0.5;
        if self.state() != ArmState::Armed || self.samples.burst_us().is_some() {
            return 0.0;
        }
        let fault = self.samples.intervals().and_then(|it| it.fault(self.agreed.terms.period_us));
        let even = match fault {
            None => 1.0,
            Some(IntervalFault::Uneven) => SOFT,
            Some(IntervalFault::Slow) => 0.0,
        };
        self.ages.share().min(even)
    }

    pub(super) fn take_age(&mut self, age_us: i32, period_us: u64) {
        if self.state() == ArmState::Armed {
            self.ages.take(age_us, period_us);
        }
    }

    pub(super) const fn want_counters(&mut self) {
        self.counters.next_us = 0;
    }

    pub(super) fn answers_late(&self) -> bool {
        /// Late answers that may be chance.
        const FEW: u64 = 8;
        !self.timing.is_known() && FEW < self.replies.late
    }

    pub(super) fn since_answer(&self, now: u64) -> Option<u64> {
        self.replies.newest_us.map(|newest| now.saturating_sub(newest))
    }

    /// Records that samples usually arrive `usual_us` late, too late for forces. The board must
    /// have counted late forces, since a misread clock shows the same.
    pub(super) const fn on_late(&mut self, usual_us: f64, now: u64) {
        if !self.counters.is_stale {
            return;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
        let ms = (usual_us * 1e-3) as u16;
        self.arming.on_late(ms, now);
    }

    pub(super) fn armings(&self) -> Option<u64> {
        (self.state() == ArmState::Armed).then_some(self.arming.armings())
    }

    pub(super) fn status(&self) -> BoardStatus {
        BoardStatus {
            state: self.state(),
            armings: self.arming.armings(),
            round_trip_us: self.timing.round_trips().recent(),
            restarts: self.arming.restarts(),
            reset_reason: self.reset_reason,
            burst_us: self.samples.burst_us(),
            late: self.ages.late(),
        }
    }

    pub(super) fn condition(&self) -> Condition {
        Condition {
            state: self.state(),
            armings: self.arming.armings(),
            jumps: self.timing.jumps(),
            drift_ppm: self.timing.clock().drift_ppm(),
            round_trips_us: self.timing.round_trips().quantiles(),
            counters: self.counters.newest,
            declined: self.replies.declined,
            restarts: self.restarts,
            reset_reason: self.reset_reason,
            burst_us: self.samples.burst_us(),
            late: self.ages.late(),
            hottest: self.health.hottest(),
        }
    }

    /// Evaluates the frames of the board with this index; returns the frame to send.
    pub(super) fn attend(
        &mut self,
        now: u64,
        origin: Option<u64>,
        board: usize,
        bus: &mut KeybedBus,
    ) -> Option<&[u8]> {
        self.watch(now, board, bus);
        if self.channel.gave_up(now) {
            self.arming.on_loss(now);
        }
        if self.channel.is_free() && self.arming.has_rested(now) {
            self.ask_next(now, origin, &bus.statistics(board));
        }
        self.channel.due(now)
    }

    fn watch(&mut self, now: u64, board: usize, bus: &mut KeybedBus) {
        if std::mem::take(&mut self.is_anew) {
            bus.forget(board);
            bus.unmute(board);
            self.health.forget();
        }
        for (slot, cause) in self.health.failed() {
            bus.mute(board, slot, KeyFault::Reported(cause));
        }
        if self.state() != ArmState::Armed {
            self.ages.forget();
        }
        self.samples.update(&bus.statistics(board), now);
        if let Some(ppm) = self.timing.excess_ppm() {
            self.arming.on_clock(ppm, now);
        }
        if self.state() == ArmState::Armed && self.samples.is_silent(now) {
            // Its numbers may restart.
            bus.forget(board);
        }
        self.arming.on_time(&self.samples, self.agreed.terms.period_us, now);
    }

    /// Sends the next request: for the bring-up, then the light, then the others in turns.
    fn ask_next(&mut self, now: u64, origin: Option<u64>, statistics: &BoardStatistics) {
        if self.arming.ask(&self.agreed, &mut self.channel) {
            return;
        }
        match self.state() {
            ArmState::Armed | ArmState::Barred(_) if self.is_light_wanted => {
                self.is_light_wanted = false;
                self.channel.ask(Operation::Light, &Light { seconds: LIGHT_S });
            }
            // A latched board still reports the failed key.
            ArmState::Armed | ArmState::Barred(ArmLockout::Latched(_))
                if self.health.ask(now, statistics, &mut self.channel) => {}
            ArmState::Armed => self.ask_by_turns(now, origin),
            ArmState::Greeting
            | ArmState::Checking
            | ArmState::Streaming
            | ArmState::Measuring
            | ArmState::Disarming
            | ArmState::Arming { .. }
            | ArmState::Confirming
            | ArmState::Barred(_) => {}
        }
    }

    /// Asks an armed board for its time, for a gesture or for its counters, if one is due.
    fn ask_by_turns(&mut self, now: u64, origin: Option<u64>) {
        if self.timing.take_ping(now) {
            self.channel.ask(Operation::Ping, &Nothing);
        } else if let Some(finger) = self.next_gesture(now, origin) {
            self.channel.ask(Operation::Finger, &finger);
        } else if self.counters.next_us <= now {
            self.counters.next_us = now + COUNTERS_US;
            self.channel.ask(Operation::Counters, &Nothing);
        }
    }

    fn next_gesture(&self, now: u64, origin: Option<u64>) -> Option<Finger> {
        self.gestures.next(now, origin?, self.timing.clock())
    }

    /// Handles an unrequested hello: the board may have restarted.
    pub(super) fn take_hello(&mut self, frame: &[u8], now: u64) {
        let Ok(it) = Introduction::decode(frame) else { return };
        if it.hello.uid != self.agreed.uid || it.hello.safe_reason != safe_reason::NEVER_ARMED {
            return;
        }
        if matches!(self.state(), ArmState::Barred(ArmLockout::Clock(_))) {
            self.timing.forget();
        } else {
            self.timing.on_start();
        }
        self.is_anew = true;
        self.reset_reason = it.hello.reset_reason;
        self.restarts += u64::from(0 < self.arming.armings());
        self.arming.on_start(it.hello.reset_reason, now);
    }

    pub(super) fn take_reply(&mut self, frame: &[u8], now: u64) {
        let Some(received) = self.channel.take_reply(frame) else { return };
        let ReceivedReply { reply, operation, sent_us } = received;
        self.replies.late += u64::from(sent_us.is_none());
        self.replies.newest_us = Some(now);
        if reply.status == Status::Done {
            self.on_done(operation, reply.record, sent_us, now);
        } else {
            self.on_declined(operation, reply.status, now);
        }
    }

    #[expect(clippy::wildcard_enum_match_arm, reason = "a session asks for some operations only")]
    fn on_done(&mut self, done: Operation, record: &[u8], sent_us: Option<u64>, now: u64) {
        match done {
            Operation::BoardHealth => {
                if let Some(health) = BoardHealth::take(record) {
                    self.health.take_board(&health);
                }
                self.arming.on_done(done, record, &self.agreed, now);
            }
            Operation::KeyHealth => self.health.take_key(Some(record)),
            Operation::MuteKey => self.health.on_muted(),
            Operation::Hello | Operation::Stream | Operation::Disarm | Operation::Arm => {
                self.arming.on_done(done, record, &self.agreed, now);
            }
            Operation::Ping => {
                // A request that was sent twice measures no time.
                if let Some((Pong { board_us }, sent_us)) = Pong::take(record).zip(sent_us) {
                    self.timing.learn(sent_us, board_us, now);
                }
            }
            // A gesture that was never answered is sent again.
            Operation::Finger => self.gestures.advance(),
            Operation::Counters => self.counters.take(Counters::take(record)),
            _ => {}
        }
    }

    #[expect(clippy::wildcard_enum_match_arm, reason = "a session asks for some operations only")]
    fn on_declined(&mut self, asked: Operation, status: Status, now: u64) {
        if self.state().is_barred() {
            self.replies.declined += 1;
            return;
        }
        match asked {
            Operation::KeyHealth => self.health.take_key(None),
            Operation::MuteKey => self.health.on_muted(),
            Operation::BoardHealth if self.state() != ArmState::Checking => {
                self.replies.declined += 1;
            }
            Operation::Hello
            | Operation::BoardHealth
            | Operation::Stream
            | Operation::Disarm
            | Operation::Arm => {
                self.arming.on_declined(asked, status, now);
            }
            // The board's queue of gestures is full: try again later.
            Operation::Finger if status == Status::WrongState => self.arming.rest(now),
            Operation::Finger => {
                self.replies.declined += 1;
                self.gestures.advance();
            }
            // A board with an unreadable clock is unusable.
            Operation::Ping if !self.timing.is_known() => {
                self.arming.on_declined(asked, status, now);
            }
            _ => self.replies.declined += 1,
        }
    }
}
