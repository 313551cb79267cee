//! The host's end of all boards: samples in, forces out, once a tick.
//!
//! ```text
//! begin(tick)                       every sample grows older
//! for each board  receive(link)     bytes → frames → what is newer → metres
//! samples()                         to the voices
//! for each board  send(link)        newtons → a frame → bytes
//! ```
//!
//! Ages count from arrival: what a constant delay adds, only a model of the boards' clocks
//! could tell.

use firmware_protocol::frame::Header;
use firmware_protocol::frame::key_forces::{self, KeyForces};
use firmware_protocol::frame::key_samples::KeySamples;
use firmware_protocol::key::{BOARDS, BoardId, PerKey};
use firmware_protocol::sequence::Sequence;
use firmware_protocol::serial::{self, Deframer, MAX_WIRE};
use scheduler::motion::{KEYS, KeySample};

use super::loss::{Loss, LossCounts};
use crate::calibration::{self, KeyCalibration};
use crate::link::Link;

/// Pieces taken from one link in one tick; the rest waits for the next.
const MAX_PIECES: usize = 64;

/// Age of a sample that was never taken.
pub const NEVER: u32 = u32::MAX;

/// What one board's link has carried, and what it has lost.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct BoardStatistics {
    /// Counts over the sequence numbers of its samples.
    pub samples: LossCounts,
    /// Pieces of the stream that were no frames: checksum, stuffing or length.
    pub corrupt: u64,
    /// Whole frames that were refused: version, class, board or content.
    pub refused: u64,
    /// Receptions that the link refused.
    pub receive_errors: u64,
    /// Force frames that the link took.
    pub sent: u64,
    /// Force frames that it did not take, or that had no samples to answer.
    pub unsent: u64,
    /// The board's newest frame said that it has a fault latched.
    pub fault: bool,
}

/// The host's end of the boards, with the newest sample of every key.
#[derive(Clone, Debug)]
pub struct Bus {
    tick: Option<u64>,
    calibration: [KeyCalibration; KEYS],
    samples: [KeySample; KEYS],
    boards: [BoardEnd; BOARDS],
}

/// What the host remembers of one board.
#[derive(Clone, Debug, Default)]
struct BoardEnd {
    deframer: Deframer,
    loss: Loss,
    statistics: BoardStatistics,
    sequence: Sequence,
    /// Board time of the newest samples [us]: what the next forces answer.
    stamp_us: Option<u16>,
}

impl Bus {
    /// A bus that has not heard of any board: all keys up, samples never taken.
    pub fn new(calibration: [KeyCalibration; KEYS]) -> Self {
        Self {
            tick: None,
            calibration,
            samples: [KeySample { position: 0.0, age: NEVER }; KEYS],
            boards: std::array::from_fn(|_| BoardEnd::default()),
        }
    }

    /// Starts `tick`: every sample is older by the ticks that have passed.
    ///
    /// # Real-time
    /// One addition for each key.
    pub fn begin(&mut self, tick: u64) {
        let passed = self.tick.map_or(0, |last| tick.saturating_sub(last));
        let passed = u32::try_from(passed).unwrap_or(u32::MAX);
        self.tick = Some(tick);
        for sample in &mut self.samples {
            sample.age = sample.age.saturating_add(passed);
        }
    }

    /// Takes what has come from `board`.
    ///
    /// # Real-time
    /// At most 64 receptions of 68 bytes; no heap.
    pub fn receive(&mut self, board: BoardId, link: &mut (impl Link + ?Sized)) {
        for _ in 0..MAX_PIECES {
            let mut piece = [0; MAX_WIRE];
            match link.try_recv(&mut piece) {
                Ok(Some(len)) => self.read(board, piece.get(..len).unwrap_or_default()),
                Ok(None) => return,
                Err(_lost) => {
                    self.boards[board.index()].statistics.receive_errors += 1;
                    return;
                }
            }
        }
    }

    /// The newest sample of every key.
    pub const fn samples(&self) -> &[KeySample; KEYS] {
        &self.samples
    }

    /// Sends `board` its share of the forces [N, up positive].
    ///
    /// A board that was never heard is sent nothing: there is nothing to answer.
    ///
    /// # Real-time
    /// One frame; no heap.
    pub fn send(&mut self, board: BoardId, forces: &[f64; KEYS], link: &mut (impl Link + ?Sized)) {
        let end = &mut self.boards[board.index()];
        let sent = end.frame(board, &forces[board.keys()]).is_some_and(|(wire, len)| {
            // A link that is down has lost this frame; the next one makes it worthless.
            link.try_send(&wire[..len]).is_ok()
        });
        end.statistics.sent += u64::from(sent);
        end.statistics.unsent += u64::from(!sent);
    }

    /// What the link of `board` has carried and lost.
    pub const fn statistics(&self, board: BoardId) -> BoardStatistics {
        let end = &self.boards[board.index()];
        BoardStatistics { samples: end.loss.counts(), ..end.statistics }
    }

    /// Finds frames in what came from `board`, and takes over the newest.
    fn read(&mut self, board: BoardId, piece: &[u8]) {
        let tick = self.tick.unwrap_or_default();
        let end = &mut self.boards[board.index()];
        let news = piece.iter().filter_map(|byte| end.hear(*byte, board, tick)).last();
        let Some(frame) = news else { return };
        let keys = board.keys();
        let places = self.samples[keys.clone()].iter_mut().zip(&self.calibration[keys]);
        for ((sample, calibration), counts) in places.zip(frame.positions.as_slice()) {
            *sample = KeySample { position: calibration.position(*counts), age: 0 };
        }
    }
}

impl BoardEnd {
    /// Takes the next byte of `board`'s stream; returns samples that are news.
    fn hear(&mut self, byte: u8, board: BoardId, tick: u64) -> Option<KeySamples> {
        match self.deframer.push(byte)?.map(KeySamples::decode) {
            Err(_framing) => self.statistics.corrupt += 1,
            Ok(Ok(frame)) if frame.header.board == board => return self.take(frame, tick),
            Ok(_foreign) => self.statistics.refused += 1,
        }
        None
    }

    /// Returns `frame` if it is newer than all before.
    fn take(&mut self, frame: KeySamples, tick: u64) -> Option<KeySamples> {
        self.loss.accept(frame.header.sequence, tick).then(|| {
            self.stamp_us = Some(frame.header.stamp_us);
            self.statistics.fault = frame.header.fault;
            frame
        })
    }

    /// The next force frame as it goes on the wire, and its length.
    fn frame(&mut self, board: BoardId, forces: &[f64]) -> Option<([u8; MAX_WIRE], usize)> {
        let stamp_us = self.stamp_us?;
        let header = Header { board, sequence: self.sequence, stamp_us, fault: false };
        self.sequence = self.sequence.next();
        let forces = PerKey::collect(forces.iter().copied().map(calibration::millinewtons));
        let (mut bytes, mut wire) = ([0; key_forces::MAX_LEN], [0; MAX_WIRE]);
        let len = KeyForces { header, forces }.encode(&mut bytes);
        let len = serial::encode(&bytes[..len], &mut wire).ok()?;
        Some((wire, len))
    }
}
