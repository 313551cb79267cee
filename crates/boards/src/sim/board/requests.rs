//! Answers of a simulated board to requests.

use crate::links::Link;
use firmware_protocol::acyclic::arm::{Arm, Disarmed, LONGEST_VALID_MS, SHORTEST_VALID_MS};
use firmware_protocol::acyclic::calibration::{KeyCalibration, ReadCalibration};
use firmware_protocol::acyclic::config::{self, Config, ReadConfig, WriteConfig, setting};
use firmware_protocol::acyclic::finger::{self, Finger};
use firmware_protocol::acyclic::health::{
    BoardHealth, KeyHealth, MuteKey, NOT_MEASURED, ReadKeyHealth, key_fault,
};
use firmware_protocol::acyclic::log::{LogLine, ReadLog};
use firmware_protocol::acyclic::{AcyclicRequest, BoardOperations, Status, answer};
use firmware_protocol::frame::hello::{Hello, safe_reason};
use firmware_protocol::key::{BoardId, KeyIndex, MOST_KEYS};
use firmware_protocol::{
    MAX_FRAME, Nothing, acyclic::bootloader::Bootloader, acyclic::counters::Counters,
    acyclic::light::Light, acyclic::ping::Pong, acyclic::stream::Stream,
    frame::key_forces::ForcePacking, frame::key_samples::SamplePacking,
};
use haptics::plant::{Gesture, Touch};

use super::{BoardMake, FakeIdentity, SimulatedBoard};
use crate::sim::force_interlock::NotArmed;

const LOG: usize = 32;

#[derive(Clone, Debug)]
pub(super) struct BoardRequestHandler {
    settings: [i32; setting::COUNT as usize],
    calibration: [Option<KeyCalibration>; MOST_KEYS],
    log: Vec<LogLine>,
    /// Number and operation of the last request, and its reply, in case it is repeated.
    last: Option<((u8, u8), [u8; MAX_FRAME], usize)>,
    asked_us: u64,
    light_until_us: u64,
    boots: u32,
    /// Keys whose motors are off, the first in bit 0.
    muted: u16,
}

