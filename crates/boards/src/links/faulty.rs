//! A link that loses, repeats, damages and delays frames, by a script or by chance from a seed.

use std::ops::Range;

use super::{Link, QueuedFrame, RecvError, SendError, random::Random};

/// Maximum number of delayed frames in each direction; more are dropped.
const MAX_DELAYED: usize = 32;

/// Fault of a frame, or of the link.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LinkFault {
    Drop,
    Duplicate,
    FlipBit,
    /// The frame arrives that many exchanges later.
    Delay(u32),
    /// The link reports that the other end is gone; by chance, the frame is dropped silently.
    Down,
}

/// Direction of a frame, from the host's view.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    Send,
    Receive,
}

/// A fault at stated exchanges.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Scripted {
    /// Half-open range of these exchanges.
    pub exchanges: Range<u64>,
    pub direction: Direction,
    pub fault: LinkFault,
}

/// A fault that happens by chance.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Chance {
    /// Fraction of the frames with this fault, `0 ..= 1`, both ways.
    pub probability: f64,
    pub fault: LinkFault,
}

/// Faults of a link; none by default.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct FaultPlan {
    /// Random seed; the same seed causes the same faults.
    pub seed: u64,
    /// Faults by chance. A frame has at most one, so their probabilities add up.
    pub chances: Vec<Chance>,
    /// Faults at stated exchanges, which precede chance; the first that fits counts.
    pub script: Vec<Scripted>,
}

/// Counts of the faults.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct FaultCounts {
    pub dropped: u64,
    pub duplicated: u64,
    pub flipped: u64,
    pub delayed: u64,
    pub down: u64,
}

/// A running plan: chance, exchange, and delayed frames.
#[derive(Clone, Debug)]
pub struct Faults {
    plan: FaultPlan,
    random: Random,
    exchange: u64,
    sent: DelayedFrames,
    received: DelayedFrames,
    counts: FaultCounts,
}

impl Faults {
    pub fn new(plan: FaultPlan) -> Self {
        let random = Random(plan.seed);
        let counts = FaultCounts::default();
        Self {
            plan,
            random,
            exchange: 0,
            sent: DelayedFrames::new(),
            received: DelayedFrames::new(),
            counts,
        }
    }

    /// Advances to the next exchange, the unit of delays and scripts.
    pub const fn next_exchange(&mut self) {
        self.exchange += 1;
    }

    pub const fn around<L: Link>(&mut self, link: L) -> Faulty<'_, L> {
        Faulty { link, faults: self }
    }

    pub const fn counts(&self) -> FaultCounts {
        self.counts
    }

    /// Returns `true` if the script has the link down for this call.
    fn is_down(&mut self, direction: Direction) -> bool {
        let down = self.scripted(direction) == Some(LinkFault::Down);
        self.counts.down += u64::from(down);
        down
    }

    fn scripted(&self, direction: Direction) -> Option<LinkFault> {
        let fits = |step: &&Scripted| {
            step.direction == direction && step.exchanges.contains(&self.exchange)
        };
        self.plan.script.iter().find(fits).map(|step| step.fault)
    }

    fn chance(&mut self) -> Option<LinkFault> {
        if self.plan.chances.is_empty() {
            return None;
        }
        let mut draw = self.random.unit();
        for Chance { probability, fault } in &self.plan.chances {
            draw -= probability;
            if draw < 0.0 {
                return Some(*fault);
            }
        }
        None
    }

    /// Applies the next fault to `queued`; returns the frame's fate.
    fn disturb(&mut self, direction: Direction, queued: &mut QueuedFrame) -> Passage {
        let fault = self.scripted(direction).or_else(|| self.chance());
        match fault {
            None => Passage::Now,
            Some(LinkFault::Drop | LinkFault::Down) => {
                self.counts.dropped += 1;
                Passage::Never
            }
            Some(LinkFault::Duplicate) => {
                self.counts.duplicated += 1;
                Passage::Twice
            }
            Some(LinkFault::FlipBit) => {
                self.counts.flipped += 1;
                flip(&mut self.random, queued);
                Passage::Now
            }
            Some(LinkFault::Delay(exchanges)) => {
                self.counts.delayed += 1;
                Passage::At(self.exchange + u64::from(exchanges))
            }
        }
    }

    fn hold_received(&mut self, due: u64, queued: QueuedFrame) {
        self.counts.dropped += u64::from(!self.received.hold(due, queued));
    }

    fn hold_sent(&mut self, due: u64, queued: QueuedFrame) {
        self.counts.dropped += u64::from(!self.sent.hold(due, queued));
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Passage {
    Now,
    Twice,
    Never,
    At(u64),
}

/// A link with faults, seen from the host's end.
#[derive(Debug)]
pub struct Faulty<'a, L> {
    link: L,
    faults: &'a mut Faults,
}

