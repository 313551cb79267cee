//! Memory keybed, scripted voices and virtual time.

use scheduler::lane::run_slots;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::{FinishedTick, KeyBus, Lanes, TickInput, TickObserver, TickOutput};
use scheduler::slot::Slot;
use scheduler::tick::{Scheduler, TickReport};
use scheduler::time::{Nanos, Period, Timetable};
use scheduler::voice::{Voice, VoiceFault, VoiceOutput, VoiceWork};
use scheduler::work::LaneBudget;

/// Single lane, run where it is called.
#[derive(Debug)]
pub struct Inline<'a, V> {
    pub slots: &'a mut [Slot<V>],
}

impl<V: Voice> Lanes for Inline<'_, V> {
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        run_slots(self.slots, LaneBudget::unlimited(f64::INFINITY), input, output);
    }
}

/// A spring with memory: the force depends on all samples since the last reset.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    /// Spring rate (N/m).
    pub rate: f64,
    /// Position that slowly follows the key (m).
    pub anchor: f64,
    /// First tick of a failure, first tick after it, and its kind.
    pub fails: Option<(u64, u64, Failure)>,
}

#[derive(Clone, Copy, Debug)]
pub enum Failure {
    Reported,
    /// NaN without a reported fault.
    Unnoticed,
}

impl Voice for Spring {
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        self.anchor += 0.1 * (sample.position - self.anchor);
        turn.force = self.rate * (sample.position - self.anchor);
        turn.work = VoiceWork { derivatives: 4, guards: 1, events: 0, ..VoiceWork::NONE };
        match self.fails {
            Some((from, until, failure)) if (from..until).contains(&tick) => match failure {
                Failure::Reported => turn.fail(VoiceFault::Capped { handled: 9 }),
                Failure::Unnoticed => turn.force = f64::NAN,
            },
            Some(_) | None => {}
        }
    }

    fn reset(&mut self, sample: &KeySample) {
        self.anchor = sample.position;
    }
}

pub fn springs() -> [Slot<Spring>; KEYS] {
    core::array::from_fn(|key| Slot::new(key, spring(key)))
}

pub fn spring(key: usize) -> Spring {
    Spring { rate: 500.0 + 3.0 * key as f64, anchor: 0.0, fails: None }
}

/// Keys that move by a known law, and the forces sent to them last.
#[derive(Debug)]
pub struct MemoryBus {
    pub received: Option<u64>,
    /// Tick and forces (N) sent last.
    pub sent: Option<(u64, [f64; KEYS])>,
    pub key_40_silent: core::ops::Range<u64>,
}

impl MemoryBus {
    pub const fn new() -> Self {
        Self { received: None, sent: None, key_40_silent: 0..0 }
    }
}

impl KeyBus for MemoryBus {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        self.received = Some(tick);
        for (key, sample) in samples.iter_mut().enumerate() {
            if key == 40 && self.key_40_silent.contains(&tick) {
                sample.age += 1;
            } else {
                let phase = 0.02 * tick as f64 + key as f64;
                *sample = KeySample::fresh(0.005 * (1.0 - phase.cos()));
            }
        }
    }

    fn send(&mut self, tick: u64, forces: &[f64; KEYS], _slopes: &[KeySlope; KEYS]) {
        self.sent = Some((tick, *forces));
    }
}

#[derive(Debug, Default)]
pub struct CountingObserver {
    pub ticks: u64,
}

impl TickObserver for CountingObserver {
    fn observe(&mut self, _seen: &FinishedTick<'_>) {
        self.ticks += 1;
    }
}

pub const HZ: u32 = 1000;

#[derive(Debug)]
pub struct Rig {
    pub scheduler: Scheduler,
    pub bus: MemoryBus,
    pub slots: [Slot<Spring>; KEYS],
    pub observer: CountingObserver,
}

impl Rig {
    pub fn new() -> Self {
        let period = Period::from_hz(HZ).unwrap();
        Self {
            scheduler: Scheduler::new(Timetable::new(Nanos::ZERO, period), f64::INFINITY),
            bus: MemoryBus::new(),
            slots: springs(),
            observer: CountingObserver::default(),
        }
    }

    pub fn poll_at(&mut self, microseconds: u64) -> Option<TickReport> {
        let mut lanes = Inline { slots: &mut self.slots };
        let now = Nanos::from_micros(microseconds);
        self.scheduler.poll(now, &mut self.bus, &mut lanes, &mut self.observer)
    }

    /// Runs `tick` at its due time and returns the forces sent (N).
    #[track_caller]
    pub fn forces_of(&mut self, tick: u64) -> [f64; KEYS] {
        let report = self.poll_at(1000 * tick).expect("due");
        assert_eq!(report.tick, tick);
        let (sent_tick, forces) = self.bus.sent.expect("sent");
        assert_eq!(sent_tick, tick);
        forces
    }
}
