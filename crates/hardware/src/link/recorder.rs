//! Writes down what passes over a link: by whom, when, and what.
//!
//! ```text
//! (12.003000) < 630000003412        the other end said this, 12.003 s after the start
//! (12.003000) > 230000000001        this end said that
//! ! 3                               three frames went by here while there was no room
//! # anything                        a remark
//! ```
//!
//! The tick puts frames into a ring, whose memory was taken before; another thread takes them
//! out and writes them. [`super::replay`] plays the file back.

use std::io::{self, Write};

use firmware_protocol::MAX_FRAME;

use super::faulty::Direction;
use super::{Health, Link, Parcel, RecvError, SendError};

/// A frame that passed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// When, by the owner's clock (us).
    pub(super) time_us: u64,
    /// Which way, from the end that is recorded.
    pub(super) direction: Direction,
    pub(super) parcel: Parcel,
    /// Frames that went by unrecorded since the entry before.
    lost: u64,
}

/// The tick's side of a recording.
#[derive(Debug)]
pub struct Tape {
    ring: rtrb::Producer<Entry>,
    time_us: u64,
    /// Frames that went by since the last one that found room.
    lost: u64,
    dropped: u64,
}

/// The other side, which writes.
#[derive(Debug)]
pub struct Recording {
    ring: rtrb::Consumer<Entry>,
}

impl Tape {
    /// A tape that holds `capacity` frames until they are written.
    pub fn new(capacity: usize) -> (Self, Recording) {
        let (producer, consumer) = rtrb::RingBuffer::new(capacity);
        let tape = Self { ring: producer, time_us: 0, lost: 0, dropped: 0 };
        (tape, Recording { ring: consumer })
    }

    /// What time it is for the frames that follow (us).
    pub const fn set_time(&mut self, time_us: u64) {
        self.time_us = time_us;
    }

    /// Frames that were not recorded, because there was no room.
    pub const fn dropped(&self) -> u64 {
        self.dropped
    }

    /// Records what passes over `link`.
    pub const fn around<L: Link>(&mut self, link: L) -> Recorded<'_, L> {
        Recorded { tape: self, link }
    }

    /// # Real-time
    /// One copy of about 100 bytes into a ring; no lock, no heap.
    fn record(&mut self, direction: Direction, parcel: Parcel) {
        if MAX_FRAME < parcel.len {
            return;
        }
        let entry = Entry { time_us: self.time_us, direction, parcel, lost: self.lost };
        if self.ring.push(entry).is_ok() {
            self.lost = 0;
        } else {
            self.lost += 1;
            self.dropped += 1;
        }
    }
}

impl Recording {
    /// Writes what has passed so far; returns how many frames. Not for the tick.
    ///
    /// # Errors
    /// `out` cannot be written; the frame that it did not take is lost.
    pub fn save(&mut self, out: &mut impl Write) -> io::Result<usize> {
        let mut n = 0;
        // What is put in while this writes waits for the next time.
        for _ in 0..self.ring.slots() {
            let Ok(entry) = self.ring.pop() else { break };
            entry.write(out)?;
            n += 1;
        }
        Ok(n)
    }
}

impl Entry {
    fn write(&self, out: &mut impl Write) -> io::Result<()> {
        if 0 < self.lost {
            writeln!(out, "! {}", self.lost)?;
        }
        let sign = match self.direction {
            Direction::Send => '>',
            Direction::Receive => '<',
        };
        let (seconds, micros) = (self.time_us / 1_000_000, self.time_us % 1_000_000);
        write!(out, "({seconds}.{micros:06}) {sign} ")?;
        for byte in self.parcel.as_slice() {
            write!(out, "{byte:02X}")?;
        }
        writeln!(out)
    }
}

/// A link that is recorded.
///
/// What is sent is recorded whether the link takes it or not: a replay asks what this end
/// said. Of what is received, frames are recorded, also those that a buffer was too short for,
/// and failures are not. What is longer than any frame is never recorded.
#[derive(Debug)]
pub struct Recorded<'a, L> {
    tape: &'a mut Tape,
    link: L,
}

impl<L: Link> Link for Recorded<'_, L> {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        if let Ok(parcel) = Parcel::new(frame) {
            self.tape.record(Direction::Send, parcel);
        }
        self.link.try_send(frame)
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        let mut parcel = Parcel::EMPTY;
        let Some(len) = self.link.try_recv(&mut parcel.bytes)? else { return Ok(None) };
        parcel.len = len;
        self.tape.record(Direction::Receive, parcel);
        parcel.unpack(buffer).map(Some)
    }

    fn health(&self) -> Health {
        self.link.health()
    }
}

/// A link with its tape, as one.
#[derive(Debug)]
pub struct Recorder<L> {
    link: L,
    tape: Tape,
}

impl<L> Recorder<L> {
    /// Records all that passes over `link`; holds `capacity` frames until they are written.
    pub fn new(link: L, capacity: usize) -> (Self, Recording) {
        let (tape, recording) = Tape::new(capacity);
        (Self { link, tape }, recording)
    }

    /// The tape, to set its time.
    pub const fn tape(&mut self) -> &mut Tape {
        &mut self.tape
    }
}

impl<L: Link> Link for Recorder<L> {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        self.tape.around(&mut self.link).try_send(frame)
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        self.tape.around(&mut self.link).try_recv(buffer)
    }

    fn health(&self) -> Health {
        self.link.health()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::link::loopback::Loopback;

    fn text(recording: &mut Recording) -> String {
        let mut out = Vec::new();
        recording.save(&mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn what_passes_is_written_with_its_time_and_direction() {
        let mut wire = Loopback::new(4);
        let (mut tape, mut recording) = Tape::new(4);
        tape.set_time(1_000);
        wire.board_end().try_send(&[0x63, 0, 0xFF]).unwrap();
        let mut host = tape.around(wire.host_end());
        assert_eq!(host.try_recv(&mut [0; 8]), Ok(Some(3)));
        assert_eq!(host.try_recv(&mut [0; 8]), Ok(None));
        tape.set_time(12_003_001);
        tape.around(wire.host_end()).try_send(&[0x23]).unwrap();
        assert_eq!(text(&mut recording), "(0.001000) < 6300FF\n(12.003001) > 23\n");
        assert_eq!(text(&mut recording), "");
    }

    #[test]
    fn what_finds_no_room_is_counted_where_it_is_missing() {
        let (mut recorder, mut recording) = Recorder::new(Loopback::new(9), 1);
        let mut send = |byte| {
            recorder.tape.around(recorder.link.host_end()).try_send(&[byte]).unwrap();
            recorder.tape.dropped()
        };
        assert_eq!([1, 2, 3].map(&mut send), [0, 1, 2]);
        assert_eq!(text(&mut recording), "(0.000000) > 01\n");
        send(4);
        assert_eq!(text(&mut recording), "! 2\n(0.000000) > 04\n");
    }
}