impl<L: Link> Link for Faulty<'_, L> {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        if self.faults.is_down(Direction::Send) {
            return Err(SendError::Down);
        }
        self.release();
        let mut queued = QueuedFrame::new(frame)?;
        match self.faults.disturb(Direction::Send, &mut queued) {
            Passage::Now => self.link.try_send(queued.as_slice()),
            Passage::Twice => {
                self.link.try_send(queued.as_slice())?;
                self.link.try_send(queued.as_slice())
            }
            Passage::Never => Ok(()),
            Passage::At(due) => {
                self.faults.hold_sent(due, queued);
                Ok(())
            }
        }
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        if self.faults.is_down(Direction::Receive) {
            return Err(RecvError::Down);
        }
        self.release();
        if let Some(queued) = self.faults.received.due(self.faults.exchange) {
            return queued.unpack(buffer).map(Some);
        }
        // Each turn takes a frame off the wire, and the wire's queue is bounded.
        loop {
            let mut queued = QueuedFrame::EMPTY;
            let Some(len) = self.link.try_recv(&mut queued.bytes)? else { return Ok(None) };
            queued.len = len;
            match self.faults.disturb(Direction::Receive, &mut queued) {
                Passage::Now => return queued.unpack(buffer).map(Some),
                Passage::Twice => {
                    self.faults.hold_received(self.faults.exchange, queued);
                    return queued.unpack(buffer).map(Some);
                }
                Passage::Never => {}
                Passage::At(due) => self.faults.hold_received(due, queued),
            }
        }
    }
}

impl<L: Link> Faulty<'_, L> {
    fn release(&mut self) {
        for _ in 0..MAX_DELAYED {
            let Some(queued) = self.faults.sent.due(self.faults.exchange) else { return };
            let lost = self.link.try_send(queued.as_slice()).is_err();
            self.faults.counts.dropped += u64::from(lost);
        }
    }
}

#[derive(Clone, Debug)]
struct DelayedFrames {
    places: Box<[(u64, QueuedFrame)]>,
    n: usize,
}

impl DelayedFrames {
    fn new() -> Self {
        let places = std::iter::repeat_n((0, QueuedFrame::EMPTY), MAX_DELAYED).collect();
        Self { places, n: 0 }
    }

    /// Keeps a frame until `due`; returns `false` without room.
    fn hold(&mut self, due: u64, queued: QueuedFrame) -> bool {
        let place = self.places.get_mut(self.n);
        let kept = place.map(|place| *place = (due, queued)).is_some();
        self.n += usize::from(kept);
        kept
    }

    fn due(&mut self, exchange: u64) -> Option<QueuedFrame> {
        let held = &mut self.places[..self.n];
        let first = held.iter().position(|(due, _)| *due <= exchange)?;
        held[first..].rotate_left(1);
        self.n -= 1;
        Some(self.places[self.n].1)
    }
}

fn flip(random: &mut Random, queued: &mut QueuedFrame) {
    let draw = random.next();
    let bits = queued.len as u64 * 8;
    let bit = usize::try_from(draw.checked_rem(bits).unwrap_or_default()).unwrap_or_default();
    queued.bytes[bit / 8] ^= 1 << (bit % 8);
}
