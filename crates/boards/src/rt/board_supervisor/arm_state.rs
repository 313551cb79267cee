//! The states of a board's bring-up, and why it may end without a force.

use firmware_protocol::acyclic::{Operation, Status};

/// How far a board has been brought up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArmState {
    /// It is asked for its hello.
    Greeting,
    /// It is asked whether its encoders know where their keys are.
    Checking,
    /// It is asked for samples.
    Streaming,
    /// It sends samples: they must come as often as it has confirmed.
    Measuring,
    /// It is asked for a nonce.
    Disarming,
    /// It is told to render forces.
    Arming {
        nonce: u32,
    },
    /// It says that it renders forces; samples that say so too are waited for.
    Confirming,
    Armed,
    /// It may not be armed until a person has seen to it, or a while has passed.
    Barred(ArmLockout),
}

impl ArmState {
    /// Returns the request whose answer leads on from this state.
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

    /// Tells whether the board may not be armed.
    pub const fn is_barred(self) -> bool {
        matches!(self, Self::Barred(_))
    }
}

/// Why a board may not be armed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArmLockout {
    /// It renders no force, for this reason.
    Latched(u8),
    /// It answered a request with this status.
    Declined(Operation, Status),
    /// Another board has taken its place, or its firmware was changed.
    Exchanged,
    /// Its clock runs too fast by so much (1e-6), more than is accepted.
    Clock(i32),
    /// It said that it was armed, and sent no samples.
    NoSamples,
    /// It said that it was armed, and sent samples that cannot be read.
    Unreadable,
    /// It said that it was armed, and its samples that it renders no force.
    StaysSafe,
    /// Its samples are so old when they come (ms) that no force can answer them in time.
    Late(u16),
    /// Its encoders do not know where these keys are, slot 0 in bit 0.
    NotHomed(u16),
    /// Its samples are farther apart than agreed.
    Slow(SlowSamples),
    /// Its samples come in bursts, so far apart (us).
    Bursts(u32),
    /// It has restarted so often, the last time for this reason (as in its hello).
    Restarting { times: u8, reason: u8 },
}

/// Samples that are farther apart than agreed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SlowSamples {
    /// The median (us).
    pub median_us: u16,
    /// What was agreed (us).
    pub agreed_us: u16,
}

impl ArmLockout {
    /// Tells whether the board is tried again after a while.
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
