//! Reset maps made to be difficult.

use pode::{Reset, Settling};

use super::bytes::Bytes;
use super::{Adversary, MODES, STATE};

#[derive(Clone, Copy, Debug)]
enum Landing {
    Same,
    Counts,
    Bounces(f64),
    Rests,
    Moves(f64),
    Is(f64),
}

impl Landing {
    fn from_bytes(bytes: &mut Bytes<'_>) -> Self {
        match bytes.byte() % 12 {
            0..=1 => Self::Same,
            2..=3 => Self::Counts,
            4..=6 => Self::Bounces(bytes.odd(|it| it.sized(0.05, 1.1))),
            7..=8 => Self::Rests,
            9..=10 => Self::Moves(bytes.signed(1e-18, 1e-2)),
            _ => Self::Is(bytes.odd(|it| it.signed(1e-3, f64::MAX))),
        }
    }

    fn of(self, [t, n, z, w]: [f64; STATE]) -> [f64; STATE] {
        match self {
            Self::Same => [t, n, z, w],
            Self::Counts => [t, n + 1.0, z, w],
            Self::Bounces(e) => [t, n, 0.0, -e * w],
            Self::Rests => [t, n, 0.0, 0.0],
            Self::Moves(by) => [t + by, n, z, w],
            Self::Is(value) => [value; STATE],
        }
    }
}

#[derive(Clone, Copy, Debug)]
enum After {
    Nothing,
    /// A declared Zeno sequence of this length (s), with this ratio.
    Settles {
        after: f64,
        ratio: f64,
        impulse: f64,
        mode: u8,
        state: Landing,
    },
    Rests {
        mode: u8,
        state: Landing,
    },
}

impl After {
    fn from_bytes(bytes: &mut Bytes<'_>) -> Self {
        match bytes.byte() % 6 {
            0..=3 => Self::Nothing,
            4 => Self::Settles {
                after: bytes.odd(|it| it.sized(1e-9, 0.1)),
                ratio: bytes.odd(|it| it.sized(0.01, 1.1)),
                impulse: bytes.odd(|it| it.signed(1e-3, 1.0)),
                mode: bytes.byte() % MODES,
                state: Landing::from_bytes(bytes),
            },
            _ => Self::Rests { mode: bytes.byte() % MODES, state: Landing::from_bytes(bytes) },
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Effect {
    /// Modes ahead: 0 stays, and 1 visits all of them in turn.
    onward: u8,
    landing: Landing,
    impulse: f64,
    after: After,
}

impl Effect {
    pub fn from_bytes(bytes: &mut Bytes<'_>) -> Self {
        Self {
            onward: if bytes.is_true() { bytes.byte() % MODES } else { 0 },
            landing: Landing::from_bytes(bytes),
            impulse: bytes.odd(|it| it.signed(1e-3, 1.0)),
            after: After::from_bytes(bytes),
        }
    }

    pub fn bounce(bytes: &mut Bytes<'_>) -> Self {
        let after = After::Rests { mode: 1, state: Landing::Rests };
        let landing = Landing::Bounces(bytes.sized(0.05, 1.0));
        Self { onward: 0, landing, impulse: bytes.signed(1e-3, 1.0), after }
    }

    pub fn reset<'a>(&self, mode: u8, x: &[f64; STATE]) -> Reset<Adversary<'a>> {
        let next = (mode + self.onward) % MODES;
        let reset = Reset::to(next, self.landing.of(*x)).with_impulse(self.impulse);
        match self.after {
            After::Nothing => reset,
            After::Settles { after, ratio, impulse, mode, state } => {
                reset.settling(Settling { after, ratio, impulse, mode, state: state.of(*x) })
            }
            After::Rests { mode, state } => reset.resting(mode, state.of(*x)),
        }
    }
}
