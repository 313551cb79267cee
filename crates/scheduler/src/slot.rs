//! A voice's place in a lane: which key it plays, and whether it must be reset first.

use crate::motion::{KEYS, KeySample};
use crate::voice::{Turn, Voice, VoiceFault};

/// Keys of an octave.
const OCTAVE: usize = 12;

/// The lane that runs `key` when there are `n_lanes`.
///
/// Neighbours go to different lanes, and so do octaves: hands play chords, and a chord
/// should not fall on one lane. Lanes differ by a few keys at most.
///
/// # Panics
/// If there are no lanes.
pub const fn lane_of(key: usize, n_lanes: usize) -> usize {
    (key + key / OCTAVE) % n_lanes
}

/// One key's voice, in the order in which its lane runs it.
#[derive(Clone, Debug)]
pub struct Slot<V> {
    key: usize,
    voice: V,
    /// The voice must be put at rest before its next tick.
    fresh: bool,
}

impl<V> Slot<V> {
    /// Gives `voice` the key `key`, in `0 ..= 87`.
    ///
    /// # Panics
    /// If there is no such key.
    pub const fn new(key: usize, voice: V) -> Self {
        assert!(key < KEYS, "no such key");
        Self { key, voice, fresh: true }
    }

    /// The key that the voice plays.
    pub const fn key(&self) -> usize {
        self.key
    }

    /// Puts `voice` in and hands the old one out.
    pub const fn replace(&mut self, voice: V) -> V {
        self.fresh = true;
        core::mem::replace(&mut self.voice, voice)
    }
}

impl<V: Voice> Slot<V> {
    /// Runs the voice for `tick`; a force that is not finite becomes a fault here.
    ///
    /// A voice that failed is reset at the next sample, and says that its force is fresh.
    pub fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut Turn) {
        if sample.position.is_finite() {
            if self.fresh {
                self.voice.reset(sample);
            }
            self.voice.tick_into(tick, sample, turn);
        } else {
            *turn = Turn::faulty(VoiceFault::BadSample);
        }
        if turn.fault.is_none() && !turn.force.is_finite() {
            turn.fault = Some(VoiceFault::NotFinite);
        }
        turn.fresh = self.fresh;
        self.fresh = turn.fault.is_some();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_and_octaves_are_on_different_lanes() {
        for n_lanes in 2..=8 {
            for key in 0..KEYS - OCTAVE {
                let lane = lane_of(key, n_lanes);
                assert_ne!(lane, lane_of(key + OCTAVE, n_lanes), "octave above key {key}");
                let neighbour = lane_of(key + 1, n_lanes);
                let octave_begins = (key + 1) % OCTAVE == 0;
                assert!(lane != neighbour || octave_begins && n_lanes == 2, "key {key}");
            }
        }
    }

    #[test]
    fn lanes_share_the_keys_evenly() {
        for n_lanes in 1..=8 {
            let keys_on = |lane| (0..KEYS).filter(|&key| lane_of(key, n_lanes) == lane).count();
            let most = (0..n_lanes).map(keys_on).max().unwrap();
            let fewest = (0..n_lanes).map(keys_on).min().unwrap();
            assert!(most - fewest <= 2, "{n_lanes} lanes: {fewest} to {most} keys");
        }
    }

    /// Its force is what it was last reset to, or NaN once told to fail.
    #[derive(Default)]
    struct Spy {
        rest: f64,
        resets: u32,
        fails_at: u64,
    }

    impl Voice for Spy {
        fn tick(&mut self, tick: u64, _sample: &KeySample) -> Turn {
            let force = if tick == self.fails_at { f64::NAN } else { self.rest };
            Turn { force, ..Turn::default() }
        }

        fn reset(&mut self, sample: &KeySample) {
            self.rest = sample.position;
            self.resets += 1;
        }
    }

    fn turn_of(slot: &mut Slot<Spy>, tick: u64, position: f64) -> Turn {
        let mut turn = Turn::default();
        slot.tick(tick, &at(position), &mut turn);
        turn
    }

    fn at(position: f64) -> KeySample {
        KeySample::fresh(position)
    }

    #[test]
    fn a_new_voice_is_put_at_rest_where_its_key_is() {
        let mut slot = Slot::new(3, Spy { fails_at: 9, ..Spy::default() });
        let first = turn_of(&mut slot, 0, 0.004);
        assert!((first.force - 0.004).abs() == 0.0 && first.fresh);
        assert!(!turn_of(&mut slot, 1, 0.005).fresh);
        assert_eq!(slot.voice.resets, 1);
    }

    #[test]
    fn a_force_that_is_not_finite_is_a_fault_and_the_voice_is_reset() {
        let mut slot = Slot::new(3, Spy { fails_at: 1, ..Spy::default() });
        assert_eq!(turn_of(&mut slot, 0, 0.0).fault, None);
        assert_eq!(turn_of(&mut slot, 1, 0.0).fault, Some(VoiceFault::NotFinite));
        let back = turn_of(&mut slot, 2, 0.002);
        assert_eq!((back.fault, back.fresh, slot.voice.resets), (None, true, 2));
    }

    #[test]
    fn a_voice_never_sees_a_sample_that_is_not_finite() {
        let mut slot = Slot::new(3, Spy { fails_at: 9, ..Spy::default() });
        assert_eq!(turn_of(&mut slot, 0, f64::NAN).fault, Some(VoiceFault::BadSample));
        assert_eq!(slot.voice.resets, 0);
    }
}
