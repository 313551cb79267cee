//! What the outside must supply: a bus to the keys, lanes to run on, an observer.

use crate::motion::{KEYS, KeySample, KeySlope};
use crate::voice::VoiceOutput;

/// The motors and sensors of all keys.
pub trait KeyBus {
    /// Writes the newest sample of every key, as of the start of `tick`.
    ///
    /// A key that has no new sample keeps its old one with its age counted up.
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]);

    /// Hands over the forces (N, up positive) to be held during `tick`.
    fn send(&mut self, tick: u64, forces: &[f64; KEYS]);

    /// The same with how each force goes on, for motors that work between two ticks.
    ///
    /// A bus whose motors hold what they are sent need not say anything.
    fn send_sloped(&mut self, tick: u64, forces: &[f64; KEYS], _slopes: &[KeySlope; KEYS]) {
        self.send(tick, forces);
    }
}

/// Where the voices run.
pub trait Lanes {
    /// Runs every voice for `tick` and writes its turn.
    ///
    /// A voice whose lane did not finish in time keeps its previous turn, marked late.
    fn run(&mut self, tick: u64, samples: &[KeySample; KEYS], turns: &mut [VoiceOutput; KEYS]);
}

/// Somebody who watches ticks without being waited for.
pub trait TickObserver {
    /// Sees a finished tick.
    fn observe(&mut self, seen: &FinishedTick<'_>);
}

/// A finished tick.
#[derive(Clone, Copy, Debug)]
pub struct FinishedTick<'a> {
    pub tick: u64,
    /// Ticks before it that were never run.
    pub skipped: u64,
    /// Whether voices may be felt.
    pub armed: bool,
    /// What the sensors said.
    pub samples: &'a [KeySample; KEYS],
    /// What the voices did.
    pub turns: &'a [VoiceOutput; KEYS],
    /// What was sent (N).
    pub forces: &'a [f64; KEYS],
}
