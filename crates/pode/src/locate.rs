//! Bracketed root finding with a fixed maximum: ITP, seeded by the guard's cubic.
//!
//! A deadline is about the maximum: ITP never needs more than bisection plus one, where Brent,
//! Chandrupatla and Illinois reach 2–5 times bisection on 3/2-power guards.

/// A bracketed crossing: positive at `lo`, not positive at `hi`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bracket {
    pub lo: f64,
    pub at_lo: f64,
    pub hi: f64,
    pub at_hi: f64,
}

impl Bracket {
    #[inline]
    fn width(&self) -> f64 {
        self.hi - self.lo
    }

    #[inline]
    fn chord(&self) -> f64 {
        let tau = (self.hi * self.at_lo - self.lo * self.at_hi) / (self.at_lo - self.at_hi);
        // Not `clamp`, which panics where the ends are not in order.
        if tau.is_finite() { tau.max(self.lo).min(self.hi) } else { self.hi }
    }

    /// Returns `true` if the guard jumps in the bracket, first `whole`: steeper than any root.
    fn holds_jump(&self, whole: &Self) -> bool {
        let [drop, most] = [self, whole].map(|it| it.at_lo - it.at_hi);
        // A square root's drop shrinks like the root of the width, a jump's does not shrink.
        let left = drop / most;
        left * left * whole.width() > self.width()
    }
}

/// A located crossing of a guard.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Located {
    /// The crossing, as a fraction of the step.
    pub tau: f64,
    pub evaluations: u32,
    /// `true` if a guard value was not finite, which stops the search at once.
    pub not_finite: bool,
}

/// Locates the crossing in `bracket`, at most 1 wide, to a width of `tolerance`.
///
/// `seed` is the root of a model of the guard, with its `slope` there. `guard` is evaluated at most
/// four times more than bisection to the tolerance needs. A guard that rests at zero is located
/// where it turns negative, one that jumps is located after the jump.
///
/// Oliveira & Takahashi 2020 `[OT20]`, with κ1 = 0.2/(b − a), κ2 = 2, n0 = 1.
pub fn locate(
    guard: impl FnMut(f64) -> f64,
    bracket: Bracket,
    seed: Option<(f64, f64)>,
    tolerance: f64,
) -> Located {
    let mut search = RootSearch::new(guard, bracket, tolerance);
    if let Some((tau, slope)) = seed {
        search.look_around(tau, slope);
    }
    if !search.is_over() {
        search.narrow();
    }
    let end = search.bracket;
    let tau = if end.holds_jump(&bracket) { end.hi } else { end.chord() };
    Located { tau, evaluations: search.evaluations, not_finite: search.not_finite }
}

/// Maximum of evaluations in one search: two at the seed, one past a zero, and bisection plus one.
pub(crate) const fn most_evaluations(tolerance: f64) -> u32 {
    halvings(tolerance) + 4
}

/// Halvings from 1 to `tolerance`, at most 60, since a fraction has no more digits.
const fn halvings(tolerance: f64) -> u32 {
    const MOST: u32 = 60;
    const ONE: u32 = 1023;
    // The exponent: the largest power of two not above the tolerance. A negative tolerance has its
    // sign in that field, and needs as few halvings as one above 1.
    let exponent = (tolerance.to_bits() >> 52) as u32;
    let halvings = ONE.saturating_sub(exponent);
    if halvings < MOST && tolerance > 0.0 { halvings } else { MOST }
}

struct RootSearch<G> {
    guard: G,
    bracket: Bracket,
    tolerance: f64,
    evaluations: u32,
    not_finite: bool,
    /// `true` if the guard rests at zero over a stretch: zero then counts as before the crossing.
    is_flat: bool,
}

impl<G: FnMut(f64) -> f64> RootSearch<G> {
    const fn new(guard: G, bracket: Bracket, tolerance: f64) -> Self {
        Self { guard, bracket, tolerance, evaluations: 0, not_finite: false, is_flat: false }
    }

    fn is_over(&self) -> bool {
        self.bracket.width() <= self.tolerance || self.bracket.at_hi == 0.0 || self.not_finite
    }

