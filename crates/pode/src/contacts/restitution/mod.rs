//! Rigid contacts that close together, or against each other, at one instant.
//!
//! Contacts i = 0 .. N close with the velocities v (negative closes), and impulses p ≥ 0 change
//! them by G p, with the Delassus matrix G = J M⁻¹ Jᵀ: `v⁺ = v + G p`. What else holds is a law,
//! and there are two of them, which differ as soon as contacts touch each other:
//!
//! | law | what it says | a row of equal balls, e = 1, one of them arrives |
//! |---|---|---|
//! | [`Contacts::sequential`] | one impact after another, each by Newton's `vᵢ⁺ = −eᵢ vᵢ` | the last ball leaves |
//! | [`Contacts::simultaneous`] | all at once: `v⁺ + e v ≥ 0`, `p ≥ 0`, one of both zero | the first bounces back from all others |
//!
//! The first is the limit of contacts with small gaps between them, the second Newton's law as
//! Moreau wrote it for many contacts `[Mor88]`, a linear complementarity problem `[PG96]`, `[Bro16]`.
//! Under both no contact closes afterwards, no impulse pulls, and no energy is made.
//!
//! # Where a law alone has no end
//!
//! Whatever the input, the answer comes after bounded work, and [`ImpactEnding`] says how:
//!
//! - A sequence may be infinite (for e < 1 three balls suffice) or very long. When the fastest
//!   closing has fallen below 2⁻⁴⁰ of the first one, or after [`MOST_IMPACTS`] impacts, what is
//!   left ends by the plastic law, `v⁺ ≥ 0`, `p ≥ 0`, one of both zero, which loses the most
//!   energy and always has a solution.
//! - Newton's law with coefficients that differ may have no solution, or make energy `[Bro16]`; the
//!   smallest of them then holds for all contacts, and it has one, and makes none.
//! - Newton's law may leave a contact closing that was opening before. That ends by the plastic
//!   law too.
//!
//! # Examples
//!
//! ```
//! use pode::contacts::restitution::{ContactJacobian, ImpactEnding};
//!
//! // Three balls of 1 kg that touch; the first one arrives with 1 m/s.
//! let row = ContactJacobian {
//!     rows: [[-1.0, 1.0, 0.0], [0.0, -1.0, 1.0]],
//!     inverse_mass: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
//! };
//! let before = [1.0, 0.0, 0.0];
//! let contacts = row.contacts(&before, [1.0; 2]);
//!
//! let one_by_one = contacts.sequential();
//! assert_eq!(row.speeds_after(&before, &one_by_one.impulses), [0.0, 0.0, 1.0]);
//! assert_eq!((one_by_one.impacts, one_by_one.ending), (2, ImpactEnding::Law));
//!
//! let at_once = row.speeds_after(&before, &contacts.simultaneous().impulses);
//! assert!((at_once[0] + 1.0 / 3.0).abs() < 1e-15 && (at_once[2] - 2.0 / 3.0).abs() < 1e-15);
//! ```

mod complementarity;
mod jacobian;
mod sequence;
mod simultaneous;

pub use jacobian::ContactJacobian;
pub use sequence::MOST_IMPACTS;

/// What is smaller than this part of the velocities that it is a sum of is rounding.
const ROUNDING: f64 = 256.0 * f64::EPSILON;

/// A contact is closed if it closes slower than this part of the largest velocity: rounding grows
/// where contacts are nearly parallel.
const CLOSED: f64 = 1e-9;

/// Rigid contacts at one instant, before their impacts.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Contacts<const N: usize> {
    /// Delassus matrix G: the velocity that contact i gains per impulse at contact j (1/kg);
    /// symmetric and positive semidefinite.
    pub delassus: [[f64; N]; N],
    /// Rates of the gaps (m/s): negative where a contact closes.
    pub velocities: [f64; N],
    /// Coefficients of restitution, held to 0 ..= 1.
    pub restitution: [f64; N],
}

/// How the impacts of an instant came to their end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ImpactEnding {
    /// By the law alone.
    Law,
    /// By the simultaneous law with the smallest coefficient of restitution for all contacts.
    SmallestRestitution,
    /// What the law left closing was ended by the plastic law.
    Plastic,
    /// Something closes still, because no impulses can prevent it: the velocities are not those
    /// of any bodies with this matrix, or not finite.
    Contradiction,
}

/// Impulses and velocities after the impacts, and how they ended.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Resolved<const N: usize> {
    /// Impulse at each contact (N s), never negative.
    pub impulses: [f64; N],
    /// Rates of the gaps after (m/s); none is negative.
    pub velocities: [f64; N],
    /// Impacts that were followed one by one.
    pub impacts: u32,
    pub ending: ImpactEnding,
}

impl<const N: usize> Contacts<N> {
    /// The same where only the contacts that touch take part: the others take no impulse.
    #[must_use]
    pub fn among(mut self, touches: [bool; N]) -> Self {
        for (i, _) in touches.iter().enumerate().filter(|(_, touches)| !**touches) {
            self.delassus[i] = [0.0; N];
            self.delassus.iter_mut().for_each(|row| row[i] = 0.0);
            self.velocities[i] = 0.0;
        }
        self
    }

    /// The coefficient of restitution of contact `i` as it is used.
    fn restitution_at(&self, i: usize) -> f64 {
        self.restitution[i].clamp(0.0, 1.0)
    }

    /// The velocities (m/s) after `impulses` (N s).
    fn velocities_after(&self, impulses: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|i| {
            let gains = self.delassus[i].iter().zip(impulses).map(|(g, p)| g * p);
            self.velocities[i] + gains.sum::<f64>()
        })
    }

    /// Size of the terms of each velocity after `impulses` (m/s).
    fn sizes(&self, impulses: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|i| {
            let gains = self.delassus[i].iter().zip(impulses).map(|(g, p)| (g * p).abs());
            self.velocities[i].abs() + gains.sum::<f64>()
        })
    }

    /// Applies the plastic law to what the impulses of `resolved` leave closing; again where
    /// nearly parallel contacts have left something by rounding.
    fn ended_plastically(&self, mut resolved: Resolved<N>) -> Resolved<N> {
        const ROUNDS: usize = 4;
        resolved.ending = ImpactEnding::Plastic;
        for _ in 0..ROUNDS {
            let sizes = self.sizes(&resolved.impulses);
            let (more, _) = complementarity::solve(&self.delassus, &resolved.velocities, &sizes);
            resolved.impulses = core::array::from_fn(|i| resolved.impulses[i] + more[i]);
            resolved.velocities = self.velocities_after(&resolved.impulses);
            let closes = |(v, size): (&f64, f64)| *v < -CLOSED * size;
            if !resolved.velocities.iter().zip(sizes).any(closes) {
                break;
            }
        }
        resolved
    }

    /// Puts what closes within rounding to zero, and tells if something closes all the same.
    fn checked(&self, mut resolved: Resolved<N>) -> Resolved<N> {
        let sizes = self.sizes(&resolved.impulses);
        let largest = sizes.iter().fold(0.0, |most: f64, size| most.max(*size));
        for v in &mut resolved.velocities {
            if *v < 0.0 && *v >= -CLOSED * largest {
                *v = 0.0;
            }
            if *v < 0.0 || !v.is_finite() {
                resolved.ending = ImpactEnding::Contradiction;
            }
        }
        resolved
    }
}
