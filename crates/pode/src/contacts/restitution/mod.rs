//! Rigid contacts that close together, or against each other, at one instant.
//!
//! Contacts i = 0 .. N close with the velocities v (negative closes), and impulses p ≥ 0 change
//! them by G p, with the Delassus matrix G = J M⁻¹ Jᵀ: `v⁺ = v + G p`. Three laws complete this, and
//! differ as soon as contacts touch each other:
//!
//! | law | statement | a row of equal balls, e = 1, one of them arrives |
//! |---|---|---|
//! | [`Contacts::sequential`] | one by one, each Newton's `vᵢ⁺ = −eᵢ vᵢ` | the last ball leaves |
//! | [`Contacts::simultaneous`] | `v⁺ + e v ≥ 0`, `p ≥ 0`, one zero | the first bounces back |
//! | [`Contacts::in_phases`] | impulses to a stop, then `e` times as much | the first bounces back |
//!
//! The first is the limit of contacts with small gaps between them, the second Newton's law as
//! Moreau wrote it for many contacts `[Mor88]`, the third Poisson's: linear complementarity problems
//! `[PG96]`, `[Bro16]`. After each, no contact closes, no impulse has pulled, and no energy was generated.
//!
//! # Where a law alone has no end
//!
//! The work is bounded for every input, and [`ImpactEnding`] names the end:
//!
//! - A sequence may be infinite (for e < 1 three balls suffice) or very long. When the fastest
//!   closing is below 2⁻⁴⁰ of the first one, or after [`MOST_IMPACTS`] impacts, the rest ends by
//!   the plastic law, `v⁺ ≥ 0`, `p ≥ 0`, one of both zero, which loses the most energy and always
//!   has a solution.
//! - Newton's law with different coefficients may have no solution, or generate energy `[Bro16]`;
//!   the smallest one for all contacts has a solution and generates none.
//! - Newton's law may leave a contact closing that was opening before; the plastic law ends it.
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
mod phases;
mod sequence;
mod simultaneous;

pub use jacobian::ContactJacobian;
pub use sequence::MOST_IMPACTS;

const ROUNDING: f64 = 256.0 * f64::EPSILON;

/// Fraction of the largest velocity below which closing counts as closed, for parallel contacts.
const CLOSED: f64 = 1e-9;

/// Law of the impacts of one instant.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum ImpactLaw {
    /// [`Contacts::sequential`]
    Sequential,
    /// [`Contacts::simultaneous`]
    #[default]
    Newton,
    /// [`Contacts::in_phases`]
    Poisson,
}

/// Rigid contacts at one instant, before their impacts.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Contacts<const N: usize> {
    /// Delassus matrix G: velocity of contact i per impulse at j (1/kg); positive semidefinite.
    pub delassus: [[f64; N]; N],
    /// Rates of the gaps (m/s): negative where a contact closes.
    pub velocities: [f64; N],
    /// Coefficients of restitution, clamped to 0 ..= 1.
    pub restitution: [f64; N],
}

/// End of an instant's impacts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ImpactEnding {
    Law,
    /// By the simultaneous law with the smallest coefficient of restitution for all contacts.
    SmallestRestitution,
    /// By the plastic law, for contacts that the law left closing.
    Plastic,
    /// A contact still closes: no bodies have these velocities and matrix, or one is not finite.
    Contradiction,
}

/// Impulses and velocities after the impacts, with their ending.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Resolved<const N: usize> {
    /// Impulse at each contact (N s), never negative.
    pub impulses: [f64; N],
    /// Rates of the gaps afterwards (m/s), none negative.
    pub velocities: [f64; N],
    pub impacts: u32,
    pub ending: ImpactEnding,
}

impl<const N: usize> Contacts<N> {
    /// Resolves the impacts by `law`.
    ///
    /// # Real-time
    /// That of the law's own function.
    pub fn resolved(&self, law: ImpactLaw) -> Resolved<N> {
        match law {
            ImpactLaw::Sequential => self.sequential(),
            ImpactLaw::Newton => self.simultaneous(),
            ImpactLaw::Poisson => self.in_phases(),
        }
    }

    /// Restricts the impacts to the contacts that touch: the others take no impulse.
    #[must_use]
    pub fn among(mut self, touches: [bool; N]) -> Self {
        for (i, _) in touches.iter().enumerate().filter(|(_, touches)| !**touches) {
            self.delassus[i] = [0.0; N];
            self.delassus.iter_mut().for_each(|row| row[i] = 0.0);
            self.velocities[i] = 0.0;
        }
        self
    }

    fn restitution_at(&self, i: usize) -> f64 {
        self.restitution[i].clamp(0.0, 1.0)
    }

    fn velocities_after(&self, impulses: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|i| {
            let gains = self.delassus[i].iter().zip(impulses).map(|(g, p)| g * p);
            self.velocities[i] + gains.sum::<f64>()
        })
    }

    fn sizes(&self, impulses: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|i| {
            let gains = self.delassus[i].iter().zip(impulses).map(|(g, p)| (g * p).abs());
            self.velocities[i].abs() + gains.sum::<f64>()
        })
    }

    /// Applies the plastic law to contacts left closing by `resolved`; repeatedly, since nearly
    /// parallel contacts leave something by rounding.
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

    /// Sets closing within rounding to zero, and reports a contact that closes nevertheless.
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
