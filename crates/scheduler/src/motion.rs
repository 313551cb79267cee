//! What goes in and out of a tick, in SI units.
//!
//! Signs, stated once for the whole workspace: key-front displacement is positive
//! **down**; the force on the finger is positive **up**.

/// Keys of a full compass: A0 to C8.
pub const KEYS: usize = 88;

/// A point in model time: a whole tick and the fraction of it that has passed.
///
/// Never a sum of steps, so that hours of ticks lose nothing.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug, Default)]
pub struct Moment {
    /// Whole ticks since the start.
    pub tick: u64,
    /// Fraction of the tick, in `0 ..= 1`.
    pub theta: f64,
}

impl Moment {
    /// Time since the start [s] with ticks of `period` [s].
    pub fn seconds(self, period: f64) -> f64 {
        (self.tick as f64 + self.theta) * period
    }
}

/// What a key's sensor said for this tick.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct KeySample {
    /// Key-front displacement, down positive [m].
    pub position: f64,
    /// Ticks since this was measured; 0 is fresh.
    pub age: u32,
}

/// What happened to a key's note within a tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum KeyEvent {
    /// The hammer met the string.
    Strike {
        /// Hammer speed at the string [m/s].
        speed: f64,
    },
    /// The damper left the string.
    DamperLift,
    /// The damper fell back on the string.
    DamperFall {
        /// Key-front speed upwards when it fell [m/s].
        speed: f64,
    },
}
