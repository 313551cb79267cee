//! A sensor that says NaN.

use std::ops::Range;

use boards::sim::keybed::SimulatedKeybed;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;

/// A simulated keybed on which one key's sensor fails for some time.
#[derive(Debug)]
pub struct BrokenSensor {
    pub keybed: SimulatedKeybed,
    pub key: usize,
    pub ticks: Range<u64>,
}

impl KeyBus for BrokenSensor {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        self.keybed.receive(tick, samples);
        if self.ticks.contains(&tick) {
            samples[self.key].position = f64::NAN;
        }
    }

    fn send(&mut self, tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        self.keybed.send(tick, forces, slopes);
    }
}
