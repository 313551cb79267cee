//! Bracketed root finding with a fixed maximum: ITP, seeded by the guard's cubic.
//!
//! A deadline is about the maximum: ITP never needs more than bisection plus one,
//! where Brent, Chandrupatla and Illinois reach 2–5 times bisection on 3/2-power guards.

/// A crossing shut in: positive at `lo`, not positive at `hi`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bracket {
    /// Before the crossing.
    pub lo: f64,
    /// The guard there, positive.
    pub at_lo: f64,
    /// At or after the crossing.
    pub hi: f64,
    /// The guard there, zero or negative.
    pub at_hi: f64,
}

impl Bracket {
    /// Moves the end on the side of `value` to `tau`.
    #[inline]
    fn narrow(&mut self, tau: f64, value: f64) {
        if value > 0.0 {
            (self.lo, self.at_lo) = (tau, value);
        } else {
            (self.hi, self.at_hi) = (tau, value);
        }
    }

    #[inline]
    fn width(&self) -> f64 {
        self.hi - self.lo
    }

    /// Where the chord through both ends vanishes.
    #[inline]
    fn chord(&self) -> f64 {
        let tau = (self.hi * self.at_lo - self.lo * self.at_hi) / (self.at_lo - self.at_hi);
        if tau.is_finite() { tau.clamp(self.lo, self.hi) } else { self.hi }
    }
}

/// Where a crossing was found.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Located {
    /// The crossing, as a fraction of the step.
    pub tau: f64,
    /// Evaluations of the guard that it took.
    pub evaluations: u32,
    /// A guard value was not finite; the search stopped at once.
    pub not_finite: bool,
}

/// Locates the crossing in `bracket` to a width of `tolerance`.
///
/// `seed` is where a model of the guard vanishes, with its `slope` there.
/// Takes at most the bisections that the tolerance asks for plus three evaluations of `guard`.
///
/// # References
/// Oliveira & Takahashi 2020 [OT20], with κ1 = 0.2/(b − a), κ2 = 2, n0 = 1.
pub fn locate(
    mut guard: impl FnMut(f64) -> f64,
    mut bracket: Bracket,
    seed: Option<(f64, f64)>,
    tolerance: f64,
) -> Located {
    let most = most_evaluations(tolerance);
    let mut located = Located { tau: bracket.hi, evaluations: 0, not_finite: false };
    let mut evaluate = |tau: f64, located: &mut Located, bracket: &mut Bracket| {
        located.evaluations += 1;
        let value = guard(tau);
        located.not_finite |= !value.is_finite();
        bracket.narrow(tau, value);
        value
    };
    if let Some((tau, slope)) = seed.filter(|(tau, _)| *tau > bracket.lo && *tau < bracket.hi) {
        // One look at the seed and one beyond where its slope says the root is.
        let value = evaluate(tau, &mut located, &mut bracket);
        let reach = 2.0 * value / slope.abs();
        let beyond = tau + if reach.abs() > tolerance { reach } else { tolerance.copysign(value) };
        if beyond > bracket.lo && beyond < bracket.hi {
            evaluate(beyond, &mut located, &mut bracket);
        }
    }
    let itp = Itp::new(&bracket, tolerance);
    for round in 0..most {
        if bracket.width() <= tolerance || bracket.at_hi == 0.0 || located.not_finite {
            break;
        }
        let tau = itp.probe(&bracket, round);
        evaluate(tau, &mut located, &mut bracket);
    }
    located.tau = bracket.chord();
    located
}

/// Most evaluations of one search to `tolerance`: two looks, bisection, and one.
pub(crate) const fn most_evaluations(tolerance: f64) -> u32 {
    let mut halvings = 0;
    let mut width = 1.0;
    while width > tolerance && halvings < 60 {
        width *= 0.5;
        halvings += 1;
    }
    halvings + 3
}

/// The constants of one interpolate-truncate-project search.
struct Itp {
    truncation: f64,
    /// Radius that bisection plus one would have at round 0.
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

    /// The next place to look.
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
