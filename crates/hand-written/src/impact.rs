//! Newton's law of impact, and when the impacts that follow are over.

/// A rebound slower than this is none (m/s): under gravity it would last 20 ps.
const STILL: f64 = 1e-10;

/// Bodies that part slower than this (m/s) while their guard fires all the same: their hop
/// is lost in the rounding of a place of 1 m, up to 5 km/s² of pressing.
const HOP: f64 = 1e-5;

/// Two bodies that meet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Meeting {
    /// Speed at which they approach (m/s); negative when they part already.
    pub(crate) closing: f64,
    /// Acceleration at which they approach while free (m/s²).
    pub(crate) pressing: f64,
    /// Speed after over speed before, 0 ..= 1.
    pub(crate) restitution: f64,
}

/// What a meeting leads to.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Parting {
    /// They part already: an input that jumped put one into the other.
    Already,
    Together,
    /// They part at this speed (m/s); `settles` (s) after, the impacts are over.
    Rebound {
        speed: f64,
        settles: Option<f64>,
    },
}

impl Meeting {
    /// v⁺ = e v⁻; impacts under the acceleration a accumulate after 2 v⁺/(a (1 − e)).
    pub(crate) fn part(&self) -> Parting {
        let Self { closing, pressing, restitution } = *self;
        let speed = restitution * closing;
        if closing < -HOP {
            Parting::Already
        } else if speed <= STILL {
            Parting::Together
        } else {
            let accumulate = restitution < 1.0 && pressing > 0.0;
            let after = 2.0 * speed / (pressing * (1.0 - restitution));
            Parting::Rebound { speed, settles: accumulate.then_some(after) }
        }
    }
}
