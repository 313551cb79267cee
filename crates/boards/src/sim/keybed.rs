//! The simulated keybed: eight boards of eleven keys on wires in memory.
//!
//! Order in time: `receive(n)` gives the positions at the start of tick n; `send(n)` gives
//! the forces held over tick n; the plants move when the next `receive` comes.

use crate::links::faulty::{FaultCounts, FaultPlan, Faults};
use crate::links::framed::Framing;
use crate::links::loopback::Loopback;
use firmware_protocol::key::{BoardId, KeyIndex, PerKey};
use haptics::plant::{Gesture, HandCommand, KeyRig, RigParameters};
use rtrb::{Consumer, Producer, RingBuffer};
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;

use super::board::{BoardCounts, BoardMake, SimulatedBoard};
use crate::Error;
use crate::rt::board::{BoardEnd, BoardStatistics, BoardTerms};
use crate::rt::board_supervisor::ArmState;
use crate::rt::bus::{IgnoreAcyclic, KeybedBus, LineStatistics};
use crate::rt::link_monitor::{LinkMonitor, LinkSample};
use crate::rt::link_snapshot::{BoardSnapshot, BoardStatus, LinkSnapshot};
use crate::topology;

/// Frames that a wire holds: those of one tick, and what faults repeat or delay into it.
const WIRE_CAPACITY: usize = 8;

/// Commands for hands that may wait.
const MOST_PRESS_REQUESTS: usize = 256;

/// Commands that one tick takes at most.
const MOST_HANDS: usize = 16;

/// Eight simulated boards and the host's end of their wires.
#[derive(Debug)]
pub struct SimulatedKeybed {
    /// In a box, since it is too large for the stack of its owner.
    bus: Box<KeybedBus>,
    lines: Vec<SimulatedLine>,
    /// Times that boards were armed again, if they are when they are found safe.
    rearmed: Option<u64>,
    /// What hands shall do to keys.
    hands: Option<Consumer<(KeyIndex, HandCommand)>>,
    monitor: Option<LinkMonitor>,
}

/// A board, its wire, and what goes wrong on it.
#[derive(Clone, Debug)]
struct SimulatedLine {
    board: SimulatedBoard,
    wire: Loopback,
    faults: Faults,
    /// What host and board remember of the stream between them.
    framing: [Framing; 2],
}

impl SimulatedKeybed {
    /// Returns a keybed at rest whose keys are all alike, in ticks of `period` (s).
    ///
    /// # Errors
    /// Refuses a period that is not above 0 and up to 1 s.
    pub fn new(period: f64, rig: RigParameters) -> Result<Self, Error> {
        let lines: Vec<SimulatedLine> = BoardId::all()
            .map(|id| SimulatedLine::new(id, period, rig))
            .collect::<Result<_, _>>()?;
        let places = topology::standard();
        let terms: Vec<_> = places
            .iter()
            .zip(&lines)
            .map(|(place, line)| BoardTerms {
                place: *place,
                samples: line.board.samples,
                forces: line.board.forces,
                calibration: PerKey::collect(line.board.calibration()),
                max_force_mn: u16::MAX,
            })
            .collect();
        let bus = Box::new(KeybedBus::new(&terms));
        Ok(Self { bus, lines, rearmed: None, hands: None, monitor: None })
    }

    /// Plays `gestures` on `key` from now on instead of those before.
    pub fn play(&mut self, key: KeyIndex, gestures: Vec<Gesture>) {
        self.lines[BoardId::of(key).index()].board.play(BoardId::slot_of(key), gestures);
    }

    /// Plays the gestures of all keys again and again, each pass `length` (s) after the one before:
    /// longer than the last of them takes.
    pub fn repeat_after(&mut self, length: f64) {
        self.lines.iter_mut().for_each(|line| line.board.repeat_after(length));
    }

    /// Lets a hand press on `key` or grip it from now on.
    ///
    /// # Real-time
    /// One assignment.
    pub fn press(&mut self, key: KeyIndex, hand: HandCommand) {
        self.lines[BoardId::of(key).index()].board.press(BoardId::slot_of(key), hand);
    }

    /// Returns where commands for hands are given while ticks run, as in [`Self::press`]; not
    /// for the tick.
    pub fn press_requests(&mut self) -> Producer<(KeyIndex, HandCommand)> {
        let (requests, hands) = RingBuffer::new(MOST_PRESS_REQUESTS);
        self.hands = Some(hands);
        requests
    }

    /// Returns where snapshots of all lines and boards come once a second, for ticks at `tick_hz`
    /// (1/s); not for the tick.
    pub fn monitor(&mut self, tick_hz: u32) -> Consumer<LinkSample> {
        let (monitor, samples) = LinkMonitor::new(tick_hz);
        self.monitor = Some(monitor);
        samples
    }

    /// Arms boards again from now on within the tick in which they are found safe, as a host does
    /// with real ones.
    ///
    /// By then safety has faded the host's own forces out too, and blends them in again, so
    /// nothing is felt but the pause.
    pub fn keep_armed(&mut self) {
        self.rearmed.get_or_insert(0);
    }

    /// Returns how often boards were armed again by [`Self::keep_armed`].
    pub fn rearmed(&self) -> u64 {
        self.rearmed.unwrap_or_default()
    }

