//! One impact after another, each by Newton's law.

use super::{Contacts, ImpactEnding, ROUNDING, Resolved};

/// Maximum of impacts followed one by one before the plastic law ends the rest. A hundred times the
/// mass between a wall and a ball take 31, ten thousand times 314 `[Gal03]`.
pub const MOST_IMPACTS: u32 = 1024;

/// Fraction of the first closing below which the plastic law takes over.
const LEFT: f64 = 1.0 / ((1_u64 << 40) as f64);

impl<const N: usize> Contacts<N> {
    /// Resolves impacts one after another until nothing closes. The contact that closes fastest is
    /// next, and leaves with `vᵢ⁺ = −eᵢ vᵢ`; those that close equally fast strike together, by
    /// [`Self::simultaneous`]. See the [module](super) for infinite sequences.
    ///
    /// # Real-time
    /// At most [`MOST_IMPACTS`] impacts of N additions or six complementarity problems each, and
    /// four of these problems.
    pub fn sequential(&self) -> Resolved<N> {
        let mut resolved = Resolved {
            impulses: [0.0; N],
            velocities: self.velocities,
            impacts: 0,
            ending: ImpactEnding::Law,
        };
        let fastest = self.velocities.iter().fold(0.0, |most: f64, v| most.max(-v));
        for _ in 0..MOST_IMPACTS {
            let Some(i) = self.next_impact(&resolved.velocities, fastest) else { break };
            let equals = self.equals(&resolved.velocities, i);
            if self.is_single(&equals) {
                self.strike(&mut resolved, i);
            } else {
                self.strike_together(&mut resolved, equals);
            }
        }
        let is_over = resolved.velocities.iter().all(|v| *v >= -ROUNDING * fastest);
        if is_over {
            return self.checked(resolved);
        }
        // Recomputed, without the rounding of all impacts.
        resolved.velocities = self.velocities_after(&resolved.impulses);
        self.checked(self.ended_plastically(resolved))
    }

    fn next_impact(&self, velocities: &[f64; N], fastest: f64) -> Option<usize> {
        let mut next = None;
        let mut slowest = -LEFT * fastest;
        for (i, v) in velocities.iter().enumerate() {
            if *v < slowest && self.delassus[i][i] > 0.0 {
                (next, slowest) = (Some(i), *v);
            }
        }
        next
    }

    /// Returns the contacts that close as fast as `i`, within rounding.
    fn equals(&self, velocities: &[f64; N], i: usize) -> [bool; N] {
        core::array::from_fn(|k| {
            let differs = (velocities[k] - velocities[i]).abs();
            k == i || (self.delassus[k][k] > 0.0 && differs <= ROUNDING * velocities[i].abs())
        })
    }

    /// Returns `true` if no two of `equals` move each other.
    fn is_single(&self, equals: &[bool; N]) -> bool {
        let is_moved = |i: usize, k: usize| i != k && equals[k] && self.delassus[i][k] != 0.0;
        (0..N).all(|i| !equals[i] || !(0..N).any(|k| is_moved(i, k)))
    }

    fn strike_together(&self, resolved: &mut Resolved<N>, equals: [bool; N]) {
        let now = Self { velocities: resolved.velocities, ..*self };
        let struck = now.among(equals).simultaneous();
        resolved.velocities = now.velocities_after(&struck.impulses);
        for (sum, impulse) in resolved.impulses.iter_mut().zip(struck.impulses) {
            *sum += impulse;
            resolved.impacts += u32::from(impulse > 0.0);
        }
    }

    fn strike(&self, resolved: &mut Resolved<N>, i: usize) {
        let closing = resolved.velocities[i];
        let e = self.restitution_at(i);
        let impulse = -(1.0 + e) * closing / self.delassus[i][i];
        for (v, row) in resolved.velocities.iter_mut().zip(&self.delassus) {
            *v += row[i] * impulse;
        }
        resolved.velocities[i] = -e * closing;
        resolved.impulses[i] += impulse;
        resolved.impacts += 1;
    }
}
