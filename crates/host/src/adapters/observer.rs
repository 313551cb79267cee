//! The tick's wait-free end: key events into a ring, counts into atomics.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

use midi::{EventKind, KeyEvent as MidiEvent};
use rtrb::Producer;
use scheduler::motion::{KeyEvent, Moment};
use scheduler::port::{Seen, TickObserver};
use scheduler::voice::Turn;

use crate::bell::Bell;

/// What anybody may look at while the host runs.
#[derive(Debug, Default)]
pub struct LiveCounters {
    /// Ticks done.
    pub ticks: AtomicU64,
    /// Keys whose voice ran its equations in the last tick.
    pub active: AtomicU32,
    /// Hammers that met their string.
    pub strikes: AtomicU64,
    /// Reset maps applied by all models.
    pub events: AtomicU64,
    /// Turns that ended in a fault.
    pub faults: AtomicU64,
    /// Key events that found no room in the ring or in their turn.
    pub dropped: AtomicU64,
    /// CPU time of the last ticks, smoothed [ns].
    pub work_ns: AtomicU64,
    /// Missed deadlines.
    pub missed: AtomicU64,
    /// Derivatives evaluated.
    pub derivatives: AtomicU64,
    /// Guards evaluated.
    pub guards: AtomicU64,
}

/// Publishes what happened in a tick; full is dropped and counted.
#[derive(Debug)]
pub struct Publisher {
    ring: Producer<MidiEvent>,
    bell: Arc<Bell>,
    counters: Arc<LiveCounters>,
    /// Moves of the sustain pedal, in order of time: when [s], and how deep.
    pedals: Box<[(f64, f64)]>,
    next_pedal: usize,
    /// Tick [s].
    period: f64,
}

impl Publisher {
    /// Publishes into `ring`, rings `bell`, and counts; also plays `pedals`.
    pub fn new(
        ring: Producer<MidiEvent>,
        bell: Arc<Bell>,
        counters: Arc<LiveCounters>,
        pedals: Box<[(f64, f64)]>,
        period: f64,
    ) -> Self {
        Self { ring, bell, counters, pedals, next_pedal: 0, period }
    }

    /// Plays `pedals` from now on: when [s], and how deep, in order of time.
    pub fn set_pedals(&mut self, pedals: Box<[(f64, f64)]>) {
        (self.pedals, self.next_pedal) = (pedals, 0);
    }

    fn publish(&mut self, event: MidiEvent) {
        if self.ring.push(event).is_err() {
            self.counters.dropped.fetch_add(1, Ordering::Relaxed);
        }
    }

    /// Moves of the pedal up to the end of `tick`; at most all that are left.
    fn press_pedals(&mut self, tick: u64) -> bool {
        let end = Moment { tick, theta: 1.0 }.seconds(self.period);
        let before = self.next_pedal;
        while let Some(&(at, depth)) =
            self.pedals.get(self.next_pedal).filter(|move_| move_.0 < end)
        {
            self.publish(MidiEvent { key: 0, at, kind: EventKind::Sustain(depth) });
            self.next_pedal += 1;
        }
        self.next_pedal > before
    }

    fn publish_turn(&mut self, key: u8, turn: &Turn, sums: &mut Sums) {
        sums.active += u32::from(!turn.idle);
        sums.faults += u64::from(turn.fault.is_some());
        sums.events += u64::from(turn.work.events);
        sums.derivatives += u64::from(turn.work.derivatives);
        sums.guards += u64::from(turn.work.guards);
        sums.dropped += u64::from(turn.events.dropped());
        for (at, event) in turn.events.as_slice() {
            sums.strikes += u64::from(matches!(event, KeyEvent::Strike { .. }));
            sums.news = true;
            self.publish(MidiEvent { key, at: at.seconds(self.period), kind: heard(*event) });
        }
    }
}

/// Sums over one tick's turns.
#[derive(Debug, Default)]
struct Sums {
    active: u32,
    faults: u64,
    events: u64,
    derivatives: u64,
    guards: u64,
    dropped: u64,
    strikes: u64,
    news: bool,
}

impl TickObserver for Publisher {
    fn observe(&mut self, seen: &Seen<'_>) {
        let tick = seen.tick;
        let mut sums = Sums { news: self.press_pedals(tick), ..Sums::default() };
        for (key, turn) in (0..).zip(seen.turns) {
            self.publish_turn(key, turn, &mut sums);
        }
        let counters = &self.counters;
        counters.ticks.store(tick + 1, Ordering::Relaxed);
        counters.active.store(sums.active, Ordering::Relaxed);
        for (counter, sum) in [
            (&counters.strikes, sums.strikes),
            (&counters.events, sums.events),
            (&counters.faults, sums.faults),
            (&counters.dropped, sums.dropped),
            (&counters.derivatives, sums.derivatives),
            (&counters.guards, sums.guards),
        ] {
            counter.fetch_add(sum, Ordering::Relaxed);
        }
        if sums.news {
            self.bell.ring();
        }
    }
}

const fn heard(event: KeyEvent) -> EventKind {
    match event {
        KeyEvent::Strike { speed } => EventKind::Strike { speed },
        KeyEvent::DamperLift => EventKind::DamperLift,
        KeyEvent::DamperFall { speed } => EventKind::DamperFall { speed },
    }
}
