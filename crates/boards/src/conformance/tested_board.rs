//! One request and its answer; samples, and forces that answer them.

use std::collections::BTreeMap;
use std::time::Duration;

use crate::links::{HostClock, Link, RecvError};
use firmware_protocol::acyclic::arm::{Arm, Disarmed};
use firmware_protocol::acyclic::{AcyclicReply, Operation, Status};
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::hello::Introduction;
use firmware_protocol::frame::key_forces::{self, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::frame::{FrameKind, Header, board_of};
use firmware_protocol::key::{BoardId, PerKey};
use firmware_protocol::quantity::Millinewtons;
use firmware_protocol::version::PROTOCOL_VERSION;
use firmware_protocol::{MAX_FRAME, Nothing, Record};

use super::MOST_FORCE_MN;

/// Time between two looks at what may have come.
const LOOK: Duration = Duration::from_micros(200);
/// Time between two looks that are in time (us).
const IN_TIME_US: u64 = 2_000;
/// Longest time in which an answer that is late is still waited for (us).
const LATE_US: u64 = 250_000;
/// Times that a request is sent with the same id.
const TRIES: u8 = 3;

/// Returns the next whole frame on `link`; what is no frame is passed over.
fn next_frame(link: &mut dyn Link) -> Option<Vec<u8>> {
    let mut frame = [0; MAX_FRAME];
    loop {
        match link.try_recv(&mut frame) {
            Ok(len) => return len.map(|len| frame[..len.min(MAX_FRAME)].to_vec()),
            Err(RecvError::Corrupt | RecvError::BufferTooShort { .. }) => {}
            Err(RecvError::Down) => return None,
        }
    }
}

/// Asks who is on a link for `patience_us`, or until nothing new comes for a third of a second;
/// returns the hellos that can be read, by number.
pub fn introductions(
    link: &mut dyn Link,
    clock: &HostClock,
    patience_us: u64,
) -> Vec<Introduction> {
    const ASK_US: u64 = 100_000;
    const QUIET_US: u64 = 300_000;
    let (start, mut found) = (clock.now_us(), BTreeMap::new());
    let (mut asked, mut news) = (None, start);
    while clock.now_us() < start + patience_us
        && (found.is_empty() || clock.now_us() < news + QUIET_US)
    {
        if asked.is_none_or(|at| at + ASK_US <= clock.now_us()) {
            asked = Some(clock.now_us());
            let mut frame = [0; broadcast::MAX_LEN];
            let len = Broadcast::WhoIsThere { version: PROTOCOL_VERSION }.encode(&mut frame);
            // What is not taken is asked again.
            let _lost = link.try_send(&frame[..len]);
        }
        while let Some(frame) = next_frame(link) {
            if let Ok(it) = Introduction::decode(&frame)
                && found.insert(it.board.number(), it).is_none()
            {
                news = clock.now_us();
            }
        }
        clock.pause(LOOK);
    }
    found.into_values().collect()
}

/// An answer, and how long it took.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct TimedReply {
    pub(super) status: Status,
    pub(super) record: Vec<u8>,
    /// When its request was sent first, and when it came (us).
    pub(super) sent_us: u64,
    pub(super) heard_us: u64,
}

/// Samples that came, and when by the host's clock (us).
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct TimedSamples {
    pub(super) heard_us: u64,
    pub(super) samples: KeySamples,
}

/// A board that is tested.
pub struct TestedBoard<'l> {
    link: &'l mut dyn Link,
    pub(super) number: BoardId,
    clock: HostClock,
    pub(super) layout: SampleLayout,
    next_id: u8,
    /// Frames of samples that could not be read.
    pub(super) unreadable: u32,
    /// Time by which looks at the link were late, since this machine did something else (us).
    pub(super) late_us: u64,
}

impl std::fmt::Debug for TestedBoard<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TestedBoard").field("number", &self.number).finish_non_exhaustive()
    }
}

impl<'l> TestedBoard<'l> {
    /// Returns the board on `link` that said `introduction`.
    pub fn new(link: &'l mut dyn Link, introduction: &Introduction, clock: HostClock) -> Self {
        let n_keys = introduction.hello.n_keys.into();
        let layout = SampleLayout { packing: SamplePacking::Position24, n_keys };
        let [next_id, ..] = clock.now_us().to_le_bytes();
        let number = introduction.board;
        Self { link, number, clock, layout, next_id, unreadable: 0, late_us: 0 }
    }

    pub(super) fn now_us(&self) -> u64 {
        self.clock.now_us()
    }

    /// Returns the next id of a request, which is never 0.
    fn id(&mut self) -> u8 {
        self.next_id = self.next_id.wrapping_add(1).max(1);
        self.next_id
    }

    /// Returns a request of `operation` with `record`, of the next id.
    pub(super) fn request(&mut self, operation: u8, record: &[u8]) -> Vec<u8> {
        let head = (FrameKind::Request as u8) << 5 | self.number.number();
        [&[head, self.id(), operation], record].concat()
    }

    /// Sends `request`, and waits for its answer; it is sent again if none comes.
    pub(super) fn exchange(&mut self, request: &[u8]) -> Option<TimedReply> {
        let sent_us = self.now_us();
        for attempt in 1..=u64::from(TRIES) {
            let _lost = self.link.try_send(request);
            let reply = self.wait(request, sent_us, sent_us + attempt * LATE_US);
            if reply.is_some() {
                return reply;
            }
        }
        None
    }

    /// Waits until `end_us` for the answer to `request`, which was sent at `sent_us`.
    fn wait(&mut self, request: &[u8], sent_us: u64, end_us: u64) -> Option<TimedReply> {
        while self.now_us() < end_us {
            if let Some(reply) = self.reply_to(request, sent_us) {
                return Some(reply);
            }
            self.clock.pause(LOOK);
        }
        None
    }

