//! Poisson's law: compression of all contacts, then expansion.

use super::{Contacts, ImpactEnding, Resolved, complementarity};

impl<const N: usize> Contacts<N> {
    /// Resolves all impacts in two phases `[PG96]`: impulses q that stop all closing, then at least
    /// `e q` at each contact. The smallest coefficient serves for all where different ones would
    /// generate energy.
    ///
    /// # Real-time
    /// At most eight complementarity problems of N contacts.
    pub fn in_phases(&self) -> Resolved<N> {
        let own = core::array::from_fn(|i| self.restitution_at(i));
        let resolved = self.expanded(&own, ImpactEnding::Law);
        if !self.gains_energy(&resolved) {
            return self.ended(resolved);
        }
        let smallest = [self.smallest_restitution(); N];
        self.ended(self.expanded(&smallest, ImpactEnding::SmallestRestitution))
    }

    fn expanded(&self, restitution: &[f64; N], ending: ImpactEnding) -> Resolved<N> {
        let sizes = self.velocities.map(f64::abs);
        let (stopping, _) = complementarity::solve(&self.delassus, &self.velocities, &sizes);
        let given = core::array::from_fn(|i| (1.0 + restitution[i]) * stopping[i]);
        let velocities = self.velocities_after(&given);
        let (more, _) = complementarity::solve(&self.delassus, &velocities, &self.sizes(&given));
        let impulses = core::array::from_fn(|i| given[i] + more[i]);
        let velocities = self.velocities_after(&impulses);
        Resolved { impulses, velocities, impacts: 0, ending }
    }
}
