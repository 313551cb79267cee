//! The stage of unknown boards: identification on all lines.

use std::collections::BTreeMap;

use crate::links::{HostClock, Link as _, RecvError};
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::hello::{Hello, Introduction};
use firmware_protocol::frame::{DecodeError, FrameKind};
use firmware_protocol::{MAX_FRAME, key::BoardId, schema, version::PROTOCOL_VERSION};

use super::{FoundBoard, Identified, Keybed, LOOK, NamedLink, faults};
use crate::identity::Uid;
use crate::refusal::{BoardName, LineTraffic, Refusal, Refusals};

const ASK_US: u64 = 100_000;
/// Time without another hello after which all have answered (us).
const QUIET_US: u64 = 300_000;

/// Stage of boards before their identification.
#[derive(Clone, Copy, Debug)]
pub struct Offline;

impl Keybed<Offline> {
    pub const fn new(lines: Vec<NamedLink>, clock: HostClock) -> Self {
        Self { lines, stage: Offline, clock }
    }

    /// Asks for boards on all lines, for `patience_us` at most.
    ///
    /// # Errors
    /// All faults: lines without a board, boards of another version, the same board twice.
    pub fn identify(self, patience_us: u64) -> Result<Keybed<Identified>, Refusals> {
        let (keybed, refusals) = self.look(patience_us);
        if refusals.0.is_empty() { Ok(keybed) } else { Err(refusals) }
    }

    /// Like [`Self::identify`], but returns the valid boards beside the faults of others.
    pub fn look(mut self, patience_us: u64) -> (Keybed<Identified>, Refusals) {
        let start = self.now_us();
        let mut hearings: Vec<_> = self.lines.iter().map(|_| Hearing::default()).collect();
        let (mut asked, mut news) = (None, start);
        loop {
            let now = self.now_us();
            let all_heard = hearings.iter().all(|it| !it.hellos.is_empty());
            if start + patience_us <= now || all_heard && news + QUIET_US <= now {
                break;
            }
            if asked.is_none_or(|at| at + ASK_US <= now) {
                asked = Some(now);
                self.lines.iter_mut().for_each(ask);
            }
            let pairs = self.lines.iter_mut().zip(&mut hearings);
            // `||` must not skip a line.
            if pairs.fold(false, |any, (line, hearing)| hearing.listen(line) || any) {
                news = now;
            }
            self.clock.pause(LOOK);
        }
        let mut refusals: Vec<_> = faults(&self.lines).collect();
        let mut found = Vec::new();
        let heard = self.lines.iter().zip(hearings).enumerate();
        for (index, (line, hearing)) in heard.filter(|(_, (it, _))| it.link.fault().is_none()) {
            hearing.conclude(index, &line.name, &mut found, &mut refusals);
        }
        refuse_twins(&self.lines, &found, &mut refusals);
        let Self { lines, clock, .. } = self;
        (Keybed { lines, stage: Identified { found }, clock }, Refusals(refusals))
    }
}

fn ask(line: &mut NamedLink) {
    let mut frame = [0; broadcast::MAX_LEN];
    let len = Broadcast::WhoIsThere { version: PROTOCOL_VERSION }.encode(&mut frame);
    // A line that rejects it is asked again.
    let _lost = line.link.try_send(&frame[..len]);
}

#[derive(Default)]
struct Hearing {
    /// By number and id, the boards that sent it.
    hellos: BTreeMap<u8, BTreeMap<[u8; 6], Hello>>,
    /// Boards of other versions, with their major number.
    foreign: BTreeMap<u8, u8>,
    frames: u64,
    corrupt: u64,
    down: u64,
}

impl Hearing {
    fn listen(&mut self, line: &mut NamedLink) -> bool {
        let mut news = false;
        loop {
            let mut frame = [0; MAX_FRAME];
            match line.link.try_recv(&mut frame) {
                Ok(Some(len)) => news |= self.hear(&frame[..len.min(MAX_FRAME)]),
                Ok(None) => return news,
                Err(RecvError::Corrupt | RecvError::BufferTooShort { .. }) => self.corrupt += 1,
                Err(RecvError::Down) => {
                    self.down += 1;
                    return news;
                }
            }
        }
    }

    fn hear(&mut self, frame: &[u8]) -> bool {
        self.frames += 1;
        if FrameKind::of(frame) != Some(FrameKind::Hello) {
            return false;
        }
        match Introduction::decode(frame) {
            Ok(it) => {
                let same_number = self.hellos.entry(it.board.number()).or_default();
                same_number.insert(it.hello.uid, it.hello).is_none()
            }
            Err(DecodeError::Version(major)) => {
                let number = frame.first().map_or(0, |first| first & 0xF);
                self.foreign.insert(number, major).is_none()
            }
            Err(_other) => false,
        }
    }

    fn conclude(
        self,
        index: usize,
        line: &str,
        found: &mut Vec<FoundBoard>,
        refusals: &mut Vec<Refusal>,
    ) {
        let name = |number| BoardName { line: line.to_owned(), number };
        let Self { hellos, foreign, frames, corrupt, down } = self;
        if hellos.is_empty() && foreign.is_empty() {
            let heard = LineTraffic { frames, corrupt, down };
            refusals.push(Refusal::Silent { line: line.to_owned(), heard });
        }
        for (number, major) in foreign {
            refusals.push(Refusal::Version { board: name(number), major });
        }
        for (number, same_number) in hellos {
            let mut boards = same_number.into_iter();
            let Some((uid, hello)) = boards.next() else { continue };
            if let Some((other, _)) = boards.next() {
                let (one, other) = (Uid(uid), Uid(other));
                refusals.push(Refusal::SameNumber { board: name(number), one, other });
            }
            if hello.schema != schema::HASH {
                refusals.push(Refusal::Schema { board: name(number), theirs: hello.schema });
            }
            if let Some(board) = BoardId::new(number) {
                found.push(FoundBoard { line: index, board, hello });
            }
        }
    }
}

fn refuse_twins(lines: &[NamedLink], found: &[FoundBoard], refusals: &mut Vec<Refusal>) {
    for (n, one) in found.iter().enumerate() {
        for other in &found[n + 1..] {
            if one.hello.uid == other.hello.uid {
                let name = |it: &FoundBoard| it.name(lines);
                let uid = Uid(one.hello.uid);
                refusals.push(Refusal::SameBoard { one: name(one), other: name(other), uid });
            }
        }
    }
}
