//! Inputs and outputs of a tick, in SI units.
//!
//! Signs of the whole workspace: key-front displacement is positive **down**, the force on the
//! finger is positive **up**.

pub use keyboard::KEYS;

/// Point in model time: a whole tick and a fraction of it, never a sum of steps.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug, Default)]
pub struct Moment {
    pub tick: u64,
    /// Fraction of the tick that has passed, in `0 ..= 1`.
    pub theta: f64,
}

impl Moment {
    /// Returns the time since the start (s), with ticks of `period` (s).
    pub fn seconds(self, period: f64) -> f64 {
        (self.tick as f64 + self.theta) * period
    }
}

/// Reading of a key's sensor for one tick.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct KeySample {
    /// Key-front displacement, down positive (m).
    pub position: f64,
    /// Speed of the key front, down positive (m/s), if its board measures it.
    pub velocity: Option<f64>,
    /// Ticks since it arrived, or since it was taken if its transport took too long; 0 is fresh.
    pub age: u32,
    /// Ticks since it was taken, less the usual transport time: the age of a usual sample.
    pub taken: f64,
}

impl KeySample {
    /// Returns a sample that has just arrived after the usual transport time.
    pub const fn fresh(position: f64) -> Self {
        Self { position, velocity: None, age: 0, taken: 0.0 }
    }

    pub fn is_finite(&self) -> bool {
        self.position.is_finite()
            && self.velocity.is_none_or(f64::is_finite)
            && self.taken.is_finite()
    }
}

/// Continuation of the force on a key around the point for which it was computed.
///
/// F + stiffness (position − s) + damping (velocity − s'), until the next force arrives.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct KeySlope {
    /// −∂F/∂s (N/m).
    pub stiffness: f64,
    /// −∂F/∂s' (N s/m).
    pub damping: f64,
    /// Displacement for which the force holds, down positive (m).
    pub position: f64,
    /// Speed for which the force holds, down positive (m/s).
    pub velocity: f64,
    /// Time after the sample at which the key is expected there (s).
    pub ahead: f64,
}

impl KeySlope {
    /// Slope of a force that is held.
    pub const HELD: Self =
        Self { stiffness: 0.0, damping: 0.0, position: 0.0, velocity: 0.0, ahead: 0.0 };

    pub const fn is_finite(&self) -> bool {
        self.stiffness.is_finite()
            && self.damping.is_finite()
            && self.position.is_finite()
            && self.velocity.is_finite()
            && self.ahead.is_finite()
    }
}

/// Loudness of a strike.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Loudness {
    /// Speed of an equally loud grand hammer (m/s).
    pub hammer_speed: f64,
    /// Fixed velocity of all notes, of an instrument without dynamics.
    pub velocity: Option<u8>,
}

impl Loudness {
    /// Returns the loudness of a grand's hammer at `speed` (m/s).
    pub const fn of_hammer(speed: f64) -> Self {
        Self { hammer_speed: speed, velocity: None }
    }
}

/// Range of notes to which the pressure on a key applies.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PressureScope {
    Channel,
    Key,
}

/// Event of a key's note within a tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum KeyEvent {
    Strike {
        /// Hammer speed at the string (m/s).
        speed: f64,
        loudness: Loudness,
    },
    DamperLift,
    DamperFall {
        /// Key-front speed upwards when it fell (m/s).
        speed: f64,
    },
    Pressure {
        /// 0 (none) to 127.
        value: u8,
        scope: PressureScope,
    },
}
