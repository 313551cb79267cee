//! The simulated keybed: eight boards of eleven keys on wires in memory.
//!
//! `receive(n)` returns the positions at the start of tick n; `send(n)` sets the forces held over
//! tick n; the plants move at the next `receive`.

use crate::links::faulty::{FaultCounts, FaultPlan, Faults};
use crate::links::{framed::Framing, loopback::Loopback};
use firmware_protocol::key::{BoardId, KeyIndex, PerKey};
use haptics::plant::{Gesture, HandCommand, KeyRig, RigParameters};
use rtrb::{Consumer, Producer, RingBuffer};
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;

use super::board::{BoardCounts, BoardMake, SimulatedBoard};
use crate::rt::board::{BoardEnd, BoardStatistics, BoardTerms};
use crate::rt::bus::{IgnoreAcyclic, KeybedBus, LineStatistics};
use crate::rt::link_monitor::{LinkMonitor, LinkSample};
use crate::rt::link_snapshot::{BoardSnapshot, BoardStatus, LinkSnapshot};
use crate::{Error, rt::board_supervisor::ArmState, topology};

/// Frames that a wire holds: those of one tick, and those that faults repeat or delay into it.
const WIRE_CAPACITY: usize = 8;

const MOST_PRESS_REQUESTS: usize = 256;

/// Maximum number of commands per tick.
const MOST_HANDS: usize = 16;

/// Eight simulated boards and the host's end of their wires.
#[derive(Debug)]
pub struct SimulatedKeybed {
    /// Boxed, since it is too large for the stack of its owner.
    bus: Box<KeybedBus>,
    lines: Vec<SimulatedLine>,
    /// Number of rearmings, if safe boards are rearmed.
    rearmed: Option<u64>,
    hands: Option<Consumer<(KeyIndex, HandCommand)>>,
    monitor: Option<LinkMonitor>,
}

#[derive(Clone, Debug)]
struct SimulatedLine {
    board: SimulatedBoard,
    wire: Loopback,
    faults: Faults,
    framing: [Framing; 2],
}

impl SimulatedKeybed {
    /// Returns a keybed at rest with equal keys, in ticks of `period` (s).
    ///
    /// # Errors
    /// If the period is not above 0 and up to 1 s.
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

    pub fn play(&mut self, key: KeyIndex, gestures: Vec<Gesture>) {
        self.lines[BoardId::of(key).index()].board.play(BoardId::slot_of(key), gestures);
    }

    /// Repeats the gestures of all keys with the period `length` (s), longer than the last of them.
    pub fn repeat_after(&mut self, length: f64) {
        self.lines.iter_mut().for_each(|line| line.board.repeat_after(length));
    }

    /// Presses or grips `key` from now on.
    ///
    /// # Real-time
    /// One assignment.
    pub fn press(&mut self, key: KeyIndex, hand: HandCommand) {
        self.lines[BoardId::of(key).index()].board.press(BoardId::slot_of(key), hand);
    }

    /// Returns a ring for commands as of [`Self::press`] during ticks; not for the tick.
    pub fn press_requests(&mut self) -> Producer<(KeyIndex, HandCommand)> {
        let (requests, hands) = RingBuffer::new(MOST_PRESS_REQUESTS);
        self.hands = Some(hands);
        requests
    }

    /// Returns a ring of link snapshots, one per second of ticks at `tick_hz`; not for the tick.
    pub fn monitor(&mut self, tick_hz: u32) -> Consumer<LinkSample> {
        let (monitor, samples) = LinkMonitor::new(tick_hz);
        self.monitor = Some(monitor);
        samples
    }

    /// Rearms boards in the tick in which they are found safe, as a host does with real ones.
    ///
    /// By then safety has faded out the host's own forces, so only the pause can be felt.
    pub fn keep_armed(&mut self) {
        self.rearmed.get_or_insert(0);
    }

    pub fn rearmed(&self) -> u64 {
        self.rearmed.unwrap_or_default()
    }

    /// Disturbs the wire of `board` as planned; exchanges count from 0.
    pub fn disturb(&mut self, board: BoardId, plan: FaultPlan) {
        self.lines[board.index()].faults = Faults::new(plan);
    }

    pub fn rearm(&mut self) {
        for line in self.lines.iter_mut().filter(|line| line.board.is_safe()) {
            line.board.rearm();
        }
    }

    /// Returns `true` if the watchdog of `board` has tripped and it was not armed since.
    pub fn is_safe(&self, board: BoardId) -> bool {
        self.lines[board.index()].board.is_safe()
    }

    /// Returns the line or board at index `place`, lines first; `None` behind the last.
    pub fn snapshot(&self, place: usize) -> Option<LinkSnapshot> {
        snapshot(&self.bus, self.rearmed, place)
    }

    pub fn statistics(&self, board: BoardId) -> BoardStatistics {
        self.bus.statistics(board.index())
    }

    pub fn wire(&self, board: BoardId) -> LineStatistics {
        self.bus.line(board.index())
    }

    pub fn board_counts(&self, board: BoardId) -> BoardCounts {
        self.lines[board.index()].board.counts()
    }

    pub fn fault_counts(&self, board: BoardId) -> FaultCounts {
        self.lines[board.index()].faults.counts()
    }

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

/// Returns the state of a line or board; boards kept armed count one arming more than rearmings.
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
    /// Simulates the plants until the start of `tick`, and receives from the wires.
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
