//! Notes by their MIDI number, and velocities.

use keyboard::KeyIndex;

/// One of the 88 notes of the compass.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[must_use]
pub struct Note(u8);

impl Note {
    /// Returns the note of `key`, if it is 0 ..= 87.
    pub const fn from_key(key: u8) -> Option<Self> {
        match KeyIndex::new(key) {
            Some(key) => Some(Self(key.midi())),
            None => None,
        }
    }

    /// Returns the note with MIDI `number`, if it is 21 ..= 108.
    pub const fn from_number(number: u8) -> Option<Self> {
        if KeyIndex::from_midi(number).is_some() { Some(Self(number)) } else { None }
    }

    /// Returns the MIDI number, 21 ..= 108.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// Returns the number of the key, 0 ..= 87.
    pub const fn key(self) -> u8 {
        self.0 - KeyIndex::LOWEST.midi()
    }
}

/// Speed of a strike or a release, 1 ..= 127; a note-on with velocity 0 would be a note-off.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[must_use]
pub struct Velocity(u8);

impl Velocity {
    pub const MIN: Self = Self(1);

    pub const MAX: Self = Self(127);

    /// Value that MIDI prescribes for an unknown velocity.
    pub const UNKNOWN: Self = Self(64);

    /// Returns `value` as a velocity if it is 1 ..= 127.
    pub const fn new(value: u8) -> Option<Self> {
        if 1 <= value && value <= 127 { Some(Self(value)) } else { None }
    }

    /// Returns the velocity nearest to `level`; the least if `level` is not a number.
    pub fn nearest(level: f64) -> Self {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "rounded and clamped to 1 ..= 127 before; NaN becomes 0 and then 1"
        )]
        let value = level.round().clamp(1.0, 127.0) as u8;
        Self(if value < 1 { 1 } else { value })
    }

    pub const fn get(self) -> u8 {
        self.0
    }
}
