//! Ports that the host implements: a bus to the keys, lanes to run on, an observer.

use crate::motion::{KEYS, KeySample, KeySlope};
use crate::observation::{FollowedKeys, VoiceObservation};
use crate::overload::Simplifications;
use crate::time::Nanos;
use crate::voice::VoiceOutput;

/// The motors and sensors of all keys.
pub trait KeyBus {
    /// Writes every key's newest sample at the start of `tick`; an old one counts up its age.
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]);

    /// Sends the forces of `tick` (N, up positive), and their slopes until the next.
    ///
    /// A bus with motors that hold their force ignores the slopes.
    fn send(&mut self, tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]);

    /// Returns the processor time of simulated keys in the last tick; zero for real ones.
    fn simulated_work(&self) -> Nanos {
        Nanos::ZERO
    }
}

/// Workers that run the voices.
pub trait Lanes {
    /// Runs every voice and writes its turn, and its observation if its key is followed.
    ///
    /// A voice of a late lane has its previous force held, marked late.
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>);
}

/// Input of all lanes in a tick.
#[derive(Clone, Copy, Debug)]
pub struct TickInput<'a> {
    pub tick: u64,
    pub samples: &'a [KeySample; KEYS],
    pub followed: FollowedKeys,
    pub rules: TickRules,
}

/// Rules of a tick for every voice.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TickRules {
    pub simplified: Simplifications,
    pub hz: u32,
}

/// Output of all lanes in a tick, each for its own keys.
#[derive(Debug)]
pub struct TickOutput<'a> {
    pub turns: &'a mut [VoiceOutput; KEYS],
    pub observed: &'a mut [VoiceObservation; KEYS],
}

/// Watches ticks without delaying them.
pub trait TickObserver {
    fn followed(&mut self) -> FollowedKeys {
        FollowedKeys::NONE
    }

    fn observe(&mut self, seen: &FinishedTick<'_>);
}

/// Tick with its forces sent.
#[derive(Clone, Copy, Debug)]
pub struct FinishedTick<'a> {
    pub tick: u64,
    /// Ticks before this one that were never run.
    pub skipped: u64,
    /// `true` if voices may be felt.
    pub armed: bool,
    pub simplified: Simplifications,
    pub samples: &'a [KeySample; KEYS],
    pub turns: &'a [VoiceOutput; KEYS],
    /// Forces sent (N).
    pub forces: &'a [f64; KEYS],
    pub followed: FollowedKeys,
    /// Observations of followed keys; those of other keys are out of date.
    pub observed: &'a [VoiceObservation; KEYS],
}
