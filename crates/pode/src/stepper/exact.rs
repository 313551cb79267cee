use crate::dense::{Cubic, Dense, DenseBounds, Polynomial};
use crate::nature::{EquationKind, Nature};
use crate::part::Part;
use crate::state::Matrix as _;
use crate::state::State;
use crate::stepper::{Field, Memory, Rk4, Step, Stepper};

/// The exact flow where a mode is linear, [`Rk4`] where it is not.
///
/// x' = A x + r(t) is solved by its Taylor series to the last digit. Each term is one product with
/// A, and the series is the dense output as well, so that an event lies on the exact flow and costs
/// no step of its own. No energy is generated or lost, at any stiffness. r is taken as a cubic
/// through four places of the step: exact for a constant (gravity) and for every
/// [`Reconstruction`](crate::input::Reconstruction); of order 4 for other inputs. At most 1 rad of
/// the mode's fastest motion per step, so that guards are detected; a stiff contact within one tick
/// is three or four steps. The rounding of a step is carried to the next one, and void after a
/// reset. Evaluations: the Jacobian, and 4 derivatives, or 1 without influence of the input.
///
/// `[HNW93]` I.8 (power series), `[HO10]` 2 (variation of constants).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Exact;

/// Terms of the series: (1 rad)²¹/21! is below rounding, and two more terms show it.
const TERMS: usize = 24;

/// Dense output of the exact flow: its Taylor series.
pub type Flow<S> = Polynomial<S, TERMS>;

/// Longest step in terms of the fastest motion (rad).
const RADIANS: f64 = 1.0;

const PLACES: [f64; 4] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];

impl Stepper for Exact {
    const ORDER: u32 = 4;
    const DENSE: u32 = 23;
    const EVALUATIONS: u32 = 4;
    const JACOBIANS: u32 = 1;
    const NAME: &'static str = "exact";

    type Memory<S: State> = RoundingCarry<S>;
    type Dense<S: State> = FlowOrCubic<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut Self::Memory<S>,
        h: f64,
    ) -> Step<S, Self::Dense<S>> {
        let nature = field.nature();
        if nature.is_linear() {
            let a = field.jacobian(0.0, x0);
            let flow = if nature.kind == EquationKind::Affine {
                series(&a, &[field.derivative(0.0, &S::ZERO)], x0, h, &mut memory.rounded)
            } else {
                let forcing = PLACES.map(|tau| field.derivative(tau, &S::ZERO));
                series(&a, &cubic(forcing), x0, h, &mut memory.rounded)
            };
            return Step::new(FlowOrCubic::Flow(flow));
        }
        Rk4.step(field, x0, &mut (), h).map(FlowOrCubic::Cubic)
    }

    #[inline]
    fn steps_apart(&self, _entries: usize) -> bool {
        true
    }

    #[inline]
    fn aims(&self, nature: &Nature) -> bool {
        !nature.is_linear() && Rk4.aims(nature)
    }

    #[inline]
    fn longest_step(&self, nature: &Nature, own: f64) -> f64 {
        if !nature.is_linear() {
            Rk4.longest_step(nature, own)
        } else if nature.rate > 0.0 {
            RADIANS / nature.rate
        } else {
            f64::INFINITY
        }
    }
}

/// Returns the coefficients by power of τ of the cubic through `r` at [`PLACES`].
#[inline]
fn cubic<S: State>([r0, r1, r2, r3]: [S; 4]) -> [S; 4] {
    let sum = |weights: [f64; 4]| {
        let [a, b, c, d] = weights;
        r0.times(0.5 * a).plus(0.5 * b, &r1).plus(0.5 * c, &r2).plus(0.5 * d, &r3)
    };
    [
        r0,
        sum([-11.0, 18.0, -9.0, 2.0]),
        sum([18.0, -45.0, 36.0, -9.0]),
        sum([-9.0, 27.0, -27.0, 9.0]),
    ]
}

