//! A board under test: one request and its answer; samples, and forces that answer them.

use std::{collections::BTreeMap, time::Duration};

use crate::links::{HostClock, Link, RecvError};
use firmware_protocol::acyclic::arm::{Arm, Disarmed};
use firmware_protocol::acyclic::{AcyclicReply, Operation, Status};
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::key_forces::{self, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::frame::{FrameKind, Header, board_of, hello::Introduction};
use firmware_protocol::key::{BoardId, PerKey};
use firmware_protocol::quantity::Millinewtons;
use firmware_protocol::version::PROTOCOL_VERSION;
use firmware_protocol::{MAX_FRAME, Nothing, Record};

use super::MOST_FORCE_MN;

const LOOK: Duration = Duration::from_micros(200);
/// Longest time between two punctual polls (us).
const IN_TIME_US: u64 = 2_000;
/// Longest wait for a late answer (us).
const LATE_US: u64 = 250_000;
const TRIES: u8 = 3;

/// Returns the next whole frame on `link`; skips anything else.
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

/// Asks all boards on a link for hellos for `patience_us`, or until none is new for a third of a
/// second; returns the valid hellos by number.
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

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct TimedReply {
    pub(super) status: Status,
    pub(super) record: Vec<u8>,
    /// First transmission of its request, and its arrival (us).
    pub(super) sent_us: u64,
    pub(super) heard_us: u64,
}

/// Received samples, and their arrival by the host's clock (us).
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct TimedSamples {
    pub(super) heard_us: u64,
    pub(super) samples: KeySamples,
}

/// A board under test.
pub struct TestedBoard<'l> {
    link: &'l mut dyn Link,
    pub(super) number: BoardId,
    clock: HostClock,
    pub(super) layout: SampleLayout,
    next_id: u8,
    pub(super) unreadable: u32,
    /// Total lateness of polls (us), caused by this machine.
    pub(super) late_us: u64,
}

impl std::fmt::Debug for TestedBoard<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TestedBoard").field("number", &self.number).finish_non_exhaustive()
    }
}

impl<'l> TestedBoard<'l> {
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

    fn id(&mut self) -> u8 {
        self.next_id = self.next_id.wrapping_add(1).max(1);
        self.next_id
    }

    pub(super) fn request(&mut self, operation: u8, record: &[u8]) -> Vec<u8> {
        let head = (FrameKind::Request as u8) << 5 | self.number.number();
        [&[head, self.id(), operation], record].concat()
    }

    /// Sends `request`, again if no answer comes, and waits for the answer.
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

    fn wait(&mut self, request: &[u8], sent_us: u64, end_us: u64) -> Option<TimedReply> {
        while self.now_us() < end_us {
            if let Some(reply) = self.reply_to(request, sent_us) {
                return Some(reply);
            }
            self.clock.pause(LOOK);
        }
        None
    }

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

    pub(super) fn ask_raw(&mut self, operation: u8, record: &[u8]) -> Option<TimedReply> {
        let request = self.request(operation, record);
        self.exchange(&request)
    }

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

    /// Returns the record that answers `operation`, or the answer in words.
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

    /// Sends a damaged request; returns `true` if answered, `None` without checksums of the host.
    pub(super) fn answers_damaged(&mut self) -> Option<bool> {
        let mut request = self.request(Operation::Ping as u8, &[]);
        request[1] = 0x15;
        let _lost = self.link.try_send_damaged(&request)?;
        // A board that does not check answers the id with the inverted bit.
        request[1] ^= 0x40;
        let sent_us = self.now_us();
        Some(self.wait(&request, sent_us, sent_us + LATE_US).is_some())
    }

    pub(super) fn stop(&mut self) {
        let mut frame = [0; broadcast::MAX_LEN];
        let len = Broadcast::EmergencyStop { reason: 1 }.encode(&mut frame);
        let _lost = self.link.try_send(&frame[..len]);
    }

    /// Listens for `for_us`; answers samples by `answer`, with the same force (mN) on all keys.
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

    pub(super) fn leave(&mut self) {
        let _stopped = self.status(Operation::Disarm, &Nothing);
        let _latched = self.ask_raw(Operation::Stream as u8, &[0; 5]);
    }
}
