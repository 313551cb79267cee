//! How a simulated board answers requests.

use crate::links::Link;
use firmware_protocol::acyclic::arm::{Arm, Disarmed, LONGEST_VALID_MS, SHORTEST_VALID_MS};
use firmware_protocol::acyclic::calibration::{KeyCalibration, ReadCalibration};
use firmware_protocol::acyclic::config::{self, Config, ReadConfig, WriteConfig, setting};
use firmware_protocol::acyclic::counters::Counters;
use firmware_protocol::acyclic::finger::{self, Finger};
use firmware_protocol::acyclic::health::{
    BoardHealth, KeyHealth, MuteKey, NOT_MEASURED, ReadKeyHealth, key_fault,
};
use firmware_protocol::acyclic::light::Light;
use firmware_protocol::acyclic::log::{LogLine, ReadLog};
use firmware_protocol::acyclic::ping::Pong;
use firmware_protocol::acyclic::stream::Stream;
use firmware_protocol::acyclic::{AcyclicRequest, Operation, Status, encode_reply};
use firmware_protocol::frame::hello::safe_reason;
use firmware_protocol::frame::key_forces::ForcePacking;
use firmware_protocol::frame::key_samples::SamplePacking;
use firmware_protocol::key::{BoardId, KeyIndex, MOST_KEYS};
use firmware_protocol::{MAX_FRAME, Nothing, Record};
use haptics::plant::{Gesture, Touch};

use super::{BoardMake, FakeIdentity, SimulatedBoard};
use crate::sim::force_interlock::NotArmed;

/// Lines that the log keeps.
const LOG: usize = 32;

/// What requests read and write.
#[derive(Clone, Debug)]
pub(super) struct BoardRequestHandler {
    settings: [i32; setting::COUNT as usize],
    calibration: [Option<KeyCalibration>; MOST_KEYS],
    log: Vec<LogLine>,
    /// The last reply, in case its request comes again: its number and operation.
    last: Option<((u8, u8), [u8; MAX_FRAME], usize)>,
    /// The light is on until then (us).
    light_until_us: u64,
    /// Times that it was started.
    boots: u32,
    /// Keys whose motors are off, the first in bit 0.
    muted: u16,
}

impl BoardRequestHandler {
    /// Returns the settings that `make` comes with.
    pub(super) fn new(make: BoardMake) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "a motor's force")]
        let limit = (make.rig.motor.limit * 1e3) as i32;
        Self {
            settings: [make.id.number().into(), make.first_key.into(), limit],
            calibration: [None; MOST_KEYS],
            log: Vec::with_capacity(LOG),
            last: None,
            light_until_us: 0,
            boots: 1,
            muted: 0,
        }
    }

    /// Returns `make` with the settings that hold from the next start.
    pub(super) fn next_make(&self, make: BoardMake) -> BoardMake {
        let [number, first_key, _limit] = self.settings.map(|it| u8::try_from(it).ok());
        let id = number.and_then(BoardId::new).unwrap_or(make.id);
        // It stays the same board under another number.
        let uid = Some(make.fake_identity.uid.unwrap_or_else(|| make.uid()));
        let fake_identity = FakeIdentity { uid, ..make.fake_identity };
        BoardMake { id, first_key: first_key.unwrap_or(make.first_key), fake_identity, ..make }
    }

    /// Keeps the settings of `before` over a start.
    pub(super) const fn keep_settings(&mut self, before: &Self) {
        self.settings = before.settings;
        self.boots = before.boots.saturating_add(1);
    }

    /// Returns which keys have their motors off, the first in bit 0.
    pub(super) const fn muted(&self) -> u16 {
        self.muted
    }

    /// Returns the largest force of the motors (mN).
    pub(super) fn max_force_mn(&self) -> u16 {
        let [_number, _first_key, limit] = self.settings;
        u16::try_from(limit).unwrap_or(u16::MAX)
    }

    /// Returns the CRC-32 of the settings.
    pub(super) fn config_crc(&self) -> u32 {
        config::crc(&self.settings)
    }

    /// Tells whether the light is on.
    pub(super) const fn is_lit(&self, now_us: u64) -> bool {
        now_us < self.light_until_us
    }

    /// Writes a line into the log; the oldest makes room.
    fn note(&mut self, board_us: u32, line: &str) {
        if self.log.len() == LOG {
            self.log.remove(0);
        }
        let mut text = [0; 48];
        for (place, byte) in text.iter_mut().zip(line.bytes()) {
            *place = byte;
        }
        self.log.push(LogLine { lines: 0, board_us, text });
    }
}

