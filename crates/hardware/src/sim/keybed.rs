//! The simulated keybed: eight boards of eleven keys on wires in memory.
//!
//! Order in time: `receive(n)` gives the positions at the start of tick n; `send(n)` gives
//! the forces held over tick n; the plants move when the next `receive` comes.

use firmware_protocol::key::{BoardId, KeyIndex, PerKey};
use haptics::plant::{Gesture, KeyRig, RigParameters};
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;

use super::board::{BoardCounts, BoardMake, SimulatedBoard};
use crate::Error;
use crate::link::faulty::{FaultCounts, FaultPlan, Faults};
use crate::link::framed::Framing;
use crate::link::loopback::Loopback;
use crate::rt::board::{BoardEnd, BoardStatistics, BoardTerms};
use crate::rt::bus::{KeybedBus, LineStatistics, Unread};
use crate::rt::glance::LinkSnapshot;
use crate::topology;

/// Frames that a wire holds: those of one tick, and what faults repeat or delay into it.
const WIRE_CAPACITY: usize = 8;

/// Eight simulated boards and the host's end of their wires.
#[derive(Clone, Debug)]
pub struct SimulatedKeybed {
    /// Away from the stack, where whoever owns a keybed would have to find room for it.
    bus: Box<KeybedBus>,
    lines: Vec<SimulatedLine>,
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
    /// A keybed at rest whose keys are all alike, in ticks of `period` (s).
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
            })
            .collect();
        Ok(Self { bus: Box::new(KeybedBus::new(&terms)), lines })
    }

    /// Plays `gestures` on `key` from now on instead of those before.
    pub fn play(&mut self, key: KeyIndex, gestures: Vec<Gesture>) {
        self.lines[key.board().index()].board.play(key.slot(), gestures);
    }

    /// Lays a weight on `key` that presses with `newtons`; 0 takes it away.
    ///
    /// # Real-time
    /// One assignment.
    pub fn lay(&mut self, key: KeyIndex, newtons: f64) {
        self.lines[key.board().index()].board.lay(key.slot(), newtons);
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

    /// Whether the watchdog of `board` has tripped and it was not armed since.
    pub fn is_safe(&self, board: BoardId) -> bool {
        self.lines[board.index()].board.is_safe()
    }

    /// The line or board at `place`, lines first, as it is now; nothing behind the last.
    pub fn glance(&self, place: usize) -> Option<LinkSnapshot> {
        self.bus.glance(place)
    }

    /// What the host has counted on the wire of `board`.
    pub fn statistics(&self, board: BoardId) -> BoardStatistics {
        self.bus.statistics(board.index())
    }

    /// What the wire of `board` has carried beside.
    pub fn wire(&self, board: BoardId) -> LineStatistics {
        self.bus.line(board.index())
    }

    /// What `board` itself has counted.
    pub fn board_counts(&self, board: BoardId) -> BoardCounts {
        self.lines[board.index()].board.counts()
    }

    /// How often the wire of `board` was disturbed since the last plan.
    pub fn fault_counts(&self, board: BoardId) -> FaultCounts {
        self.lines[board.index()].faults.counts()
    }

    /// The plant of `key`, with what no sensor tells.
    pub fn rig(&self, key: KeyIndex) -> Option<&KeyRig> {
        self.lines[key.board().index()].board.rig(key.slot())
    }
}

impl KeyBus for SimulatedKeybed {
    /// Lets the plants live until the start of `tick`, and takes what the wires bring.
    ///
    /// # Real-time
    /// One tick of 88 plants for each tick since the last call, at most 256; no heap.
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        self.bus.begin(tick);
        for (index, SimulatedLine { board, wire, faults, framing, .. }) in
            self.lines.iter_mut().enumerate()
        {
            let [host, away] = framing;
            board.advance(tick, &mut away.around(wire.board_end()));
            let mut link = host.around(faults.around(wire.host_end()));
            self.bus.receive(index, &mut link, &mut Unread);
            let newest = self.bus.boards().get(index).and_then(BoardEnd::newest);
            if let Some(newest) = newest.filter(|_| self.bus.has_news(index)) {
                self.bus.date(index, board.ticks_since(newest.header.stamp_us));
            }
        }
        samples.copy_from_slice(self.bus.samples());
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