    /// Evaluates at the seed, and beyond the root that its slope predicts.
    fn look_around(&mut self, seed: f64, slope: f64) {
        if !self.is_inside(seed) {
            return;
        }
        // Not divided by the slope after the evaluation, which would wait for the division.
        let per_value = 2.0 / slope.abs();
        let value = self.look(seed);
        let reach = value * per_value;
        // A little less than the tolerance: the sum rounds.
        let least = (0.99 * self.tolerance).copysign(value);
        let beyond = seed + if reach.abs() > self.tolerance { reach } else { least };
        if self.is_inside(beyond) {
            self.look(beyond);
        }
    }

    fn narrow(&mut self) {
        let itp = Itp::new(&self.bracket, self.tolerance);
        for round in 0..=halvings(self.tolerance) {
            if self.is_over() {
                break;
            }
            self.look(itp.probe(&self.bracket, round));
        }
    }

    fn is_inside(&self, tau: f64) -> bool {
        self.bracket.lo < tau && tau < self.bracket.hi
    }

    fn look(&mut self, tau: f64) -> f64 {
        let value = self.value(tau);
        if value == 0.0 && !self.is_flat {
            self.look_past_zero(tau);
        } else if value > 0.0 || (value == 0.0 && self.is_flat) {
            (self.bracket.lo, self.bracket.at_lo) = (tau, value);
        } else {
            (self.bracket.hi, self.bracket.at_hi) = (tau, value);
        }
        value
    }

    /// Accepts a zero as the crossing if the guard is negative just after it.
    fn look_past_zero(&mut self, tau: f64) {
        let past = tau + self.tolerance;
        let value = if past < self.bracket.hi { self.value(past) } else { self.bracket.at_hi };
        if value >= 0.0 && past < self.bracket.hi {
            self.is_flat = true;
            (self.bracket.lo, self.bracket.at_lo) = (past, value);
        } else {
            (self.bracket.hi, self.bracket.at_hi) = (tau, 0.0);
        }
    }

    fn value(&mut self, tau: f64) -> f64 {
        self.evaluations += 1;
        let value = (self.guard)(tau);
        self.not_finite |= !value.is_finite();
        value
    }
}

struct Itp {
    truncation: f64,
    /// Radius of bisection plus one at round 0.
    radius: f64,
}

impl Itp {
    fn new(bracket: &Bracket, tolerance: f64) -> Self {
        // ε 2^(n½ + n0) with ε half the tolerance, n½ the halvings needed and n0 = 1.
        let mut radius = tolerance;
        for _ in 0..64 {
            if radius >= bracket.width() {
                break;
            }
            radius *= 2.0;
        }
        Self { truncation: 0.2 / bracket.width(), radius }
    }

