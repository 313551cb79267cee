//! Why a key is not played any more.

use firmware_protocol::acyclic::health::key_fault;
use firmware_protocol::key::MOST_KEYS;

/// What is wrong with a key, its sensor or its motor.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum KeyFault {
    /// Its readings lie far above its rest or below its bottom.
    Beyond,
    /// Its readings jump farther than a key can move.
    Jumping,
    /// They go to and fro faster than motor and finger can move it.
    Noisy,
    /// The speeds that its board reports are not those with which it moves.
    FalseSpeed,
    /// Its readings continue beside where they were, as if counts were lost.
    Slipped,
    /// It moves up when its motor pushes it down, or down when it pushes it up.
    Reversed,
    /// No force of the proof moved it.
    Unmoved,
    /// It moves as if its motor did not follow its forces.
    Unresponsive,
    /// Its force went to and fro after it had been halved for that.
    Shaking,
    /// Its board reports this, one of [`firmware_protocol::acyclic::health::key_fault`].
    Reported(u8),
}

impl KeyFault {
    /// Returns what is wrong, in words that follow on the key's name and a colon.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Beyond => "its readings lie far beyond its rest and its bottom",
            Self::Jumping => "its readings jump farther than a key can move",
            Self::FalseSpeed => "the speeds that its board reports are not those of the key",
            Self::Noisy => "its readings go to and fro faster than a key can",
            Self::Slipped => "its readings have slipped: counts were lost, or a coupling is loose",
            Self::Reversed => "it moves against its motor's force",
            Self::Unmoved => "its motor does not move it",
            Self::Unresponsive => "it does not follow its motor's force",
            Self::Shaking => "its force went to and fro, also at half its strength",
            Self::Reported(key_fault::SENSOR) => "its board reports that its sensor has failed",
            Self::Reported(key_fault::MOTOR) => "its board reports that its motor has failed",
            Self::Reported(key_fault::TOO_HOT) => "its board reports that its motor is too hot",
            Self::Reported(_) => "its board reports that it has failed",
        }
    }

    /// Returns what to do about it.
    pub const fn remedy(self) -> &'static str {
        match self {
            Self::Beyond | Self::Jumping | Self::FalseSpeed | Self::Noisy => "see to its sensor",
            Self::Slipped => "see to its sensor and coupling, then calibrate it",
            Self::Reversed => "exchange its motor's wires, or turn its sensor",
            Self::Unmoved => {
                "see whether its motor is connected and has power, and whether the key jams; if \
                 the motor pushes by itself, cut its supply"
            }
            Self::Unresponsive => {
                "see whether its motor is connected; if the motor pushes by itself, cut its supply"
            }
            Self::Shaking => {
                "take a scene that is stable on this link, which `letoff check` names; if it played \
                 before, see to its motor's wires and to its link"
            }
            Self::Reported(key_fault::TOO_HOT) => "let it cool down",
            Self::Reported(_) => "see what its log says: `letoff devices --boards --log`",
        }
    }
}

/// What was noticed of the keys of a board, by slot.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct GuardFindings {
    /// What each key was muted for.
    pub muted: [Option<KeyFault>; MOST_KEYS],
    /// Keys whose force was halved because they shook, slot 0 in bit 0.
    pub softened: u16,
    /// Keys whose motor has not been proven yet, since they never came to rest.
    pub unproven: u16,
    /// Keys that stand still away from rest and bottom.
    pub misplaced: u16,
    /// Readings that left the trend and returned; they were not used.
    pub glitches: u64,
    /// Ticks in which a force was not allowed to rise as fast as it should.
    pub limited: u64,
    /// Forces that were led over from those before a gap.
    pub blended: u64,
}