/// Reads a request's record.
fn record<R: Record>(request: &AcyclicRequest<'_>) -> Result<R, Status> {
    R::take(request.record).ok_or(Status::BadValue)
}

/// A reply, built in place.
struct ReplyBuffer<'a> {
    request: AcyclicRequest<'a>,
    operation: u8,
    bytes: [u8; MAX_FRAME],
    len: usize,
}

impl ReplyBuffer<'_> {
    fn with<R: Record>(&mut self, outcome: Result<R, Status>) {
        let AcyclicRequest { board, id, .. } = self.request;
        self.len = encode_reply(board, id, self.operation, outcome, &mut self.bytes);
    }
}

impl SimulatedBoard {
    /// Answers a request; the same one again is answered again and not done again.
    ///
    /// What it asks for holds from `from_us` on; what it is told is by the clock.
    pub(super) fn serve(&mut self, from_us: u64, frame: &[u8], link: &mut impl Link) {
        let Ok(request) = AcyclicRequest::decode(frame) else {
            self.counts.refused += 1;
            return;
        };
        let operation = request.operation.map_or_else(|it| it, |it| it as u8);
        // A host that starts anew may come upon the same number with another wish.
        let this = (request.id, operation);
        match self.requests.last {
            Some((last, bytes, len)) if last == this => self.send(&bytes[..len], link),
            Some(_) | None => {
                let mut answer = ReplyBuffer { request, operation, bytes: [0; MAX_FRAME], len: 0 };
                self.work_out(from_us, &mut answer);
                self.requests.last = Some((this, answer.bytes, answer.len));
                self.send(&answer.bytes[..answer.len], link);
            }
        }
    }

    /// Does what is asked for, and writes the answer.
    fn work_out(&mut self, from_us: u64, answer: &mut ReplyBuffer<'_>) {
        let request = answer.request;
        let Ok(operation) = request.operation else {
            return answer.with(Err::<Nothing, _>(Status::Unknown));
        };
        match operation {
            Operation::Hello => answer.with(Ok(self.introduction().hello)),
            Operation::Ping => answer.with(Ok(Pong { board_us: self.clock_us() })),
            Operation::Stream => answer.with(record(&request).and_then(|it| self.stream(it))),
            Operation::Disarm => answer.with(self.disarm(from_us)),
            Operation::Arm => answer.with(record(&request).and_then(|it| self.arm(it))),
            Operation::ReadConfig => {
                answer.with(record(&request).and_then(|it| self.read_config(it)));
            }
            Operation::WriteConfig => {
                answer.with(record(&request).and_then(|it| self.write_config(it)));
            }
            Operation::ReadCalibration => {
                answer.with(record(&request).and_then(|it| self.read_calibration(it)));
            }
            Operation::WriteCalibration => {
                answer.with(record(&request).and_then(|it| self.write_calibration(it)));
            }
            Operation::ReadLog => answer.with(record(&request).and_then(|it| self.read_log(it))),
            Operation::Light => answer.with(record(&request).map(|it| self.light(it))),
            Operation::Counters => answer.with(Ok(self.counters())),
            Operation::Finger => answer.with(record(&request).and_then(|it| self.finger(it))),
            Operation::BoardHealth => answer.with(Ok(self.health())),
            Operation::KeyHealth => {
                answer.with(record(&request).and_then(|it| self.key_health(it)));
            }
            Operation::MuteKey => answer.with(record(&request).and_then(|it| self.mute(it))),
            // There is none in a simulation.
            Operation::Bootloader => answer.with(Err::<Nothing, _>(Status::Impossible)),
        }
    }