/// Returns the Taylor series of x' = A x + Σ rₖ τᵏ from `x0` over `h` (s).
///
/// Term k + 1 is h (A termₖ + rₖ) / (k + 1). The series ends where two successive terms do not
/// count against the largest one in any entry, since an entry may end at zero. A series that does
/// not end within its terms is NaN: the model's rate is far too low. `rounded` holds the rounding
/// of the step before, then that of this step.
#[inline]
fn series<S: State>(a: &S::Matrix, forcing: &[S], x0: &S, h: f64, rounded: &mut S) -> Flow<S> {
    let mut terms = [S::ZERO; TERMS];
    terms[0] = *x0;
    let mut peak = raised(&S::ZERO, x0);
    let (mut sum, mut used, mut small) = (*rounded, 1, 0);
    while used < TERMS {
        let mut slope = a.apply(&terms[used - 1]);
        if let Some(force) = forcing.get(used - 1) {
            slope = slope.plus(1.0, force);
        }
        let term = slope.times(h / used as f64);
        terms[used] = term;
        sum = sum.plus(1.0, &term);
        // Two in a row: in an oscillation every other term of an entry may vanish.
        small = if counts(&term, &peak) { 0 } else { small + 1 };
        peak = raised(&peak, &term);
        used += 1;
        if small >= 2 && used > forcing.len() + 1 {
            let end = x0.plus(1.0, &sum);
            *rounded = sum.plus(-1.0, &end.plus(-1.0, x0));
            return Flow::new(terms, end).truncated(used);
        }
    }
    Flow::new(terms, sum.times(f64::NAN))
}

#[inline]
fn raised<S: State>(peak: &S, term: &S) -> S {
    let mut raised = *peak;
    for (index, (entry, most)) in term.entries().iter().zip(peak.entries()).enumerate() {
        if entry.abs() > *most {
            raised = raised.with_entry(index, entry.abs());
        }
    }
    raised
}

/// Returns `true` if a term is more than rounding of the largest one, in any entry; also for NaN.
#[inline]
fn counts<S: State>(term: &S, peak: &S) -> bool {
    const ROUNDING: f64 = 0.25 * f64::EPSILON;
    let mut pairs = term.entries().iter().zip(peak.entries());
    !pairs.all(|(entry, most)| entry.abs() <= ROUNDING * most)
}

/// Rounding of the last step, entry by entry, so that roundings do not add up.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RoundingCarry<S> {
    rounded: S,
}

impl<S: State> Default for RoundingCarry<S> {
    fn default() -> Self {
        Self { rounded: S::ZERO }
    }
}

impl<S: State> Memory for RoundingCarry<S> {
    #[inline]
    fn restart(&mut self) {
        self.rounded = S::ZERO;
    }
}

/// Dense output of a method that is exact in linear modes: the flow's series there, else a cubic.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum FlowOrCubic<S> {
    Flow(Flow<S>),
    Cubic(Cubic<S>),
}

impl<S: State> FlowOrCubic<S> {
    fn series(&self) -> Flow<S> {
        match self {
            Self::Flow(flow) => *flow,
            Self::Cubic(cubic) => cubic.lengthened(),
        }
    }
}

impl<S: State> Dense<S> for FlowOrCubic<S> {
    fn still(x: &S) -> Self {
        Self::Cubic(Cubic::still(x))
    }

    fn merged(&self, other: &Self, part: &Part) -> Self {
        match (self, other) {
            (Self::Cubic(mine), Self::Cubic(other)) => Self::Cubic(mine.merged(other, part)),
            _ => Self::Flow(self.series().merged(&other.series(), part)),
        }
    }

    fn within(&self, from: f64, to: f64) -> Option<Self> {
        match self {
            Self::Flow(dense) => dense.within(from, to).map(Self::Flow),
            Self::Cubic(dense) => dense.within(from, to).map(Self::Cubic),
        }
    }

    #[inline]
    fn at(&self, tau: f64) -> S {
        match self {
            Self::Flow(dense) => dense.at(tau),
            Self::Cubic(dense) => dense.at(tau),
        }
    }

    #[inline]
    fn end(&self) -> &S {
        match self {
            Self::Flow(dense) => dense.end(),
            Self::Cubic(dense) => dense.end(),
        }
    }

    #[inline]
    fn bounds(&self) -> Option<DenseBounds<S>> {
        match self {
            Self::Flow(dense) => dense.bounds(),
            Self::Cubic(dense) => dense.bounds(),
        }
    }
}
