//! Steps as long as a tolerance allows.

use crate::dense::Dense as _;
use crate::math::{powf, sqrt};
use crate::nature::Nature;
use crate::state::State;
use crate::stepper::{Field, Memory, Step, Stepper};

/// What an error estimate is measured by: absolute + relative × size, entry by entry.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tolerance {
    /// In the unit of each entry.
    pub absolute: f64,
    /// As a part of the entry.
    pub relative: f64,
}

impl Default for Tolerance {
    /// 1e-10 of either kind.
    fn default() -> Self {
        Self { absolute: 1e-10, relative: 1e-10 }
    }
}

impl Tolerance {
    /// The same number for both kinds.
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

/// The method `T`, with each step as long as the tolerance allows; for offline work, where
/// a tick may be as long as the whole simulation.
///
/// A step whose estimate exceeds the tolerance is refused and taken again, shorter: the
/// limit on pieces bounds that, too. What the step's length was is kept over events.
///
/// # References
/// `[HNW93]` II.4: elementary controller.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Controlled<T> {
    /// The method; it must have an error estimate.
    pub method: T,
    /// What its estimate is measured by.
    pub tolerance: Tolerance,
}

/// What a controlled method carries.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Control<M> {
    /// What the method itself carries.
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
    fn reach(&self) -> f64 {
        self.reach
    }
}

/// The root of this order of `x`, quickly where it is a power of two.
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
        /// The next step is never shorter or longer than this by these factors.
        const FACTORS: (f64, f64) = (0.1, 6.0);
        /// Part of the length that would just meet the tolerance. Between events a step is
        /// often followed by a harder one: 0.9 has a sixth of all steps refused on the paper's
        /// figure 6, and takes a fifth more evaluations for the same error.
        const SAFETY: f64 = 0.7;
        /// A step this short (s) without a number for its error is the model's own fault.
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

    /// One step length is controlled for all parts.
    #[inline]
    fn steps_apart(&self, _entries: usize) -> bool {
        false
    }

    fn aims(&self, nature: &Nature) -> bool {
        self.method.aims(nature)
    }

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
