use firmware_protocol::{acyclic::health::key_fault, key::MOST_KEYS};

/// Fault of a key, its sensor or its motor.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum KeyFault {
    /// Its readings are far above its rest or below its bottom.
    Beyond,
    /// Its readings jump farther than a key can move.
    Jumping,
    /// Its readings oscillate faster than motor and finger can move it.
    Noisy,
    /// The speeds from its board differ from its motion.
    FalseSpeed,
    /// Its readings continue with an offset, as if counts were lost.
    Slipped,
    /// It moves against the force of its motor.
    Reversed,
    /// No force of the proof moved it.
    Unmoved,
    /// It moves as if its motor ignored the forces.
    Unresponsive,
    /// Its force oscillated again after it had been halved for that.
    Shaking,
    /// Report of its board, one of [`firmware_protocol::acyclic::health::key_fault`].
    Reported(u8),
}

impl KeyFault {
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

/// Findings about the keys of a board, by slot.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct GuardFindings {
    /// Fault of each muted key.
    pub muted: [Option<KeyFault>; MOST_KEYS],
    /// Keys whose force was halved because they shook, slot 0 in bit 0.
    pub softened: u16,
    /// Keys whose motor is not proven yet because they never came to rest.
    pub unproven: u16,
    pub misplaced: u16,
    /// Discarded readings that left the trend and returned.
    pub glitches: u64,
    /// Ticks in which the rise of a force was limited.
    pub limited: u64,
    pub blended: u64,
}
