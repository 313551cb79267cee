//! A guard's cubic Hermite over one step, with its extrema and roots.

use crate::math::sqrt;

/// Interior local maximum and minimum of a cubic, each if there is one in (0, 1).
pub(crate) type Turns = (Option<f64>, Option<f64>);

/// p(τ) = a + b τ + c τ² + d τ³ on 0 ..= 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cubic {
    a: f64,
    b: f64,
    c: f64,
    d: f64,
}

impl Cubic {
    /// Builds the cubic with values `g0`, `g1` and slopes `d0`, `d1` (per step) at the ends.
    #[inline]
    pub(crate) fn hermite(g0: f64, d0: f64, g1: f64, d1: f64) -> Self {
        let rise = g1 - g0;
        Self { a: g0, b: d0, c: 3.0 * rise - 2.0 * d0 - d1, d: d0 + d1 - 2.0 * rise }
    }

    /// Second derivative at the start, halved.
    pub(crate) const fn curvature(&self) -> f64 {
        self.c
    }

    pub(crate) fn at(&self, tau: f64) -> f64 {
        self.a + tau * (self.b + tau * (self.c + tau * self.d))
    }

    pub(crate) fn slope(&self, tau: f64) -> f64 {
        self.b + tau * (2.0 * self.c + tau * 3.0 * self.d)
    }

    pub(crate) fn bend(&self, tau: f64) -> f64 {
        2.0 * self.c + tau * 6.0 * self.d
    }

    #[inline]
    pub(crate) fn is_concave(&self) -> bool {
        self.c <= 0.0 && self.c + 3.0 * self.d <= 0.0
    }

    pub(crate) fn turns(&self) -> Turns {
        let inside = |tau: f64| (tau > 0.0 && tau < 1.0).then_some(tau);
        let discriminant = self.c * self.c - 3.0 * self.b * self.d;
        if discriminant <= 0.0 {
            return (None, None);
        }
        // p'(τ) = b + 2c τ + 3d τ², by the form that loses no digits.
        let q = -(self.c + self.c.signum() * sqrt(discriminant));
        let (r, s) = (q / (3.0 * self.d), self.b / q);
        let (first, second) = if r < s { (r, s) } else { (s, r) };
        let turns = [first, second].map(|tau| if tau.is_finite() { inside(tau) } else { None });
        let is_minimum = |tau: f64| self.c + 3.0 * self.d * tau > 0.0;
        let minimum = turns.into_iter().flatten().find(|tau| is_minimum(*tau));
        let maximum = turns.into_iter().flatten().find(|tau| !is_minimum(*tau));
        (maximum, minimum)
    }

    /// Returns the first root in (`lo`, `hi`] reached from above, if any, by the `turns`.
    pub(crate) fn first_root(&self, turns: Turns, lo: f64, hi: f64) -> Option<f64> {
        let clipped = |turn: Option<f64>| turn.map_or(hi, |tau| tau.clamp(lo, hi));
        let (maximum, minimum) = (clipped(turns.0), clipped(turns.1));
        let mut from = lo;
        for to in [maximum.min(minimum), maximum.max(minimum), hi] {
            if self.at(from) > 0.0 && self.at(to) <= 0.0 {
                return Some(self.root_between(from, to));
            }
            from = to;
        }
        None
    }

    /// Returns the falling root of the parabola through both ends with the slope at the start, and
    /// the slope there; NaN or outside the step if there is none.
    #[inline]
    fn parabola_root(&self) -> (f64, f64) {
        let c = self.c + self.d;
        let fall = sqrt(self.b * self.b - 4.0 * self.a * c);
        // a + b τ + c τ² = 0 with the slope −fall, by the form that loses no digits.
        let tau =
            if self.b > 0.0 { -0.5 * (self.b + fall) / c } else { 2.0 * self.a / (fall - self.b) };
        (tau, fall)
    }

    /// Returns the root of a monotone stretch, by Newton kept inside its bracket.
    #[inline]
    pub(crate) fn root_between(&self, mut lo: f64, mut hi: f64) -> f64 {
        /// Newton doubles its digits: 12 rounds reach the last one; bisection covers the flat ends.
        const ROUNDS: usize = 12;
        /// A Newton step this short leaves its square as error.
        const LAST: f64 = 1e-9;
        /// Relative size of the cubic's term that is rounding: the parabola's root is the cubic's.
        const STRAIGHT: f64 = 1e-14;
        let (start, fall) = self.parabola_root();
        let is_inside = start > lo && start < hi;
        if is_inside && self.d.abs() <= STRAIGHT * fall {
            return start;
        }
        let mut tau = if is_inside { start } else { 0.5 * (lo + hi) };
        for _ in 0..ROUNDS {
            let value = self.at(tau);
            if value > 0.0 {
                lo = tau;
            } else {
                hi = tau;
            }
            let next = tau - value / self.slope(tau);
            let is_last = (next - tau).abs() <= LAST;
            let is_inside = next > lo && next < hi;
            tau = match (is_inside, is_last) {
                (true, _) => next,
                (false, true) => tau,
                (false, false) => 0.5 * (lo + hi),
            };
            if is_last {
                break;
            }
        }
        tau
    }
}
