//! State machine of a board's bring-up, with all its events.
//!
//! ```text
//! Greeting ─ hello ─▶ (Checking ─ homed ─▶) Streaming ─ done ─▶ Measuring ─ often enough ─▶ Disarming
//!    ▲                                                                                         │ nonce
//!    │                                                                                         ▼
//!    │                                                      Armed ◀─ Confirming ◀─ done ─ Arming
//!    └── it fell silent, restarted, or renders no force and gave no reason ◀──┴──────────┘
//! ```
//!
//! Only a board with the health feature is asked for its health. A board that sends fewer samples
//! than it confirmed is not armed, or is disarmed.
//!
//! A board that tripped over silence, or has restarted, is rearmed: at once, then after 1, 2 and
//! 4 s. One that restarts more often, was stopped, or has a failed key stays `Barred` until a
//! person has fixed the cause. One that does not reach `Armed` in five attempts is left alone for
//! ten seconds, or until its next hello.

use firmware_protocol::acyclic::arm::{Arm, Disarmed};
use firmware_protocol::acyclic::{Operation, Status, health::BoardHealth, stream::Stream};
use firmware_protocol::frame::hello::{Hello, feature, safe_reason};
use firmware_protocol::{Nothing, Record as _, schema};

use super::arm_state::{ArmLockout, ArmState, SlowSamples};
use super::back_off::BackOff;
use super::sample_watch::{SampleWatch, is_silence};
use crate::request_channel::RequestChannel;
use crate::rt::{sample_interval::IntervalFault, terms::BoardAgreement};

/// Pause between two attempts of a bring-up (us).
const AGAIN_US: u64 = 100_000;
/// Armed time below which a board is not rearmed at once (us).
const SHORT_US: u64 = 1_000_000;
const MOST_ATTEMPTS: u8 = 5;
/// Shortest and longest measurement of samples before arming (us).
const MEASURING_US: u64 = 150_000;
const LONGEST_MEASURING_US: u64 = 1_000_000;
const MOST_RESTARTS: u8 = 4;
const LEFT_ALONE_US: u64 = 10_000_000;

#[derive(Clone, Copy, Debug)]
pub(super) struct Arming {
    state: ArmState,
    armings: u64,
    attempts: u8,
    /// Begin of the state `Confirming` or `Armed` (us).
    since: u64,
    /// Rejected sample frames at the request to arm.
    refused: u64,
    /// Earliest time of the next request (us).
    rest_until: u64,
    /// End of the pause of a barred board (us).
    barred_until: u64,
    must_disarm: bool,
    trips: BackOff,
    restarts: BackOff,
}

impl Arming {
    pub(super) const fn new(now: u64) -> Self {
        Self {
            state: ArmState::Greeting,
            armings: 0,
            attempts: 0,
            since: now,
            refused: 0,
            rest_until: 0,
            barred_until: 0,
            must_disarm: false,
            trips: BackOff::NONE,
            restarts: BackOff::NONE,
        }
    }

    pub(super) const fn restarts(&self) -> u8 {
        self.restarts.n()
    }

    pub(super) const fn state(&self) -> ArmState {
        self.state
    }

    pub(super) const fn armings(&self) -> u64 {
        self.armings
    }

    pub(super) const fn has_rested(&self, now: u64) -> bool {
        self.rest_until <= now
    }

    pub(super) const fn rest(&mut self, now: u64) {
        self.rest_until = now + AGAIN_US;
    }

    /// Restarts the bring-up, since the board has restarted for `reason` (as in its hello).
    pub(super) fn on_start(&mut self, reason: u8, now: u64) {
        self.attempts = 0;
        // Its first start is no restart.
        let wait_us = if self.armings == 0 { 0 } else { self.restarts.next(now) };
        if MOST_RESTARTS < self.restarts.n() {
            self.bar(ArmLockout::Restarting { times: self.restarts.n(), reason }, now);
        } else {
            self.greet(now + wait_us);
        }
    }

    fn on_slow(&mut self, slow: SlowSamples, now: u64) {
        self.must_disarm = self.state == ArmState::Armed;
        self.bar(ArmLockout::Slow(slow), now);
    }

    /// Restarts after a pause, since a request was never answered.
    pub(super) const fn on_loss(&mut self, now: u64) {
        if !self.state.is_barred() {
            self.greet(now + AGAIN_US);
        }
    }

    /// Bars a board whose clock runs too fast by `ppm` (1e-6), beyond the limit.
    pub(super) const fn on_clock(&mut self, ppm: i32, now: u64) {
        if matches!(self.state, ArmState::Confirming | ArmState::Armed) {
            self.bar(ArmLockout::Clock(ppm), now);
            self.must_disarm = true;
        }
    }

