//! A simulated board: eleven keys behind one link, with a watchdog of its own.

use firmware_protocol::frame::Header;
use firmware_protocol::frame::key_forces::KeyForces;
use firmware_protocol::frame::key_samples::{self, KeySamples};
use firmware_protocol::key::{BoardId, KEYS_PER_BOARD, PerKey};
use firmware_protocol::quantity::Millinewtons;
use firmware_protocol::sequence::Sequence;
use firmware_protocol::serial::{self, Deframer, MAX_WIRE};
use haptics::plant::{Gesture, KeyRig, RigParameters};

use super::key::{Plant, Progress};
use super::watchdog::{SILENCE, Watchdog};
use crate::Error;
use crate::calibration::{self, KeyCalibration};
use crate::link::Link;
use crate::rt::loss::Loss;

/// Frames taken from the link in one tick; the rest waits for the next.
const MAX_FRAMES: usize = 16;

/// What a board refused or could not do.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct BoardFaults {
    /// Pieces of the stream that were no frames.
    pub corrupt: u64,
    /// Whole frames that were not for this board, or not to be understood.
    pub refused: u64,
    /// Forces that answered samples older than 20 ms.
    pub stale: u64,
    /// Times that the watchdog tripped.
    pub trips: u64,
    /// Sample frames that the link did not take.
    pub unsent: u64,
}

/// A board with its keys, motors, encoders and clock.
#[derive(Clone, Debug)]
pub struct SimulatedBoard {
    id: BoardId,
    progress: Progress,
    keys: Vec<Plant>,
    forces: PerKey<Millinewtons>,
    watchdog: Watchdog,
    deframer: Deframer,
    loss: Loss,
    sequence: Sequence,
    /// The tick at whose start the newest samples were sent.
    reported: Option<u64>,
    faults: BoardFaults,
}

impl SimulatedBoard {
    /// A board of keys at rest, in ticks of `period` [s].
    ///
    /// # Errors
    /// Refuses a period that is not above 0 and up to 1 s.
    pub fn new(id: BoardId, period: f64, rig: RigParameters) -> Result<Self, Error> {
        Ok(Self {
            id,
            progress: Progress::new(period)?,
            keys: (0..KEYS_PER_BOARD).map(|_| Plant::new(rig)).collect(),
            forces: PerKey::collect([Millinewtons::default(); KEYS_PER_BOARD]),
            watchdog: Watchdog::new(period),
            deframer: Deframer::default(),
            loss: Loss::default(),
            sequence: Sequence::default(),
            reported: None,
            faults: BoardFaults::default(),
        })
    }

    /// Plays `gestures` on the key in `slot` from now on instead of those before.
    pub fn play(&mut self, slot: usize, gestures: Vec<Gesture>) {
        if let Some(key) = self.keys.get_mut(slot) {
            key.play(gestures);
        }
    }

    /// Lives through the ticks up to the start of `tick`, then says where its keys are.
    ///
    /// At the start of each tick it takes the newest forces, at the end of each it sends its
    /// samples. The first call only sends.
    ///
    /// # Real-time
    /// At most 256 ticks of 11 plants and 16 frames; no heap.
    pub fn advance(&mut self, tick: u64, link: &mut impl Link) {
        for step in self.progress.go_on(tick) {
            self.listen(step, link);
            self.step(step);
            self.report(step + 1, link);
        }
        // At the first call, and after ticks that were not made up.
        if self.reported < Some(tick) {
            self.report(tick, link);
        }
    }

    /// Whether the watchdog has tripped and the board was not armed since.
    pub const fn is_safe(&self) -> bool {
        self.watchdog.is_safe()
    }

    /// Leaves the safe state without force; the next valid forces are taken again.
    pub fn rearm(&mut self) {
        self.watchdog.rearm();
        self.loss.forget();
        self.forces = PerKey::collect([Millinewtons::default(); KEYS_PER_BOARD]);
    }

    /// What was refused or went wrong.
    pub const fn faults(&self) -> BoardFaults {
        self.faults
    }

    /// The plant in `slot`, with what no sensor tells.
    pub fn rig(&self, slot: usize) -> Option<&KeyRig> {
        self.keys.get(slot).map(Plant::rig)
    }

    /// How the encoders of this board read.
    pub fn calibration(&self) -> impl Iterator<Item = KeyCalibration> {
        self.keys.iter().map(Plant::calibration)
    }

    /// Takes the forces that have come until the start of `tick`.
    fn listen(&mut self, tick: u64, link: &mut impl Link) {
        for _ in 0..MAX_FRAMES {
            let mut piece = [0; MAX_WIRE];
            let Ok(Some(len)) = link.try_recv(&mut piece) else { return };
            for byte in piece.get(..len).unwrap_or_default() {
                self.hear(tick, *byte);
            }
        }
    }

    /// Takes the next byte of the stream, and the frame that it completes.
    fn hear(&mut self, tick: u64, byte: u8) {
        let frame = self.deframer.push(byte).map(|frame| frame.map(KeyForces::decode));
        match frame {
            None => {}
            Some(Err(_framing)) => self.faults.corrupt += 1,
            Some(Ok(Ok(frame))) if self.is_whole(&frame) => self.take(tick, &frame),
            Some(Ok(_foreign)) => self.faults.refused += 1,
        }
    }

    /// Whether a frame is for this board, and for all of its keys.
    fn is_whole(&self, frame: &KeyForces) -> bool {
        frame.header.board == self.id && frame.forces.as_slice().len() == KEYS_PER_BOARD
    }

    /// Takes forces that are newer than those before and answer something recent.
    fn take(&mut self, tick: u64, frame: &KeyForces) {
        if !self.loss.accept(frame.header.sequence, tick) {
            return;
        }
        let age_us = self.stamp_us(tick).wrapping_sub(frame.header.stamp_us);
        if SILENCE * 1e6 < f64::from(age_us) {
            self.faults.stale += 1;
        } else if self.watchdog.feed() {
            let silent = PerKey::collect([Millinewtons::default(); KEYS_PER_BOARD]);
            self.forces = if frame.header.fault { silent } else { frame.forces };
        }
    }

    /// Advances the keys over `tick`.
    fn step(&mut self, tick: u64) {
        let was_safe = self.is_safe();
        let share = self.watchdog.tick();
        self.faults.trips += u64::from(self.is_safe() && !was_safe);
        let (t, h) = (self.progress.seconds(tick), self.progress.period());
        for (key, force) in self.keys.iter_mut().zip(self.forces.as_slice()) {
            key.advance(t, h, share * calibration::newtons(*force));
        }
    }

    /// Sends where the keys are at the start of `tick`.
    fn report(&mut self, tick: u64, link: &mut impl Link) {
        self.reported = Some(tick);
        let header = Header {
            board: self.id,
            sequence: self.sequence,
            stamp_us: self.stamp_us(tick),
            fault: self.is_safe(),
        };
        self.sequence = self.sequence.next();
        let positions = PerKey::collect(self.keys.iter().map(Plant::counts));
        let (mut bytes, mut wire) = ([0; key_samples::MAX_LEN], [0; MAX_WIRE]);
        let len = KeySamples { header, positions }.encode(&mut bytes);
        let sent = serial::encode(&bytes[..len], &mut wire)
            .is_ok_and(|len| link.try_send(&wire[..len]).is_ok());
        self.faults.unsent += u64::from(!sent);
    }

    /// The board's clock at the start of `tick` [us].
    fn stamp_us(&self, tick: u64) -> u16 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "time is positive, and the clock wraps"
        )]
        let stamp = (self.progress.seconds(tick) * 1e6).round() as u64 as u16;
        stamp
    }
}
