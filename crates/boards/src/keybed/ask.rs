//! Single requests outside the tick, each with a wait for its answer.

use crate::links::Link as _;
use firmware_protocol::acyclic::{AcyclicReply, Operation, Status};
use firmware_protocol::{MAX_FRAME, Nothing, Record, key::BoardId};

use super::{Keybed, LOOK, NamedLink};
use crate::refusal::{BoardName, Refusal};
use crate::request_channel::RequestChannel;

/// Numbering of the single requests to one board.
#[derive(Clone, Debug)]
pub struct Asker {
    line: usize,
    name: BoardName,
    channel: RequestChannel,
}

impl<S> Keybed<S> {
    /// Returns the means to ask `board` on `line`; not while an armed keybed is attended, since a
    /// board answers one request at a time.
    pub fn asker(&mut self, line: usize, board: BoardId) -> Asker {
        let [first, ..] = self.now_us().to_le_bytes();
        let channel = RequestChannel::new(board, first);
        let name = self.lines.get(line).map_or_else(String::new, |it| it.name.clone());
        let name = BoardName { line: name, number: board.number() };
        let mut asker = Asker { line, name, channel };
        // A board may repeat its last answer to another host's request of this number.
        let _whatever = self.ask::<_, Nothing>(&mut asker, Operation::Ping, &Nothing);
        asker
    }

    /// Requests `operation` with `record`, and waits for the answer.
    ///
    /// # Errors
    /// The board does not answer, or declines.
    pub fn ask<Q: Record, A: Record>(
        &mut self,
        asker: &mut Asker,
        operation: Operation,
        record: &Q,
    ) -> Result<A, Refusal> {
        let clock = &self.clock;
        let start = clock.now_us();
        let board = || asker.name.clone();
        asker.channel.ask(operation, record);
        let Some(NamedLink { link, address, .. }) = self.lines.get_mut(asker.line) else {
            return Err(Refusal::Missing { board: board() });
        };
        loop {
            if let Some(outcome) = hear(link, &mut asker.channel) {
                return outcome.map_err(|status| Refusal::Declined {
                    board: board(),
                    link: address.clone(),
                    asked: operation,
                    status,
                });
            }
            let now = clock.now_us();
            if asker.channel.gave_up(now) {
                let seconds = now.saturating_sub(start) as f64 * 1e-6;
                return Err(link.fault().map_or_else(
                    || Refusal::NoAnswer { board: board(), asked: operation, seconds },
                    |fault| Refusal::Link { fault: fault.to_string() },
                ));
            }
            if let Some(frame) = asker.channel.due(now) {
                let _lost = link.try_send(frame);
            }
            clock.pause(LOOK);
        }
    }
}

fn hear<A: Record>(
    link: &mut (impl crate::links::Link + ?Sized),
    channel: &mut RequestChannel,
) -> Option<Result<A, Status>> {
    let mut frame = [0; MAX_FRAME];
    while let Ok(Some(len)) = link.try_recv(&mut frame) {
        let Some(heard) = channel.take_reply(&frame[..len.min(MAX_FRAME)]) else { continue };
        let AcyclicReply { status, record, .. } = heard.reply;
        let is_done = status == Status::Done;
        return Some(if is_done { A::take(record).ok_or(Status::BadValue) } else { Err(status) });
    }
    None
}
