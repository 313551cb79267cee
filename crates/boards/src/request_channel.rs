//! Requests to one board, repeated until they are answered.
//!
//! Contains no clock and no link: time (us) is an argument, and the caller sends the frames.

use firmware_protocol::acyclic::{AcyclicReply, Operation, RETRY_MS, encode_request};
use firmware_protocol::{MAX_FRAME, Record, key::BoardId};

/// Transmissions of a request before the board counts as silent.
const TRIES: u8 = 8;

#[derive(Clone, Copy, Debug)]
struct PendingRequest {
    frame: [u8; MAX_FRAME],
    len: usize,
    id: u8,
    operation: Operation,
    sent_us: Option<u64>,
    tries: u8,
}

/// The requests to one board, one at a time.
#[derive(Clone, Copy, Debug)]
pub struct RequestChannel {
    board: BoardId,
    next_id: u8,
    pending: Option<PendingRequest>,
}

/// A reply, with the time of its request.
#[derive(Clone, Copy, Debug)]
pub struct ReceivedReply<'a> {
    pub reply: AcyclicReply<'a>,
    pub operation: Operation,
    /// Transmission time of its request, if it was sent only once (us).
    pub sent_us: Option<u64>,
}

impl RequestChannel {
    /// Starts without a request; the first one will have the number `first`.
    ///
    /// A restarted host starts elsewhere, or its request could be taken for its last one before.
    pub const fn new(board: BoardId, first: u8) -> Self {
        Self { board, next_id: first, pending: None }
    }

    pub const fn is_free(&self) -> bool {
        self.pending.is_none()
    }

    /// Requests an operation; replaces a pending request.
    pub fn ask<R: Record>(&mut self, operation: Operation, record: &R) {
        let (id, mut frame) = (self.next_id, [0; MAX_FRAME]);
        self.next_id = self.next_id.wrapping_add(1);
        let len = encode_request(self.board, id, operation, record, &mut frame);
        self.pending = Some(PendingRequest { frame, len, id, operation, sent_us: None, tries: 0 });
    }

    /// Returns the frame to be sent at `now_us`, if one is due.
    pub fn due(&mut self, now_us: u64) -> Option<&[u8]> {
        let pending = self.pending.as_mut()?;
        let retry_us = u64::from(RETRY_MS) * 1_000;
        if pending.sent_us.is_some_and(|sent| now_us < sent + retry_us) || TRIES <= pending.tries {
            return None;
        }
        pending.sent_us = Some(now_us);
        pending.tries += 1;
        Some(&pending.frame[..pending.len])
    }

    /// Decodes a frame; returns the reply if it is the awaited one.
    pub fn take_reply<'a>(&mut self, frame: &'a [u8]) -> Option<ReceivedReply<'a>> {
        let reply = AcyclicReply::decode(frame).ok()?;
        let is_it = |pending: &mut PendingRequest| {
            reply.board == self.board
                && reply.id == pending.id
                && reply.operation == Ok(pending.operation)
        };
        let pending = self.pending.take_if(is_it)?;
        let sent_us = pending.sent_us.filter(|_| pending.tries == 1);
        Some(ReceivedReply { reply, operation: pending.operation, sent_us })
    }

    /// Returns `true` if the board never answered; then another request may be sent.
    pub fn gave_up(&mut self, now_us: u64) -> bool {
        let retry_us = u64::from(RETRY_MS) * 1_000;
        let is_silent = |pending: &mut PendingRequest| {
            TRIES <= pending.tries && pending.sent_us.is_none_or(|sent| sent + retry_us <= now_us)
        };
        self.pending.take_if(is_silent).is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use firmware_protocol::Nothing;
    use firmware_protocol::acyclic::{Status, encode_reply, ping::Pong};

    fn board() -> BoardId {
        BoardId::new(4).unwrap()
    }

    fn reply(id: u8, operation: Operation) -> ([u8; MAX_FRAME], usize) {
        let mut bytes = [0; MAX_FRAME];
        let pong = Ok::<_, Status>(Pong { board_us: 5 });
        let len = encode_reply(board(), id, operation as u8, pong, &mut bytes);
        (bytes, len)
    }

    #[test]
    fn it_asks_again_after_25_ms_and_gives_up_in_the_end() {
        let mut channel = RequestChannel::new(board(), 9);
        channel.ask(Operation::Ping, &Nothing);
        let mut sent = 0;
        for now in (0..1_000_000).step_by(1_000) {
            sent += u32::from(channel.due(now).is_some());
            if channel.gave_up(now) {
                assert_eq!((sent, now), (8, 200_000));
                assert!(channel.is_free());
                return;
            }
        }
        panic!("it never gave up");
    }

    #[test]
    fn only_the_reply_that_is_waited_for_counts() {
        let mut channel = RequestChannel::new(board(), 9);
        channel.ask(Operation::Ping, &Nothing);
        assert!(channel.due(100).is_some());
        for (id, operation) in [(8, Operation::Ping), (9, Operation::Light)] {
            let (bytes, len) = reply(id, operation);
            assert!(channel.take_reply(&bytes[..len]).is_none());
        }
        let (bytes, len) = reply(9, Operation::Ping);
        let heard = channel.take_reply(&bytes[..len]).unwrap();
        assert_eq!(heard.sent_us, Some(100));
        assert!(channel.take_reply(&bytes[..len]).is_none(), "it counts once");
    }

    #[test]
    fn a_reply_to_what_was_asked_twice_tells_no_time() {
        let mut channel = RequestChannel::new(board(), 0);
        channel.ask(Operation::Ping, &Nothing);
        assert!(channel.due(0).is_some() && channel.due(25_000).is_some());
        let (bytes, len) = reply(0, Operation::Ping);
        assert_eq!(channel.take_reply(&bytes[..len]).unwrap().sent_us, None);
    }
}
