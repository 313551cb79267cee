//! What goes in and out of a tick, in SI units.
//!
//! Signs, stated once for the whole workspace: key-front displacement is positive
//! **down**; the force on the finger is positive **up**.

pub use keyboard::KEYS;

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
    /// Returns the time since the start (s) with ticks of `period` (s).
    pub fn seconds(self, period: f64) -> f64 {
        (self.tick as f64 + self.theta) * period
    }
}

/// What a key's sensor said for this tick.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct KeySample {
    /// Key-front displacement, down positive (m).
    pub position: f64,
    /// Speed of the key's front, down positive (m/s), if its board measures it.
    pub velocity: Option<f64>,
    /// Ticks since this came, or since it was taken if its way was too long; 0 is fresh.
    pub age: u32,
    /// Ticks since it was taken, less what its way usually takes: the age, unless this sample
    /// was later or earlier than others.
    pub taken: f64,
}

impl KeySample {
    /// Returns a sample that has just come, as long after it was taken as any other.
    pub const fn fresh(position: f64) -> Self {
        Self { position, velocity: None, age: 0, taken: 0.0 }
    }

    /// Returns whether all of it are numbers.
    pub fn is_finite(&self) -> bool {
        self.position.is_finite()
            && self.velocity.is_none_or(f64::is_finite)
            && self.taken.is_finite()
    }
}

/// How the force on a key goes on around the point for which it was worked out.
///
/// F + stiffness (position − s) + damping (velocity − s'), until the next force comes.
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
    /// How long after the sample that is the key expected to be there (s).
    pub ahead: f64,
}

impl KeySlope {
    /// The slope of a force that is held.
    pub const HELD: Self =
        Self { stiffness: 0.0, damping: 0.0, position: 0.0, velocity: 0.0, ahead: 0.0 };

    /// Returns whether all of it are numbers.
    pub const fn is_finite(&self) -> bool {
        self.stiffness.is_finite()
            && self.damping.is_finite()
            && self.position.is_finite()
            && self.velocity.is_finite()
            && self.ahead.is_finite()
    }
}

/// How loud a strike is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Loudness {
    /// Speed of a grand's hammer (m/s) that is as loud.
    pub hammer_speed: f64,
    /// The one velocity of all notes, of an instrument without dynamics.
    pub velocity: Option<u8>,
}

impl Loudness {
    /// Of a grand's hammer at `speed` (m/s).
    pub const fn of_hammer(speed: f64) -> Self {
        Self { hammer_speed: speed, velocity: None }
    }
}

/// Whom the pressure on a key concerns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PressureScope {
    /// All notes of the channel.
    Channel,
    /// The key's own note.
    Key,
}

/// What happened to a key's note within a tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum KeyEvent {
    /// The hammer met the string.
    Strike {
        /// Hammer speed at the string (m/s).
        speed: f64,
        /// How loud that is.
        loudness: Loudness,
    },
    /// The damper left the string.
    DamperLift,
    /// The damper fell back on the string.
    DamperFall {
        /// Key-front speed upwards when it fell (m/s).
        speed: f64,
    },
    /// The key is held down with another force.
    Pressure {
        /// 0 (none) to 127.
        value: u8,
        scope: PressureScope,
    },
}
