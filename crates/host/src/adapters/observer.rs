//! The tick's wait-free end: key events into a ring, counts into atomics.

use std::sync::Arc;
use std::sync::atomic::{AtomicU8, AtomicU32, AtomicU64, Ordering};

use midi::{NoteEvent as MidiEvent, NoteEventKind, PedalMove, Velocity};
use rtrb::Producer;
use scheduler::motion::{KeyEvent, Loudness, Moment, PressureScope};
use scheduler::overload::{Simplification, Simplifications};
use scheduler::port::{FinishedTick, TickObserver};
use scheduler::voice::{VoiceFault, VoiceOutput};

use super::key_set::AtomicKeySet;
use engine::realtime::wake_fd::WakeFd;

/// Counters that any thread may read while the host runs.
#[derive(Debug, Default)]
pub struct LiveCounters {
    pub ticks: AtomicU64,
    /// Keys whose voice ran its equations in the last tick.
    pub active: AtomicU32,
    pub strikes: AtomicU64,
    /// Reset maps applied by all models.
    pub events: AtomicU64,
    /// Turns that ended in a fault, except those of a voice muted by then.
    pub faults: AtomicU64,
    pub muted: AtomicKeySet,
    /// Key events without room in the ring or in their turn.
    pub dropped: AtomicU64,
    /// Smoothed CPU time of the last ticks (ns).
    pub work_ns: AtomicU64,
    pub missed: AtomicU64,
    pub asleep: AtomicKeySet,
    pub overload: OverloadCounters,
    pub derivatives: AtomicU64,
    pub guards: AtomicU64,
    /// Certain and unknown steps in ticks of a key without an event.
    pub quiet_steps: [AtomicU64; 2],
    /// Certain and unknown steps in ticks of a key with events.
    pub event_steps: [AtomicU64; 2],
}

/// Work omitted because ticks had too little time.
#[derive(Debug, Default)]
pub struct OverloadCounters {
    /// Current omissions, as [`Simplifications::bits`].
    now: AtomicU8,
    /// Ticks with each omission, in the order of [`Simplification::ALL`].
    ticks: [AtomicU64; Simplification::ALL.len()],
    waited: AtomicU64,
    waiting: AtomicKeySet,
    /// Ticks in which voices waited although there was time.
    pub starved: AtomicU64,
}

impl OverloadCounters {
    pub fn now(&self) -> Simplifications {
        Simplifications::of_bits(self.now.load(Ordering::Relaxed))
    }

    pub fn ticks(&self) -> [u64; Simplification::ALL.len()] {
        self.ticks.each_ref().map(|ticks| ticks.load(Ordering::Relaxed))
    }

    /// Returns the number of waiting turns, and their keys.
    pub fn waited(&self) -> (u64, impl Iterator<Item = u8> + use<>) {
        (self.waited.load(Ordering::Relaxed), self.waiting.keys())
    }

    fn count(&self, simplified: Simplifications, sums: &Sums) {
        self.now.store(simplified.bits(), Ordering::Relaxed);
        for (one, ticks) in Simplification::ALL.into_iter().zip(&self.ticks) {
            if simplified.contains(one) {
                ticks.fetch_add(1, Ordering::Relaxed);
            }
        }
        if sums.waited != 0 {
            self.waited.fetch_add(sums.waited, Ordering::Relaxed);
            self.waiting.insert(sums.waiting);
        }
    }
}

/// Publishes the events of a tick; events without room are dropped and counted.
#[derive(Debug)]
pub struct TickPublisher {
    ring: Producer<MidiEvent>,
    wake: Arc<WakeFd>,
    counters: Arc<LiveCounters>,
    pedals: Box<[PedalMove]>,
    next_pedal: usize,
    /// Length of a pass (s), if the moves repeat.
    repeat: Option<f64>,
    /// Start of the present pass (s).
    pass: f64,
    /// Tick period (s).
    period: f64,
}

impl TickPublisher {
    pub fn new(
        ring: Producer<MidiEvent>,
        wake: Arc<WakeFd>,
        counters: Arc<LiveCounters>,
        pedals: Box<[PedalMove]>,
        period: f64,
    ) -> Self {
        Self { ring, wake, counters, pedals, next_pedal: 0, repeat: None, pass: 0.0, period }
    }

    /// Replaces the moves of the pedals, which are in order of time.
    pub fn set_pedals(&mut self, pedals: Box<[PedalMove]>) {
        (self.pedals, self.next_pedal) = (pedals, 0);
    }

    /// Repeats all moves of the pedals with this period (s), if any.
    pub const fn repeat_pedals_after(&mut self, length: Option<f64>) {
        self.repeat = length;
    }