impl BoardRequestHandler {
    pub(super) fn new(make: BoardMake) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "a motor's force")]
        let limit = (make.rig.motor.limit * 1e3) as i32;
        Self {
            settings: [make.id.number().into(), make.first_key.into(), limit],
            calibration: [None; MOST_KEYS],
            log: Vec::with_capacity(LOG),
            last: None,
            asked_us: 0,
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

    pub(super) const fn keep_settings(&mut self, before: &Self) {
        self.settings = before.settings;
        self.boots = before.boots.saturating_add(1);
    }

    pub(super) const fn muted(&self) -> u16 {
        self.muted
    }

    pub(super) fn max_force_mn(&self) -> u16 {
        let [_number, _first_key, limit] = self.settings;
        u16::try_from(limit).unwrap_or(u16::MAX)
    }

    pub(super) fn config_crc(&self) -> u32 {
        config::crc(&self.settings)
    }

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

impl SimulatedBoard {
    /// Answers a request; a repeated one is answered again and not done again.
    ///
    /// The request holds from `from_us` on; times in the reply are of the clock.
    pub(super) fn serve(&mut self, from_us: u64, frame: &[u8], link: &mut impl Link) {
        let Ok(request) = AcyclicRequest::decode(frame) else {
            self.counts.refused += 1;
            return;
        };
        let operation = request.operation.map_or_else(|it| it, |it| it as u8);
        // A host that restarts may send the same number with another operation.
        let this = (request.id, operation);
        match self.requests.last {
            Some((last, bytes, len)) if last == this => self.send(&bytes[..len], link),
            Some(_) | None => {
                let mut bytes = [0; MAX_FRAME];
                self.requests.asked_us = from_us;
                let len = answer(self, &request, &mut bytes);
                self.requests.last = Some((this, bytes, len));
                self.send(&bytes[..len], link);
            }
        }
    }

    pub fn is_lit(&self) -> bool {
        self.requests.is_lit(self.now_us())
    }
}

impl BoardOperations for SimulatedBoard {
    fn hello(&mut self, _request: Nothing) -> Result<Hello, Status> {
        Ok(self.introduction().hello)
    }

    fn ping(&mut self, _request: Nothing) -> Result<Pong, Status> {
        Ok(Pong { board_us: self.clock_us() })
    }

    fn bootloader(&mut self, _request: Bootloader) -> Result<Nothing, Status> {
        Err(Status::Impossible)
    }

    fn board_health(&mut self, _request: Nothing) -> Result<BoardHealth, Status> {
        let BoardRequestHandler { boots, muted, .. } = self.requests;
        // The simulated fault names no key, so it is reported for slot 0.
        let faults = u16::from(self.safe_reason() == safe_reason::KEY_FAULT);
        Ok(BoardHealth { boots, homed: !(u16::MAX << self.make.n_keys), faults, muted })
    }

    fn key_health(&mut self, request: ReadKeyHealth) -> Result<KeyHealth, Status> {
        /// Force of the motor per current (N/A).
        const NEWTONS_PER_AMPERE: f64 = 10.0;
        let slot = usize::from(request.slot);
        let newtons = self.rig(slot).ok_or(Status::BadValue)?.motor_force();
        let has_failed = slot == 0 && self.safe_reason() == safe_reason::KEY_FAULT;
        let fault = if has_failed { key_fault::OTHER } else { key_fault::NONE };
        #[expect(clippy::cast_possible_truncation, reason = "saturates")]
        let current = (newtons / NEWTONS_PER_AMPERE * 1e3) as i16;
        Ok(KeyHealth { fault, temperature: NOT_MEASURED, current })
    }

    fn mute_key(&mut self, request: MuteKey) -> Result<Nothing, Status> {
        let MuteKey { slot, muted } = request;
        if self.make.n_keys <= usize::from(slot) || 1 < muted {
            return Err(Status::BadValue);
        }
        let others = self.requests.muted & !(1 << slot);
        self.requests.muted = others | u16::from(muted) << slot;
        Ok(Nothing)
    }

    fn stream(&mut self, request: Stream) -> Result<Nothing, Status> {
        let packing = SamplePacking::new(request.packing).ok_or(Status::BadValue)?;
        let ticks = f64::from(request.period_us) * 1e-6 / self.make.period;
        // A board can send at its own ticks only.
        if 1e-6 < (ticks - ticks.round()).abs() {
            return Err(Status::BadValue);
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "16 bits")]
        let (every, phase) = (
            ticks.round() as u32,
            (f64::from(request.phase_us) * 1e-6 / self.make.period).round() as u32,
        );
        self.samples.packing = packing;
        self.every = (0 < every).then_some((every, every + phase));
        Ok(Nothing)
    }

    fn disarm(&mut self, _request: Nothing) -> Result<Disarmed, Status> {
        let nonce = self.interlock.disarm(self.requests.asked_us).ok_or(Status::WrongState)?;
        Ok(Disarmed { nonce })
    }

    fn arm(&mut self, request: Arm) -> Result<Nothing, Status> {
        let packing = ForcePacking::new(request.packing).ok_or(Status::BadValue)?;
        if !(SHORTEST_VALID_MS..=LONGEST_VALID_MS).contains(&request.valid_ms) {
            return Err(Status::BadValue);
        }
        let valid_us = u64::from(request.valid_ms) * 1_000;
        self.interlock.arm(request.nonce, valid_us).map_err(|why| match why {
            NotArmed::NotDisarmed => Status::WrongState,
            NotArmed::WrongNonce => Status::WrongNonce,
        })?;
        self.forces.packing = packing;
        self.forget_forces();
        self.requests.note(self.clock_us(), "armed");
        Ok(Nothing)
    }

    fn read_config(&mut self, request: ReadConfig) -> Result<Config, Status> {
        let value = self.requests.settings.get(usize::from(request.setting));
        let value = *value.ok_or(Status::BadValue)?;
        Ok(Config { value, config_crc: self.requests.config_crc() })
    }

    fn write_config(&mut self, request: WriteConfig) -> Result<Config, Status> {
        let WriteConfig { setting, value } = request;
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

    fn read_calibration(&mut self, request: ReadCalibration) -> Result<KeyCalibration, Status> {
        let slot = usize::from(request.slot);
        if self.make.n_keys <= slot {
            return Err(Status::BadValue);
        }
        self.requests.calibration[slot].ok_or(Status::Impossible)
    }

    fn write_calibration(&mut self, request: KeyCalibration) -> Result<Nothing, Status> {
        let slot = usize::from(request.slot);
        if self.make.n_keys <= slot {
            return Err(Status::BadValue);
        }
        self.requests.calibration[slot] = Some(request);
        Ok(Nothing)
    }

    fn read_log(&mut self, request: ReadLog) -> Result<LogLine, Status> {
        let line = self.requests.log.get(usize::from(request.line)).ok_or(Status::BadValue)?;
        let lines = u16::try_from(self.requests.log.len()).unwrap_or(u16::MAX);
        Ok(LogLine { lines, ..*line })
    }

    fn light(&mut self, request: Light) -> Result<Nothing, Status> {
        self.requests.light_until_us = self.now_us() + u64::from(request.seconds) * 1_000_000;
        self.requests.note(self.clock_us(), "light");
        Ok(Nothing)
    }

    fn counters(&mut self, _request: Nothing) -> Result<Counters, Status> {
        let it = self.counts();
        let count = |value: u64| u32::try_from(value).unwrap_or(u32::MAX);
        let short = |value: u64| u16::try_from(value).unwrap_or(u16::MAX);
        Ok(Counters {
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
        })
    }

    fn finger(&mut self, request: Finger) -> Result<Nothing, Status> {
        let now_us = self.now_us();
        let key = self.keys.get_mut(usize::from(request.slot)).ok_or(Status::BadValue)?;
        let touch = match request.touch {
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
            start: seconds(request.start_us),
            release: seconds(request.release_us),
            touch,
            speed: f64::from(request.speed) * 1e-6,
            hold: f64::from(request.hold) * 1e-6,
            from: f64::from(request.from) * 1e-6,
            lift: if request.lift == 0 { Gesture::LIFT } else { f64::from(request.lift) * 1e-6 },
        });
        Ok(Nothing)
    }
}

/// Returns the whole time (us) near `now_us` with the low half `low`.
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
