use firmware_protocol::acyclic::{Operation, Status};

/// State of a board's bring-up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArmState {
    Greeting,
    /// The homing state of its encoders is requested.
    Checking,
    Streaming,
    /// It sends samples, whose rate must be the one that it confirmed.
    Measuring,
    Disarming,
    Arming {
        nonce: u32,
    },
    /// It reports that it is armed; samples that confirm it are awaited.
    Confirming,
    Armed,
    /// It may not be armed until a person has fixed the cause, or a pause has passed.
    Barred(ArmLockout),
}

impl ArmState {
    /// Returns the request whose answer ends this state.
    pub const fn waits_for(self) -> Option<Operation> {
        match self {
            Self::Greeting => Some(Operation::Hello),
            Self::Checking => Some(Operation::BoardHealth),
            Self::Streaming => Some(Operation::Stream),
            Self::Disarming => Some(Operation::Disarm),
            Self::Arming { .. } => Some(Operation::Arm),
            Self::Measuring | Self::Confirming | Self::Armed | Self::Barred(_) => None,
        }
    }

    pub const fn is_barred(self) -> bool {
        matches!(self, Self::Barred(_))
    }
}

/// Reason why a board may not be armed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArmLockout {
    /// It renders no force, for this reason.
    Latched(u8),
    /// It declined a request with this status.
    Declined(Operation, Status),
    /// Another board has taken its place, or its firmware was changed.
    Exchanged,
    /// Its clock runs too fast by this drift (1e-6), beyond the limit.
    Clock(i32),
    /// It reported that it was armed, and sent no samples.
    NoSamples,
    /// It reported that it was armed, and sent unreadable samples.
    Unreadable,
    /// It reported that it was armed, but its samples report that it renders no force.
    StaysSafe,
    /// Its samples are so old on arrival (ms) that no force can answer them in time.
    Late(u16),
    /// Its encoders do not know the positions of these keys, slot 0 in bit 0.
    NotHomed(u16),
    /// Its samples are farther apart than agreed.
    Slow(SlowSamples),
    /// Its samples arrive in bursts at this interval (us).
    Bursts(u32),
    /// It has restarted too often; `reason` is the last one, as in its hello.
    Restarting { times: u8, reason: u8 },
}

/// Sample intervals above the agreed one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SlowSamples {
    pub median_us: u16,
    pub agreed_us: u16,
}

impl ArmLockout {
    /// Returns `true` if the board is tried again after a pause.
    pub(super) const fn ends(self) -> bool {
        match self {
            Self::Declined(..)
            | Self::NoSamples
            | Self::Unreadable
            | Self::StaysSafe
            | Self::Late(_)
            | Self::NotHomed(_)
            | Self::Slow(_)
            | Self::Bursts(_) => true,
            Self::Latched(_) | Self::Exchanged | Self::Clock(_) | Self::Restarting { .. } => false,
        }
    }
}