    /// Returns the answer to `request` if it has come.
    fn reply_to(&mut self, request: &[u8], sent_us: u64) -> Option<TimedReply> {
        while let Some(frame) = next_frame(self.link) {
            let Ok(AcyclicReply { board, status, record, .. }) = AcyclicReply::decode(&frame)
            else {
                continue;
            };
            if board == self.number && frame.get(1..3) == request.get(1..3) {
                let heard_us = self.now_us();
                return Some(TimedReply { status, record: record.to_vec(), sent_us, heard_us });
            }
        }
        None
    }

    /// Asks for `operation` by its number, with `record`.
    pub(super) fn ask_raw(&mut self, operation: u8, record: &[u8]) -> Option<TimedReply> {
        let request = self.request(operation, record);
        self.exchange(&request)
    }

    /// Returns how `operation` with `record` is answered, as a status or in words.
    pub(super) fn status<Q: Record>(
        &mut self,
        operation: Operation,
        record: &Q,
    ) -> Result<Status, String> {
        let mut bytes = [0; MAX_FRAME];
        let len = record.put(&mut bytes).unwrap_or_default();
        let reply = self.ask_raw(operation as u8, &bytes[..len]);
        reply.map(|it| it.status).ok_or_else(|| format!("{operation:?} was not answered"))
    }

    /// Returns the record with which `operation` is answered, or what is answered instead.
    pub(super) fn get<A: Record>(&mut self, operation: Operation) -> Result<A, String> {
        self.get_with(operation, &Nothing)
    }

    pub(super) fn get_with<Q: Record, A: Record>(
        &mut self,
        operation: Operation,
        record: &Q,
    ) -> Result<A, String> {
        let mut bytes = [0; MAX_FRAME];
        let len = record.put(&mut bytes).unwrap_or_default();
        let reply = self.ask_raw(operation as u8, &bytes[..len]);
        let reply = reply.ok_or_else(|| format!("{operation:?} was not answered"))?;
        if reply.status != Status::Done {
            return Err(format!("{operation:?} was answered with {:?}", reply.status));
        }
        let short = || format!("the answer to {operation:?} has {} bytes", reply.record.len());
        A::take(&reply.record).ok_or_else(short)
    }

    /// Sends a damaged request, and says whether it is answered all the same; nothing on a link
    /// whose checksums are not ours.
    pub(super) fn answers_damaged(&mut self) -> Option<bool> {
        let mut request = self.request(Operation::Ping as u8, &[]);
        request[1] = 0x15;
        let _lost = self.link.try_send_damaged(&request)?;
        // The id with the inverted bit is what a board that does not check answers.
        request[1] ^= 0x40;
        let sent_us = self.now_us();
        Some(self.wait(&request, sent_us, sent_us + LATE_US).is_some())
    }

    /// Tells all boards to stop.
    pub(super) fn stop(&mut self) {
        let mut frame = [0; broadcast::MAX_LEN];
        let len = Broadcast::EmergencyStop { reason: 1 }.encode(&mut frame);
        let _lost = self.link.try_send(&frame[..len]);
    }

    /// Listens for `for_us`, and answers each frame of samples as `answer` says, with the same
    /// force (mN) on all keys.
    pub(super) fn listen(
        &mut self,
        for_us: u64,
        answer: impl Fn(&KeySamples) -> Option<(Header, i32)>,
    ) -> Vec<TimedSamples> {
        let (start, mut heard) = (self.now_us(), Vec::new());
        let mut looked = start;
        while self.now_us() < start + for_us {
            let now = self.now_us();
            self.late_us += now.saturating_sub(looked + IN_TIME_US);
            looked = now;
            while let Some(frame) = next_frame(self.link) {
                heard.extend(self.take_samples(&frame, &answer));
            }
            self.clock.pause(LOOK);
        }
        heard
    }

    /// Takes a frame, and answers it if it is one of samples.
    fn take_samples(
        &mut self,
        frame: &[u8],
        answer: impl Fn(&KeySamples) -> Option<(Header, i32)>,
    ) -> Option<TimedSamples> {
        if FrameKind::of(frame) != Some(FrameKind::KeySamples)
            || board_of(frame) != Some(self.number)
        {
            return None;
        }
        let Ok(samples) = KeySamples::decode(frame, self.layout) else {
            self.unreadable += 1;
            return None;
        };
        if let Some((header, force)) = answer(&samples) {
            self.send_forces(header, force);
        }
        Some(TimedSamples { heard_us: self.now_us(), samples })
    }

    fn send_forces(&mut self, header: Header, force: i32) {
        let force = Millinewtons::saturating(force.clamp(-MOST_FORCE_MN, MOST_FORCE_MN));
        let forces = PerKey::collect(std::iter::repeat_n(force, self.layout.n_keys));
        let mut frame = [0; key_forces::MAX_LEN];
        let header = Header { flag: false, ..header };
        let len = KeyForces { header, forces, slopes: PerKey::default() }.encode(&mut frame);
        let _lost = self.link.try_send(&frame[..len]);
    }

    /// Arms it with the nonce of a disarming, for forces that are valid for `valid_ms`.
    pub(super) fn arm(&mut self, valid_ms: u8) -> Result<(), String> {
        let Disarmed { nonce } = self.get(Operation::Disarm)?;
        let _done: Nothing = self.get_with(Operation::Arm, &Arm { nonce, packing: 0, valid_ms })?;
        Ok(())
    }

    /// Leaves it disarmed and without samples.
    pub(super) fn leave(&mut self) {
        let _stopped = self.status(Operation::Disarm, &Nothing);
        let _latched = self.ask_raw(Operation::Stream as u8, &[0; 5]);
    }
}
