//! All impacts at once: Newton's law for many contacts in Moreau's form.

use super::complementarity::{self, Solution};
use super::{Contacts, ImpactEnding, ROUNDING, Resolved};

impl<const N: usize> Contacts<N> {
    /// Resolves all impacts at once: `v⁺ + e v ≥ 0`, `p ≥ 0`, and one of both is zero. See the
    /// [module](super) for different coefficients, and for contacts left closing.
    ///
    /// # Real-time
    /// At most six complementarity problems of N contacts.
    pub fn simultaneous(&self) -> Resolved<N> {
        let own = core::array::from_fn(|i| self.restitution_at(i));
        let resolved = self.newton(&own, ImpactEnding::Law).unwrap_or_else(|| {
            let smallest = self.smallest_restitution();
            let (ending, idle) = (ImpactEnding::SmallestRestitution, self.untouched());
            self.newton(&[smallest; N], ending).unwrap_or(idle)
        });
        self.ended(resolved)
    }

    /// Ends closing that the law has left by the plastic law.
    pub(super) fn ended(&self, resolved: Resolved<N>) -> Resolved<N> {
        let sizes = self.sizes(&resolved.impulses);
        let is_over = resolved.velocities.iter().zip(sizes).all(|(v, size)| *v >= -ROUNDING * size);
        self.checked(if is_over { resolved } else { self.ended_plastically(resolved) })
    }

    /// Applies Newton's law; `None` if it has no solution or generates energy.
    fn newton(&self, restitution: &[f64; N], ending: ImpactEnding) -> Option<Resolved<N>> {
        let asked = core::array::from_fn(|i| (1.0 + restitution[i]) * self.velocities[i]);
        let (impulses, solution) =
            complementarity::solve(&self.delassus, &asked, &asked.map(f64::abs));
        let velocities = self.velocities_after(&impulses);
        let resolved = Resolved { impulses, velocities, impacts: 0, ending };
        (solution == Solution::Exact && !self.gains_energy(&resolved)).then_some(resolved)
    }

    /// Returns `true` if the impulses do work on the bodies, p (v + v⁺) / 2.
    pub(super) fn gains_energy(&self, resolved: &Resolved<N>) -> bool {
        let (mut work, mut size) = (0.0, 0.0);
        let sizes = self.sizes(&resolved.impulses);
        for (i, impulse) in resolved.impulses.iter().enumerate() {
            work += impulse * (self.velocities[i] + resolved.velocities[i]);
            size += impulse * sizes[i];
        }
        work > ROUNDING * size
    }

    pub(super) fn smallest_restitution(&self) -> f64 {
        let moved = (0..N).filter(|i| self.delassus[*i][*i] > 0.0);
        moved.map(|i| self.restitution_at(i)).fold(1.0, f64::min)
    }

    fn untouched(&self) -> Resolved<N> {
        let ending = ImpactEnding::Law;
        Resolved { impulses: [0.0; N], velocities: self.velocities, impacts: 0, ending }
    }
}