    /// Disturbs the wire of `board` from now on, as planned; exchanges count from 0.
    pub fn disturb(&mut self, board: BoardId, plan: FaultPlan) {
        self.lines[board.index()].faults = Faults::new(plan);
    }

    /// Lets boards that are safe take forces again.
    pub fn rearm(&mut self) {
        for line in self.lines.iter_mut().filter(|line| line.board.is_safe()) {
            line.board.rearm();
        }
    }

    /// Tells whether the watchdog of `board` has tripped and it was not armed since.
    pub fn is_safe(&self, board: BoardId) -> bool {
        self.lines[board.index()].board.is_safe()
    }

    /// Returns the line or board at `place`, lines first, as it is now; nothing behind the last.
    pub fn snapshot(&self, place: usize) -> Option<LinkSnapshot> {
        snapshot(&self.bus, self.rearmed, place)
    }

    /// Returns what the host has counted on the wire of `board`.
    pub fn statistics(&self, board: BoardId) -> BoardStatistics {
        self.bus.statistics(board.index())
    }

    /// Returns what the wire of `board` has carried beside.
    pub fn wire(&self, board: BoardId) -> LineStatistics {
        self.bus.line(board.index())
    }

    /// Returns what `board` itself has counted.
    pub fn board_counts(&self, board: BoardId) -> BoardCounts {
        self.lines[board.index()].board.counts()
    }

    /// Returns how often the wire of `board` was disturbed since the last plan.
    pub fn fault_counts(&self, board: BoardId) -> FaultCounts {
        self.lines[board.index()].faults.counts()
    }

    /// Returns the plant of `key`, with what no sensor tells.
    pub fn rig(&self, key: KeyIndex) -> Option<&KeyRig> {
        self.lines[BoardId::of(key).index()].board.rig(BoardId::slot_of(key))
    }
}

impl SimulatedKeybed {
    fn take_hands(&mut self) {
        for _ in 0..MOST_HANDS {
            let Some(Ok((key, hand))) = self.hands.as_mut().map(Consumer::pop) else { break };
            self.press(key, hand);
        }
    }

    fn rearm_if_kept(&mut self) {
        let is_safe = self.lines.iter().any(|line| line.board.is_safe());
        if let Some(rearmed) = self.rearmed.as_mut().filter(|_| is_safe) {
            *rearmed += 1;
            self.rearm();
        }
    }
}

/// Returns a line or board as it is now; boards that are kept armed were armed once more than
/// again.
fn snapshot(bus: &KeybedBus, rearmed: Option<u64>, place: usize) -> Option<LinkSnapshot> {
    let snapshot = bus.snapshot(place)?;
    let status = rearmed.map(|rearmed| BoardStatus {
        state: ArmState::Armed,
        armings: 1 + rearmed,
        round_trip_us: None,
        restarts: 0,
        reset_reason: 0,
        burst_us: None,
        late: None,
    });
    Some(match snapshot {
        LinkSnapshot::Line(..) => snapshot,
        LinkSnapshot::Board(board, it) => {
            LinkSnapshot::Board(board, BoardSnapshot { status, ..it })
        }
    })
}

impl KeyBus for SimulatedKeybed {
    /// Lets the plants live until the start of `tick`, and takes what the wires bring.
    ///
    /// # Real-time
    /// One tick of 88 plants for each tick since the last call, at most 256; no heap.
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        self.take_hands();
        self.bus.begin(tick);
        for (index, SimulatedLine { board, wire, faults, framing, .. }) in
            self.lines.iter_mut().enumerate()
        {
            let [host, away] = framing;
            board.advance(tick, &mut away.around(wire.board_end()));
            let mut link = host.around(faults.around(wire.host_end()));
            self.bus.receive(index, &mut link, &mut IgnoreAcyclic);
            let newest = self.bus.boards().get(index).and_then(BoardEnd::newest);
            if let Some(newest) = newest.filter(|_| self.bus.has_news(index)) {
                self.bus.date(index, board.ticks_since(newest.header.stamp_us));
            }
        }
        samples.copy_from_slice(self.bus.samples());
        self.rearm_if_kept();
        let Self { bus, rearmed, monitor, .. } = self;
        if let Some(monitor) = monitor {
            monitor.take(tick, |place| snapshot(bus, *rearmed, place));
        }
    }

    /// Puts one frame of forces on each wire, which ends the exchange.
    ///
    /// # Real-time
    /// Eight frames; no heap.
    fn send(&mut self, _tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        for (index, SimulatedLine { wire, faults, framing, .. }) in
            self.lines.iter_mut().enumerate()
        {
            let [host, _away] = framing;
            let mut link = host.around(faults.around(wire.host_end()));
            self.bus.send(index, 0, forces, slopes, &mut link);
            faults.next_exchange();
        }
    }
}

impl SimulatedLine {
    fn new(id: BoardId, period: f64, rig: RigParameters) -> Result<Self, Error> {
        Ok(Self {
            board: SimulatedBoard::new(BoardMake::standard(id, period, rig))?.armed(),
            wire: Loopback::new(WIRE_CAPACITY),
            faults: Faults::new(FaultPlan::default()),
            framing: Default::default(),
        })
    }
}
