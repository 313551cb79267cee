//! Trials of runs: faults on simulated keys and wires, and a check of every tick.

use boards::sim::keybed::SimulatedKeybed;
use engine::realtime::clock;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;
use scheduler::time::Nanos;

/// A trial of a run, between its simulated keys and the scheduler.
///
/// # Real-time
/// In a run in real time it is called in the tick.
pub trait RunTrial: Send {
    /// Receives the samples of all keys in `tick`, and may spoil them.
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]);

    /// Receives the forces for all keys in `tick` (N), and the keys themselves.
    fn send(&mut self, tick: u64, forces: &[f64; KEYS], keybed: &SimulatedKeybed);
}

pub(super) struct SimulatedKeys {
    pub(super) keybed: Box<SimulatedKeybed>,
    pub(super) trial: Option<Box<dyn RunTrial>>,
    work: Nanos,
}

impl SimulatedKeys {
    pub(super) const fn new(keybed: Box<SimulatedKeybed>) -> Self {
        Self { keybed, trial: None, work: Nanos::ZERO }
    }
}

impl KeyBus for SimulatedKeys {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        let before = clock::thread_cpu();
        self.keybed.receive(tick, samples);
        self.work = clock::thread_cpu().since(before);
        if let Some(trial) = &mut self.trial {
            trial.receive(tick, samples);
        }
    }

    fn send(&mut self, tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        self.keybed.send(tick, forces, slopes);
        if let Some(trial) = &mut self.trial {
            trial.send(tick, forces, &self.keybed);
        }
    }

    fn simulated_work(&self) -> Nanos {
        self.work
    }
}