    fn health(&self) -> BoardHealth {
        let BoardRequestHandler { boots, muted, .. } = self.requests;
        // Which key a fault is of nobody says: the first.
        let faults = u16::from(self.safe_reason() == safe_reason::KEY_FAULT);
        BoardHealth { boots, homed: !(u16::MAX << self.make.n_keys), faults, muted }
    }

    fn key_health(&self, wanted: ReadKeyHealth) -> Result<KeyHealth, Status> {
        /// Force of the motor for a current (N/A).
        const NEWTONS_PER_AMPERE: f64 = 10.0;
        let slot = usize::from(wanted.slot);
        let newtons = self.rig(slot).ok_or(Status::BadValue)?.motor_force();
        let has_failed = slot == 0 && self.safe_reason() == safe_reason::KEY_FAULT;
        let fault = if has_failed { key_fault::OTHER } else { key_fault::NONE };
        #[expect(clippy::cast_possible_truncation, reason = "saturates")]
        let current = (newtons / NEWTONS_PER_AMPERE * 1e3) as i16;
        Ok(KeyHealth { fault, temperature: NOT_MEASURED, current })
    }

    fn mute(&mut self, wanted: MuteKey) -> Result<Nothing, Status> {
        let MuteKey { slot, muted } = wanted;
        if self.make.n_keys <= usize::from(slot) || 1 < muted {
            return Err(Status::BadValue);
        }
        let others = self.requests.muted & !(1 << slot);
        self.requests.muted = others | u16::from(muted) << slot;
        Ok(Nothing)
    }

