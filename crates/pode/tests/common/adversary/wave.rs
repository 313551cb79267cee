//! Inputs made to be difficult.

use pode::input::{Cubic, Reconstruction, Reconstructor};
use pode::{Motion, Signal};

use super::bytes::Bytes;

#[derive(Clone, Copy, Debug)]
pub enum Wave {
    Smooth(Cubic),
    /// Another position from this fraction of the tick on.
    Jumps(f64, [f64; 2]),
    Gap(f64, f64),
    Shakes,
}

impl Wave {
    pub fn from_bytes(bytes: &mut Bytes<'_>, h: f64, samples: &mut Reconstructor) -> Self {
        let place = |bytes: &mut Bytes<'_>| bytes.odd(|it| it.signed(1e-6, 10.0));
        match bytes.byte() % 12 {
            0..=2 => Self::Smooth(Cubic::new([0.0; 4], h)),
            3..=4 => Self::Smooth(Cubic::new(std::array::from_fn(|_| place(bytes)), h)),
            5..=7 => Self::Smooth(samples.push(place(bytes))),
            8..=9 => Self::Jumps(bytes.part(), [place(bytes), place(bytes)]),
            10 => Self::Gap(bytes.part(), bytes.part()),
            _ => Self::Shakes,
        }
    }

    pub fn samples(bytes: &mut Bytes<'_>) -> Reconstructor {
        const KINDS: [Reconstruction; 4] = [
            Reconstruction::Hold,
            Reconstruction::Linear,
            Reconstruction::Quadratic,
            Reconstruction::LateHermite,
        ];
        Reconstructor::new(bytes.pick(&KINDS), 0.0, bytes.odd(|_| 1e-3))
    }
}

impl Signal<Motion> for Wave {
    fn at(&self, theta: f64) -> Motion {
        let held = |position: f64| Motion { position, ..Motion::default() };
        match *self {
            Self::Smooth(cubic) => cubic.at(theta),
            Self::Jumps(at, [before, after]) => held(if theta < at { before } else { after }),
            Self::Gap(from, to) => held(if (from..to).contains(&theta) { f64::NAN } else { 0.0 }),
            Self::Shakes => held((theta.to_bits() % 5) as f64 - 2.0),
        }
    }
}