    /// Sends the audible events of a tick at once, so that the receiver can sort them by time.
    ///
    /// # Real-time
    /// One write of at most all events of a tick and all remaining moves of pedals.
    fn publish(&mut self, seen: &FinishedTick<'_>, sums: &mut Sums) {
        let period = self.period;
        let end = Moment { tick: seen.tick, theta: 1.0 }.seconds(period);
        if let Some(length) = self.repeat
            && self.pass + length <= end
        {
            (self.pass, self.next_pedal) = ((end / length).floor() * length, 0);
        }
        let pass = self.pass;
        let pedals = self.pedals.get(self.next_pedal..).unwrap_or_default();
        let n_pedals = pedals.iter().take_while(|pedal| pass + pedal.at < end).count();
        let pressed = pedals.iter().take(n_pedals).map(|&PedalMove { pedal, at, depth }| {
            MidiEvent { key: 0, at: pass + at, kind: NoteEventKind::Pedal { pedal, depth } }
        });
        let played = (0..).zip(seen.turns).flat_map(|(key, turn)| {
            let event = move |&(at, event): &(Moment, KeyEvent)| MidiEvent {
                key,
                at: at.seconds(period),
                kind: heard(event),
            };
            turn.events.as_slice().iter().map(event)
        });
        let wanted = n_pedals + sums.heard;
        let room = wanted.min(self.ring.slots());
        let published = match self.ring.write_chunk_uninit(room) {
            Ok(chunk) => chunk.fill_from_iter(pressed.chain(played)),
            Err(_too_few) => 0,
        };
        sums.dropped += (wanted - published) as u64;
        sums.news = 0 < wanted;
        self.next_pedal += n_pedals;
    }
}

#[derive(Debug, Default)]
struct Sums {
    heard: usize,
    active: u32,
    faults: u64,
    events: u64,
    derivatives: u64,
    guards: u64,
    /// Certain and unknown steps, in ticks without events and with them.
    quiet_steps: [u64; 2],
    event_steps: [u64; 2],
    dropped: u64,
    strikes: u64,
    news: bool,
    muted: u128,
    asleep: u128,
    waiting: u128,
    waited: u64,
}

impl Sums {
    fn add(&mut self, key: usize, turn: &VoiceOutput) {
        self.heard += turn.events.as_slice().len();
        self.strikes += turn.events.strikes() as u64;
        self.active += u32::from(!turn.idle);
        self.asleep |= u128::from(turn.idle) << key;
        self.waiting |= u128::from(turn.waited) << key;
        self.waited += u64::from(turn.waited);
        match turn.fault {
            Some(VoiceFault::Muted) => self.muted |= 1 << key,
            Some(_) => self.faults += 1,
            None => {}
        }
        self.events += u64::from(turn.work.events);
        self.derivatives += u64::from(turn.work.derivatives);
        self.guards += u64::from(turn.work.guards);
        let steps =
            if turn.work.events == 0 { &mut self.quiet_steps } else { &mut self.event_steps };
        steps[0] += u64::from(turn.work.certain);
        steps[1] += u64::from(turn.work.unknown);
        self.dropped += u64::from(turn.events.dropped());
    }
}

impl TickObserver for TickPublisher {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        let tick = seen.tick;
        let mut sums = Sums::default();
        for (key, turn) in seen.turns.iter().enumerate() {
            sums.add(key, turn);
        }
        self.publish(seen, &mut sums);
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
            (&counters.quiet_steps[0], sums.quiet_steps[0]),
            (&counters.quiet_steps[1], sums.quiet_steps[1]),
            (&counters.event_steps[0], sums.event_steps[0]),
            (&counters.event_steps[1], sums.event_steps[1]),
        ] {
            counter.fetch_add(sum, Ordering::Relaxed);
        }
        counters.muted.insert(sums.muted);
        counters.asleep.store(sums.asleep);
        counters.overload.count(seen.simplified, &sums);
        if sums.news {
            self.wake.ring();
        }
    }
}

const fn heard(event: KeyEvent) -> NoteEventKind {
    match event {
        KeyEvent::Strike { loudness: Loudness { hammer_speed: speed, velocity }, .. } => {
            // A velocity of 0 means none.
            let velocity = match velocity {
                Some(velocity) => Velocity::new(velocity),
                None => None,
            };
            NoteEventKind::Strike { speed, velocity }
        }
        KeyEvent::Pressure { value, scope } => {
            let scope = match scope {
                PressureScope::Channel => midi::PressureTarget::Channel,
                PressureScope::Key => midi::PressureTarget::Key,
            };
            NoteEventKind::Pressure { value, scope }
        }
        KeyEvent::DamperLift => NoteEventKind::DamperLift,
        KeyEvent::DamperFall { speed } => NoteEventKind::DamperFall { speed },
    }
}