    fn stream(&mut self, wanted: Stream) -> Result<Nothing, Status> {
        let packing = SamplePacking::new(wanted.packing).ok_or(Status::BadValue)?;
        let ticks = f64::from(wanted.period_us) * 1e-6 / self.make.period;
        // A board can send at its own ticks only.
        if 1e-6 < (ticks - ticks.round()).abs() {
            return Err(Status::BadValue);
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "16 bits")]
        let (every, phase) = (
            ticks.round() as u32,
            (f64::from(wanted.phase_us) * 1e-6 / self.make.period).round() as u32,
        );
        self.samples.packing = packing;
        self.every = (0 < every).then_some((every, every + phase));
        Ok(Nothing)
    }

    fn disarm(&mut self, from_us: u64) -> Result<Disarmed, Status> {
        let nonce = self.interlock.disarm(from_us).ok_or(Status::WrongState)?;
        Ok(Disarmed { nonce })
    }

    fn arm(&mut self, wanted: Arm) -> Result<Nothing, Status> {
        let packing = ForcePacking::new(wanted.packing).ok_or(Status::BadValue)?;
        if !(SHORTEST_VALID_MS..=LONGEST_VALID_MS).contains(&wanted.valid_ms) {
            return Err(Status::BadValue);
        }
        let valid_us = u64::from(wanted.valid_ms) * 1_000;
        self.interlock.arm(wanted.nonce, valid_us).map_err(|why| match why {
            NotArmed::NotDisarmed => Status::WrongState,
            NotArmed::WrongNonce => Status::WrongNonce,
        })?;
        self.forces.packing = packing;
        self.forget_forces();
        self.requests.note(self.clock_us(), "armed");
        Ok(Nothing)
    }

    fn read_config(&self, wanted: ReadConfig) -> Result<Config, Status> {
        let value = self.requests.settings.get(usize::from(wanted.setting));
        let value = *value.ok_or(Status::BadValue)?;
        Ok(Config { value, config_crc: self.requests.config_crc() })
    }

    fn write_config(&mut self, wanted: WriteConfig) -> Result<Config, Status> {
        let WriteConfig { setting, value } = wanted;
        let possible = match setting {
            setting::BOARD => 0..=i32::from(BoardId::MAX.number()),
            setting::FIRST_KEY => 0..=i32::from(KeyIndex::HIGHEST.number()),
            _ => 1..=i32::from(i16::MAX),
        };
        if !possible.contains(&value) {
            return Err(Status::BadValue);
        }
        let place = self.requests.settings.get_mut(usize::from(setting)).ok_or(Status::BadValue)?;
        *place = value;
        Ok(Config { value, config_crc: self.requests.config_crc() })
    }

    fn read_calibration(&self, wanted: ReadCalibration) -> Result<KeyCalibration, Status> {
        let slot = usize::from(wanted.slot);
        if self.make.n_keys <= slot {
            return Err(Status::BadValue);
        }
        self.requests.calibration[slot].ok_or(Status::Impossible)
    }

    fn write_calibration(&mut self, wanted: KeyCalibration) -> Result<Nothing, Status> {
        let slot = usize::from(wanted.slot);
        if self.make.n_keys <= slot {
            return Err(Status::BadValue);
        }
        self.requests.calibration[slot] = Some(wanted);
        Ok(Nothing)
    }

    fn read_log(&self, wanted: ReadLog) -> Result<LogLine, Status> {
        let line = self.requests.log.get(usize::from(wanted.line)).ok_or(Status::BadValue)?;
        let lines = u16::try_from(self.requests.log.len()).unwrap_or(u16::MAX);
        Ok(LogLine { lines, ..*line })
    }

    fn light(&mut self, wanted: Light) -> Nothing {
        self.requests.light_until_us = self.now_us() + u64::from(wanted.seconds) * 1_000_000;
        self.requests.note(self.clock_us(), "light");
        Nothing
    }

    /// Tells whether the light that shows which board it is burns.
    pub fn is_lit(&self) -> bool {
        self.requests.is_lit(self.now_us())
    }

    fn counters(&self) -> Counters {
        let it = self.counts();
        let count = |value: u64| u32::try_from(value).unwrap_or(u32::MAX);
        let short = |value: u64| u16::try_from(value).unwrap_or(u16::MAX);
        Counters {
            samples: count(it.samples),
            forces: count(it.forces),
            corrupt: count(it.corrupt),
            refused: count(it.refused + it.unarmed),
            stale: count(it.stale),
            unanswered: count(it.unanswered),
            trips: short(it.trips),
            armings: short(it.armings),
            oldest_us: count(it.oldest_us),
            unsent: count(it.unsent),
        }
    }

    fn finger(&mut self, wanted: Finger) -> Result<Nothing, Status> {
        let now_us = self.now_us();
        let key = self.keys.get_mut(usize::from(wanted.slot)).ok_or(Status::BadValue)?;
        let touch = match wanted.touch {
            finger::FORGET => {
                key.play(Vec::new());
                return Ok(Nothing);
            }
            finger::PRESSED => Touch::Pressed,
            finger::STRUCK => Touch::Struck,
            _ => return Err(Status::BadValue),
        };
        let seconds = |us: u32| whole(now_us, us) as f64 * 1e-6;
        key.add(Gesture {
            start: seconds(wanted.start_us),
            release: seconds(wanted.release_us),
            touch,
            speed: f64::from(wanted.speed) * 1e-6,
            hold: f64::from(wanted.hold) * 1e-6,
            from: f64::from(wanted.from) * 1e-6,
            lift: if wanted.lift == 0 { Gesture::LIFT } else { f64::from(wanted.lift) * 1e-6 },
        });
        Ok(Nothing)
    }
}

/// Returns the whole time (us) near `now_us` whose low half is `low`.
fn whole(now_us: u64, low: u32) -> u64 {
    let [a, b, c, d, ..] = now_us.to_le_bytes();
    let ahead = low.wrapping_sub(u32::from_le_bytes([a, b, c, d])).cast_signed();
    now_us.saturating_add_signed(ahead.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clock_s_low_half_is_near_now_on_either_side_of_the_wrap() {
        let wrap = 1_u64 << 32;
        assert_eq!(whole(wrap - 10, 5), wrap + 5);
        assert_eq!(whole(wrap + 5, u32::MAX - 9), wrap - 10);
        assert_eq!(whole(7, 7), 7);
    }
}