    /// Bars a board whose samples are too old on arrival (ms) for forces to answer them.
    pub(super) const fn on_late(&mut self, ms: u16, now: u64) {
        if matches!(self.state, ArmState::Armed) {
            self.bar(ArmLockout::Late(ms), now);
            self.must_disarm = true;
        }
    }

    pub(super) fn on_time(&mut self, samples: &SampleWatch, agreed_us: u16, now: u64) {
        let intervals = samples.intervals();
        let slow = intervals.filter(|it| it.fault(agreed_us) == Some(IntervalFault::Slow));
        if let (ArmState::Measuring | ArmState::Armed, Some(it)) = (self.state, slow) {
            return self.on_slow(SlowSamples { median_us: it.sent_us, agreed_us }, now);
        }
        if let (ArmState::Measuring, Some(us)) = (self.state, samples.burst_us()) {
            let us = u32::try_from(us).unwrap_or(u32::MAX);
            return self.bar(ArmLockout::Bursts(us), now);
        }
        match self.state {
            ArmState::Measuring => {
                // Missing or unreadable samples are found later.
                let is_mute = is_silence(self.since, now) && !samples.have_come_since(self.since);
                let is_measured = intervals.is_some() && self.since + MEASURING_US < now;
                if is_measured || is_mute || self.since + LONGEST_MEASURING_US < now {
                    self.attempt();
                }
            }
            ArmState::Arming { .. } => self.refused = samples.refused(),
            ArmState::Confirming => self.confirm(samples, now),
            ArmState::Armed if samples.is_silent(now) || samples.is_flagged() => {
                let is_short = now < self.since + SHORT_US;
                let wait_us = self.trips.next(now).max(if is_short { AGAIN_US } else { 0 });
                self.greet(now + wait_us);
            }
            ArmState::Barred(why) if why.ends() && self.barred_until <= now => {
                self.attempts = MOST_ATTEMPTS - 1;
                self.greet(now);
            }
            ArmState::Greeting
            | ArmState::Checking
            | ArmState::Streaming
            | ArmState::Disarming
            | ArmState::Armed
            | ArmState::Barred(_) => {}
        }
    }

    /// Advances after the board has done a request and answered with `record`.
    ///
    /// An answer for which the state does not wait is late, and changes nothing.
    pub(super) fn on_done(
        &mut self,
        done: Operation,
        record: &[u8],
        agreed: &BoardAgreement,
        now: u64,
    ) {
        if self.state.waits_for() != Some(done) {
            return;
        }
        match self.state {
            ArmState::Greeting => {
                let hello = Hello::take(record);
                self.state = hello.map_or(ArmState::Greeting, |it| after_hello(&it, agreed));
            }
            ArmState::Checking => {
                let unknown = BoardHealth::take(record)
                    .map(|it| !it.homed & !(u16::MAX << agreed.place.n_keys.min(15)));
                match unknown {
                    Some(0) => self.state = ArmState::Streaming,
                    Some(keys) => self.bar(ArmLockout::NotHomed(keys), now),
                    None => {}
                }
            }
            ArmState::Streaming => (self.state, self.since) = (ArmState::Measuring, now),
            ArmState::Disarming => {
                if let Some(Disarmed { nonce }) = Disarmed::take(record) {
                    self.state = ArmState::Arming { nonce };
                }
            }
            ArmState::Arming { .. } => (self.state, self.since) = (ArmState::Confirming, now),
            ArmState::Measuring | ArmState::Confirming | ArmState::Armed | ArmState::Barred(_) => {}
        }
    }

    pub(super) fn on_declined(&mut self, asked: Operation, status: Status, now: u64) {
        let why = ArmLockout::Declined(asked, status);
        let is_nonce_old =
            status == Status::WrongNonce || (asked, status) == (Operation::Arm, Status::WrongState);
        if (asked, status) == (Operation::Disarm, Status::WrongState) {
            // It was stopped or has failed since its hello; the next hello contains the reason.
            self.fail(why, now);
        } else if is_nonce_old && self.attempts < MOST_ATTEMPTS {
            self.attempt();
        } else {
            self.bar(why, now);
        }
    }

