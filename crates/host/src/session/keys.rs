//! The simulated keybed as the tick's bus, with the host's answer to a tripped watchdog.

use firmware_protocol::key::{BoardId, KeyIndex};
use hardware::rt::glance::{BoardGlance, BoardStatus, LinkSnapshot};
use hardware::rt::steward::ArmState;
use hardware::sim::keybed::SimulatedKeybed;
use rtrb::Consumer;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;

/// A keybed whose boards are armed again when the host is back.
///
/// A board that hears nothing for 20 ms takes its forces away and stays safe until it is
/// told otherwise. By then safety has faded the host's own forces out too, and blends them
/// in again, so nothing is felt but the pause.
#[derive(Debug)]
pub(super) struct SimulatedTransport {
    pub(super) keybed: SimulatedKeybed,
    /// Times that boards were armed again.
    pub(super) rearmed: u64,
    /// Weights to be laid on keys (N).
    pub(super) weights: Consumer<(KeyIndex, f64)>,
}

/// Weights that one tick lays at most.
const MOST_WEIGHTS: usize = 16;

impl SimulatedTransport {
    pub(super) const fn new(keybed: SimulatedKeybed, weights: Consumer<(KeyIndex, f64)>) -> Self {
        Self { keybed, rearmed: 0, weights }
    }

    /// The line or board at `place`, lines first, as it is now; nothing behind the last.
    pub(super) fn glance(&self, place: usize) -> Option<LinkSnapshot> {
        let glance = self.keybed.glance(place)?;
        Some(match glance {
            LinkSnapshot::Line(..) => glance,
            LinkSnapshot::Board(board, it) => {
                let (stage, armings) = (ArmState::Armed, 1 + self.rearmed);
                // Armed again within the tick in which they are found safe.
                let care = Some(BoardStatus { stage, armings, round_trip_us: None });
                LinkSnapshot::Board(board, BoardGlance { care, ..it })
            }
        })
    }
}

impl KeyBus for SimulatedTransport {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        for _ in 0..MOST_WEIGHTS {
            let Ok((key, newtons)) = self.weights.pop() else { break };
            self.keybed.lay(key, newtons);
        }
        self.keybed.receive(tick, samples);
        if BoardId::all().any(|board| self.keybed.is_safe(board)) {
            self.keybed.rearm();
            self.rearmed += 1;
        }
    }

    fn send(&mut self, tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        self.keybed.send(tick, forces, slopes);
    }
}

#[cfg(test)]
mod tests {
    use haptics::RigParameters;

    use super::*;

    #[test]
    fn boards_that_a_stall_of_the_host_made_safe_are_armed_again() {
        let keybed = SimulatedKeybed::new(1e-3, RigParameters::default()).expect("a keybed");
        let mut keys = SimulatedTransport::new(keybed, rtrb::RingBuffer::new(1).1);
        let mut samples = [KeySample::default(); KEYS];
        for tick in (0..10).chain(100..110) {
            keys.receive(tick, &mut samples);
            keys.send(tick, &[0.5; KEYS], &[KeySlope::HELD; KEYS]);
        }
        assert_eq!(keys.rearmed, 1, "90 ms of silence trip every watchdog once");
        assert!(BoardId::all().all(|board| !keys.keybed.is_safe(board)));
    }
}
