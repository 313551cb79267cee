//! Steps as long as a tolerance allows.

use crate::dense::Dense as _;
use crate::math::{powf, sqrt};
use crate::nature::Nature;
use crate::state::State;
use crate::stepper::{Field, Memory, Step, Stepper};

/// Scale of an error estimate: absolute + relative × size, entry by entry.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tolerance {
    pub absolute: f64,
    pub relative: f64,
}

impl Default for Tolerance {
    /// 1e-10 of either kind.
    fn default() -> Self {
        Self { absolute: 1e-10, relative: 1e-10 }
    }
}

impl Tolerance {
    pub const fn both(tolerance: f64) -> Self {
        Self { absolute: tolerance, relative: tolerance }
    }

    /// Root mean square of the error in units of the tolerance: above 1 is too much.
    #[inline]
    fn weigh<S: State>(&self, error: &S, x0: &S, x1: &S) -> f64 {
        let entries = error.entries().iter().zip(x0.entries()).zip(x1.entries());
        let mut sum = 0.0;
        for ((error, x0), x1) in entries {
            let part = error / (self.absolute + self.relative * x0.abs().max(x1.abs()));
            sum += part * part;
        }
        sqrt(sum / (error.entries().len().max(1)) as f64)
    }
}

/// The method `T` with steps as long as the tolerance permits; for offline work, where a tick may
/// be as long as the whole simulation.
///
/// A step with an estimate beyond the tolerance is refused and repeated, shorter, within the limit
/// on pieces. The step's length is kept over events. `[HNW93]` II.4: elementary controller.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Controlled<T> {
    /// The method; it must have an error estimate.
    pub method: T,
    pub tolerance: Tolerance,
}

/// Memory of a controlled method.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Control<M> {
    method: M,
    /// Length of the next step (s); infinite before the first.
    reach: f64,
}

impl<M: Memory> Default for Control<M> {
    fn default() -> Self {
        Self { method: M::default(), reach: f64::INFINITY }
    }
}

impl<M: Memory> Memory for Control<M> {
    #[inline]
    fn restart(&mut self) {
        self.method.restart();
    }

    #[inline]
    fn begin_tick(&mut self) {
        self.method.begin_tick();
    }

    #[inline]
    fn reach(&self, _stretch: f64) -> f64 {
        self.reach
    }
}

/// Returns the root of this order of `x`, quickly where it is a power of two.
#[inline]
fn root(x: f64, order: u32) -> f64 {
    match order {
        2 => sqrt(x),
        4 => sqrt(sqrt(x)),
        8 => sqrt(sqrt(sqrt(x))),
        _ => powf(x, 1.0 / f64::from(order)),
    }
}

impl<T: Stepper> Stepper for Controlled<T> {
    const ORDER: u32 = T::ORDER;
    const DENSE: u32 = T::DENSE;
    const EVALUATIONS: u32 = T::EVALUATIONS;
    const REFINEMENT: u32 = T::REFINEMENT;
    const JACOBIANS: u32 = T::JACOBIANS;
    const NAME: &'static str = T::NAME;

    type Memory<S: State> = Control<T::Memory<S>>;
    type Dense<S: State> = T::Dense<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut Self::Memory<S>,
        h: f64,
    ) -> Step<S, Self::Dense<S>> {
        const FACTORS: (f64, f64) = (0.1, 6.0);
        /// Fraction of the length that would just meet the tolerance. Between events a step is
        /// often followed by a harder one: with 0.9 a sixth of all steps is refused on the paper's
        /// figure 6, which takes a fifth more evaluations for the same error.
        const SAFETY: f64 = 0.7;
        /// A step this short (s) with an estimate of NaN is the model's own fault.
        const SHORTEST: f64 = 1e-9;
        let mut step = self.method.step(field, x0, &mut memory.method, h);
        let error = self.tolerance.weigh(&step.error, x0, step.dense.end());
        let wish = SAFETY / root(error, T::ORDER);
        // NaN is refused: the step may just have been far too long.
        let factor = if wish.is_nan() { FACTORS.0 } else { wish.clamp(FACTORS.0, FACTORS.1) };
        step.is_accepted = error <= 1.0 || (error.is_nan() && h <= SHORTEST);
        if !step.is_accepted {
            memory.method.refuse();
        }
        memory.reach = factor * h;
        step
    }

    #[inline]
    fn steps_apart(&self, _entries: usize) -> bool {
        false
    }

    fn aims(&self, nature: &Nature) -> bool {
        self.method.aims(nature)
    }

    #[inline]
    fn is_smooth_inside(&self) -> bool {
        self.method.is_smooth_inside()
    }

    fn refine<S: State>(
        &self,
        field: &mut impl Field<S>,
        memory: &Self::Memory<S>,
        dense: &mut T::Dense<S>,
        h: f64,
    ) {
        self.method.refine(field, &memory.method, dense, h);
    }
}