    fn probe(&self, bracket: &Bracket, round: u32) -> f64 {
        let middle = 0.5 * (bracket.lo + bracket.hi);
        let chord = bracket.chord();
        // Truncate: step from the chord's root towards the middle.
        let toward = middle - chord;
        let shift = self.truncation * bracket.width() * bracket.width();
        let truncated = if shift <= toward.abs() { chord + shift.copysign(toward) } else { middle };
        // Project: stay where bisection could still catch up.
        let scale = 1.0 / (1_u64 << round.min(63)) as f64;
        let radius = (self.radius * scale - 0.5 * bracket.width()).max(0.0);
        if (truncated - middle).abs() <= radius {
            truncated
        } else {
            middle - radius.copysign(toward)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2⁻²⁰, 2⁻⁴⁰ and 2⁻⁵⁰: coarse, usual, and near the last digit.
    const TOLERANCES: [f64; 3] =
        [1.0 / (1_u64 << 20) as f64, 1.0 / (1_u64 << 40) as f64, 1.0 / (1_u64 << 50) as f64];

    type Guard = fn(f64) -> f64;

    /// Guards that fall through zero at a given place, and are hard on root finders.
    const FAMILIES: [(&str, Guard); 11] = [
        ("line", |d| -d),
        ("parabola", |d| -d * (d + 1.5)),
        ("3/2 power", |d| -d.abs().sqrt() * d),
        ("square root", |d| -d.abs().sqrt().copysign(d)),
        ("ninth power", |d| -d.powi(9)),
        ("step", |d| if d < 0.0 { 1.0 } else { -1.0 }),
        ("lopsided step", |d| if d < 0.0 { 1e-12 } else { -1e12 }),
        ("late kink", |d| if d < 0.0 { -1e-9 * d } else { -1e9 * d }),
        ("steep", |d| -(1e8 * d).tanh()),
        ("exponential", |d| 1.0 - (30.0 * d).exp()),
        ("all but flat", |d| -d * (-1e-2 / (d * d + 1e-4)).exp()),
    ];

    fn bracket(guard: impl Fn(f64) -> f64, lo: f64, hi: f64) -> Bracket {
        Bracket { lo, at_lo: guard(lo), hi, at_hi: guard(hi) }
    }

    #[track_caller]
    fn check(name: &str, guard: Guard, root: f64, seed: Option<(f64, f64)>) {
        for tolerance in TOLERANCES {
            let guard = |tau: f64| guard(tau - root);
            let located = locate(guard, bracket(guard, 0.0, 1.0), seed, tolerance);
            let most = most_evaluations(tolerance);
            assert!(located.evaluations <= most, "{name}: {} of {most}", located.evaluations);
            // The bracket's width, and the rounding of τ − root.
            let error = (located.tau - root).abs();
            assert!(error <= tolerance + f64::EPSILON, "{name} at {root}: off by {error:e}");
            assert!(!located.not_finite, "{name}");
        }
    }

    fn roots() -> impl Iterator<Item = f64> {
        let inside = (1..40).map(|n| (f64::from(n) * 0.618_033_988_749_895).fract());
        [1e-15, 1e-9, 1e-3, 0.5, 0.75, 1.0 - 1e-9].into_iter().chain(inside)
    }

    #[test]
    fn no_guard_exceeds_the_maximum_without_a_seed() {
        for (name, guard) in FAMILIES {
            roots().for_each(|root| check(name, guard, root, None));
        }
    }

    #[test]
    fn no_guard_exceeds_the_maximum_with_a_misleading_seed() {
        for (name, guard) in FAMILIES {
            for seed in [(1e-12, -1e9), (0.3, -1.0), (0.5, 0.0), (0.999, 1e-9), (0.7, f64::NAN)] {
                roots().for_each(|root| check(name, guard, root, Some(seed)));
            }
        }
    }

    #[test]
    fn a_good_seed_takes_two_looks() {
        let guard = |tau: f64| 0.3 - tau;
        let whole = bracket(guard, 0.0, 1.0);
        let located = locate(guard, whole, Some((0.3 - 1e-15, -1.0)), TOLERANCES[1]);
        assert!(located.evaluations <= 2, "{}", located.evaluations);
        assert!((located.tau - 0.3).abs() < 1e-15, "{}", located.tau);
    }

    #[test]
    fn a_jump_is_located_on_its_far_side() {
        let guard = |tau: f64| if tau < 0.3 { 1.0 } else { -1.0 };
        for tolerance in TOLERANCES {
            let located = locate(guard, bracket(guard, 0.0, 1.0), None, tolerance);
            assert!(located.tau >= 0.3 && located.tau <= 0.3 + tolerance, "{}", located.tau);
        }
    }

    #[test]
    fn a_flat_stretch_is_located_at_its_end() {
        let guard = |tau: f64| (0.2 - tau).max(0.0) - (tau - 0.6).max(0.0);
        for tolerance in TOLERANCES {
            for seed in [None, Some((0.4, -1.0)), Some((0.1, -1.0))] {
                let located = locate(guard, bracket(guard, 0.0, 1.0), seed, tolerance);
                assert!((located.tau - 0.6).abs() <= tolerance + f64::EPSILON, "{}", located.tau);
                assert!(located.evaluations <= most_evaluations(tolerance));
            }
        }
    }

    #[test]
    fn a_value_that_is_not_finite_ends_the_search_at_once() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let whole = Bracket { lo: 0.0, at_lo: 1.0, hi: 1.0, at_hi: -1.0 };
            let located = locate(|_| bad, whole, None, 1e-12);
            assert!(located.not_finite && located.evaluations == 1, "{bad}: {located:?}");
        }
    }

    #[test]
    fn a_zero_at_the_end_is_the_crossing() {
        let whole = Bracket { lo: 0.0, at_lo: 1.0, hi: 1.0, at_hi: 0.0 };
        let located = locate(|tau| 1.0 - tau, whole, None, 1e-12);
        assert_eq!((located.tau.to_bits(), located.evaluations), (1.0_f64.to_bits(), 0));
    }
}
