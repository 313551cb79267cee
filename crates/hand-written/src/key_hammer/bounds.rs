//! What the geometry of models A and B can do over one step.

use pode::GuardBound;
use pode::math::sqrt;

use super::KeyHammerValues;
use crate::bounds::TermBound;

/// Bound of the gap between slider and hammer over a step in which both angles go so far.
///
/// gap = L4 cos θh − L3 sin θh − L1 sin δ, δ = θk − θh. Hammer and key go together, and the
/// slopes are small where they do: ∂/∂θh = (L1 − L3) cos θh − L4 sin θh + L1 (cos δ − cos θh),
/// of which the last is at most L1 |θk| (|θh| + |θk|/2). As for ∂²/∂θh², which holds
/// L1 sin δ + L3 sin θh: sin δ + sin θh is at most |θk|. All others are L1 sin δ.
#[expect(clippy::inline_always, reason = "asked for in every step")]
#[inline(always)]
pub(crate) fn gap_bound(p: &KeyHammerValues, hammer: TermBound, key: TermBound) -> GuardBound {
    let (l1, apart, rise) = (p.l1, (p.l1 - p.l3).abs(), p.l4.abs());
    let slope = apart + l1 * key.size * (hammer.size + 0.5 * key.size) + rise * hammer.size;
    let own = l1 * key.size + rise + apart * hammer.size;
    let mixed = l1 * (hammer.size + key.size).min(1.0);
    GuardBound::new(
        slope * hammer.moves + l1 * key.moves,
        slope * hammer.bend
            + l1 * key.bend
            + own * hammer.speed * hammer.speed
            + mixed * key.speed * (key.speed + 2.0 * hammer.speed),
    )
}

/// Bounds of what the slider's place along the hammer makes of the key's angle s, for a hammer
/// on a rigid key: p = θh' per s', q = −σ' per s' over σ, r = 1/σ.
///
/// With R = |P1 P2|, p = L1 (σ² + L1² − R²)/(2 L1 σ²) and q = −L1 (L3 sin s − L4 cos s)/σ².
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReachBounds {
    /// Bound of |p|, rad of the hammer per rad of the key.
    pub(crate) along: f64,
    /// Bound of |q|, the part of its reach per rad of the key.
    pub(crate) across: f64,
    /// r (1/m).
    pub(crate) inverse: f64,
}

impl ReachBounds {
    /// Over |s| ≤ `most` (rad): p and r are largest where the slider is nearest to P2.
    pub(crate) fn over(p: &KeyHammerValues, most: f64) -> Self {
        let inverse = 1.0 / (p.l1 - sqrt(p.l3 * p.l3 + p.l4 * p.l4)).abs();
        let across = p.l3.abs() * most.min(1.0) + p.l4.abs();
        Self { along: p.l1 * inverse, across: p.l1 * across * inverse * inverse, inverse }
    }
}