    /// Sends the next request of the bring-up; returns `true` if there is one.
    pub(super) fn ask(&mut self, agreed: &BoardAgreement, channel: &mut RequestChannel) -> bool {
        let terms = agreed.terms;
        if std::mem::take(&mut self.must_disarm) {
            channel.ask(Operation::Disarm, &Nothing);
            return true;
        }
        match self.state {
            ArmState::Greeting => channel.ask(Operation::Hello, &Nothing),
            ArmState::Checking => channel.ask(Operation::BoardHealth, &Nothing),
            ArmState::Streaming => {
                let (period_us, phase_us) = (terms.period_us, agreed.phase_us);
                let packing = terms.samples as u8;
                channel.ask(Operation::Stream, &Stream { period_us, packing, phase_us });
            }
            ArmState::Disarming => channel.ask(Operation::Disarm, &Nothing),
            ArmState::Arming { nonce } => {
                let (packing, valid_ms) = (terms.forces as u8, terms.valid_ms);
                channel.ask(Operation::Arm, &Arm { nonce, packing, valid_ms });
            }
            ArmState::Measuring | ArmState::Confirming | ArmState::Armed | ArmState::Barred(_) => {
                return false;
            }
        }
        true
    }

    const fn greet(&mut self, rest_until: u64) {
        self.state = ArmState::Greeting;
        self.rest_until = rest_until;
    }

    const fn attempt(&mut self) {
        self.state = ArmState::Disarming;
        self.attempts = self.attempts.saturating_add(1);
    }

    /// Accepts that a board is armed as soon as its samples confirm it.
    const fn confirm(&mut self, samples: &SampleWatch, now: u64) {
        if samples.is_clear_at(now) {
            self.state = ArmState::Armed;
            self.armings += 1;
            (self.since, self.attempts) = (now, 0);
        } else if is_silence(self.since, now) {
            let why = if samples.have_come_since(self.since) {
                ArmLockout::StaysSafe
            } else if self.refused < samples.refused() {
                ArmLockout::Unreadable
            } else {
                ArmLockout::NoSamples
            };
            self.fail(why, now);
        }
    }

    /// Ends an attempt: another one follows, unless there were too many.
    const fn fail(&mut self, why: ArmLockout, now: u64) {
        if self.attempts < MOST_ATTEMPTS {
            self.greet(now + AGAIN_US);
        } else {
            self.bar(why, now);
        }
    }

    const fn bar(&mut self, why: ArmLockout, now: u64) {
        self.state = ArmState::Barred(why);
        self.barred_until = now + LEFT_ALONE_US;
    }
}

fn after_hello(hello: &Hello, agreed: &BoardAgreement) -> ArmState {
    let is_same = hello.uid == agreed.uid && hello.schema == schema::HASH;
    if !is_same {
        return ArmState::Barred(ArmLockout::Exchanged);
    }
    match hello.safe_reason {
        latched @ (safe_reason::EMERGENCY_STOP | safe_reason::KEY_FAULT) => {
            ArmState::Barred(ArmLockout::Latched(latched))
        }
        _ if hello.features & feature::HEALTH != 0 => ArmState::Checking,
        _ => ArmState::Streaming,
    }
}

#[cfg(test)]
mod tests {
    use firmware_protocol::frame::hello::MAGIC;
    use firmware_protocol::frame::key_forces::ForcePacking;
    use firmware_protocol::frame::key_samples::SamplePacking;
    use firmware_protocol::key::{BoardId, KeyIndex};

    use super::*;
    use crate::{rt::terms::Terms, topology::BoardPlace};

    fn after(features: u16, homed: u16) -> ArmState {
        let (line, n_keys) = (0, 2);
        let board = BoardId::new(3).unwrap();
        let place = BoardPlace { line, board, first_key: KeyIndex::LOWEST, n_keys };
        let (samples, forces) = (SamplePacking::default(), ForcePacking::default());
        let terms = Terms { period_us: 1_000, samples, forces, valid_ms: 20 };
        let agreed = BoardAgreement { place, uid: [7; 6], features, phase_us: 0, terms };
        let zeros = Hello::take(&[0; Hello::LEN]).unwrap();
        let (magic, schema, uid) = (MAGIC, schema::HASH, agreed.uid);
        let hello = Hello { magic, schema, uid, features, ..zeros };
        let mut record = [0; 64];
        let mut arming = Arming::new(0);
        hello.put(&mut record).unwrap();
        arming.on_done(Operation::Hello, &record, &agreed, 1);
        if arming.state() == ArmState::Checking {
            let health = BoardHealth { boots: 1, homed, faults: 0, muted: 0 };
            health.put(&mut record).unwrap();
            arming.on_done(Operation::BoardHealth, &record, &agreed, 2);
        }
        arming.state()
    }

    #[test]
    fn a_board_that_knows_its_health_goes_on_only_if_all_its_keys_are_homed() {
        assert_eq!(after(feature::HEALTH, 0b11), ArmState::Streaming);
        assert_eq!(after(feature::HEALTH, 0b111), ArmState::Streaming);
        let lost = ArmState::Barred(ArmLockout::NotHomed(0b10));
        assert_eq!(after(feature::HEALTH, 0b01), lost);
        assert_eq!(after(0, 0), ArmState::Streaming);
    }
}
