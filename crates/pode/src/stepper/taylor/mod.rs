//! Taylor's method, of any order, for models that know their series.

mod branch;
mod carried;
mod reach;

pub use carried::TaylorMemory;

use crate::dense::Polynomial;
use crate::nature::Nature;
use crate::series::{Expansion, MOST_ORDER, TERMS};
use crate::state::State;
use crate::stepper::{Controlled, Field, Memory as _, Step, Stepper, Tolerance, Tsitouras5};

/// Taylor's method: the solution's series is the dense output, and its end limits the step.
///
/// For offline work, with steps as long as a tolerance permits, and for the smallest errors: the
/// work grows with the square of the digits. One expansion a step ([`Guarded::series`]); no step is
/// ever refused. Where the equations change their form along the series, as where a felt is left,
/// the step ends. At a state without a series, since the model has none or a felt is just being
/// touched, the step is one of Tsitouras' method under the same tolerance.
///
/// No precision is lost inside a step, and guards that the model expands too are searched as
/// polynomials, without an evaluation. Only the length of steps is carried.
///
/// [`Guarded::series`]: crate::Guarded::series
///
/// `[JZ05]`: recursions, order and step size.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Taylor {
    /// Order of the series, 2 to [`MOST_ORDER`].
    pub order: usize,
    pub tolerance: Tolerance,
}

impl Default for Taylor {
    fn default() -> Self {
        Self::to(Tolerance::default())
    }
}

impl Taylor {
    /// Builds the method with the order of least work for a tolerance.
    pub fn to(tolerance: Tolerance) -> Self {
        Self { order: reach::order_for(tolerance.relative.min(tolerance.absolute)), tolerance }
    }

    const fn substitute(&self) -> Controlled<Tsitouras5> {
        Controlled { method: Tsitouras5, tolerance: self.tolerance }
    }
}

impl Stepper for Taylor {
    const ORDER: u32 = 24;
    const EVALUATIONS: u32 = 1 + Tsitouras5::EVALUATIONS;
    const IS_EXPANDED: bool = true;
    const NAME: &'static str = "taylor";

    type Memory<S: State> = TaylorMemory<S>;
    type Dense<S: State> = Polynomial<S, TERMS>;

    fn prepare<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut TaylorMemory<S>,
        scale: f64,
    ) {
        let expansion = &mut memory.expansion;
        expansion.begin(x0, self.order, scale);
        let reach =
            if field.expand(expansion) { reach::of(expansion, self.tolerance) } else { None };
        let reaches = reach.and_then(|reach| Some((branch::before(expansion, reach)?, reach)));
        memory.expand(reaches);
    }

    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut TaylorMemory<S>,
        h: f64,
    ) -> Step<S, Polynomial<S, TERMS>> {
        if !memory.is_prepared() {
            self.prepare(field, x0, memory, h);
        }
        if let Some(ratio) = memory.take(h) {
            return along(&memory.expansion, ratio);
        }
        let substitute = self.substitute();
        let step = substitute.step(field, x0, &mut memory.substitute, h);
        memory.follow(memory.substitute.reach());
        step.map(|dense| dense.lengthened())
    }

    #[inline]
    fn steps_apart(&self, _entries: usize) -> bool {
        false
    }

    /// Permits a step longer than low-order methods resolve, but short enough to follow the input.
    fn longest_step(&self, _nature: &Nature, own: f64) -> f64 {
        /// Six radians, where a model's own steps have three quarters of one.
        const STEPS: f64 = 8.0;
        STEPS * own
    }
}

const _: () = assert!(MOST_ORDER == 24, "the order that the trait is told");

#[inline]
fn along<S: State>(expansion: &Expansion<S>, ratio: f64) -> Step<S, Polynomial<S, TERMS>> {
    let order = expansion.order.min(MOST_ORDER);
    let mut terms = [S::ZERO; TERMS];
    let mut power = 1.0;
    for (term, known) in terms.iter_mut().zip(&expansion.terms).take(order + 1) {
        *term = known.times(power);
        power *= ratio;
    }
    let rise =
        terms.iter().take(order + 1).skip(1).rev().fold(S::ZERO, |sum, it| sum.plus(1.0, it));
    let end = terms[0].plus(1.0, &rise);
    Step::new(Polynomial::new(terms, end).truncated(order + 1)).with_error(terms[order])
}
