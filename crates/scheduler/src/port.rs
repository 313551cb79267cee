//! What the outside must supply: a bus to the keys, lanes to run on, an observer.

use crate::motion::{KEYS, KeySample, KeySlope};
use crate::observation::{FollowedKeys, VoiceObservation};
use crate::overload::Simplifications;
use crate::time::Nanos;
use crate::voice::VoiceOutput;

/// The motors and sensors of all keys.
pub trait KeyBus {
    /// Writes the newest sample of every key, as of the start of `tick`.
    ///
    /// A key that has no new sample keeps its old one with its age counted up.
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]);

    /// Hands over the forces of `tick` (N, up positive), and how each goes on until the next.
    ///
    /// A bus whose motors hold what they are sent has no use for the slopes.
    fn send(&mut self, tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]);

    /// Returns the processor's time that simulated keys took in the last tick; real ones take none.
    fn simulated_work(&self) -> Nanos {
        Nanos::ZERO
    }
}

/// Where the voices run.
pub trait Lanes {
    /// Runs every voice and writes its turn, and what is seen of it if its key is followed.
    ///
    /// A voice whose lane did not finish in time has its previous force held, marked late.
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>);
}

/// What all lanes read in a tick.
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
    /// What is left out.
    pub simplified: Simplifications,
    /// Rate of the tick (Hz).
    pub hz: u32,
}

/// What all lanes write in a tick, each for its own keys.
#[derive(Debug)]
pub struct TickOutput<'a> {
    pub turns: &'a mut [VoiceOutput; KEYS],
    pub observed: &'a mut [VoiceObservation; KEYS],
}

/// Watches ticks without being waited for.
pub trait TickObserver {
    /// Returns the keys whose voices are to be observed in the next tick.
    fn followed(&mut self) -> FollowedKeys {
        FollowedKeys::NONE
    }

    /// Sees a finished tick.
    fn observe(&mut self, seen: &FinishedTick<'_>);
}

/// A tick whose forces are out.
#[derive(Clone, Copy, Debug)]
pub struct FinishedTick<'a> {
    pub tick: u64,
    /// Ticks before it that were never run.
    pub skipped: u64,
    /// Whether voices may be felt.
    pub armed: bool,
    /// What was left out in it.
    pub simplified: Simplifications,
    pub samples: &'a [KeySample; KEYS],
    pub turns: &'a [VoiceOutput; KEYS],
    /// The forces sent (N).
    pub forces: &'a [f64; KEYS],
    pub followed: FollowedKeys,
    /// What is seen of the voices of followed keys; of others it is out of date.
    pub observed: &'a [VoiceObservation; KEYS],
}
