//! Dormand–Prince 8(5,3), for long steps offline.

mod dense;
mod tableau;

pub use dense::Dense8;

use crate::math::sqrt;
use crate::state::State;
use crate::stepper::{Field, Memory, Step, Stepper};
use tableau::{A1, A2, A3, A4, A5, A6, A7, A8, A9, A10, A11, B, E3, E5, NODES, TableauRow};

/// Order 8 with embedded estimates of orders 5 and 3, in 13 evaluations, 12 after the first.
///
/// For offline work and references, without ticks: under [`Controlled`](crate::stepper::Controlled)
/// its steps are as long as the tolerance permits. Dense output: the cubic Hermite of the step, or
/// order 7 with three more evaluations where a crossing is searched. First-same-as-last: the slope
/// at the end is carried, and void after a reset, a jump of the input, or a change of the mode.
/// Stable for ωh up to about 6 on the real axis; choose it for tolerances below 1e-8.
///
/// `[HNW93]` II.5, and II.6 for the dense output; Hairer's `dop853.f`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Dop853;

/// The stages of the last step, which refine its dense output; the last is the next step's first.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stages<S> {
    k: [S; 13],
    /// `true` if the last stage is the slope at the next step's start.
    is_known: bool,
}

impl<S: State> Default for Stages<S> {
    fn default() -> Self {
        Self { k: [S::ZERO; 13], is_known: false }
    }
}

impl<S: State> Memory for Stages<S> {
    #[inline]
    fn restart(&mut self) {
        self.is_known = false;
    }

    /// The first stage belongs to the state, not to the step.
    #[inline]
    fn refuse(&mut self) {
        self.k[12] = self.k[0];
    }

    #[inline]
    fn begin_tick(&mut self) {
        self.is_known = false;
    }
}

impl Stepper for Dop853 {
    const ORDER: u32 = 8;
    const DENSE: u32 = 7;
    const EVALUATIONS: u32 = 13;
    const REFINEMENT: u32 = 3;
    const NAME: &'static str = "dop853";

    type Memory<S: State> = Stages<S>;
    type Dense<S: State> = Dense8<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut Stages<S>,
        h: f64,
    ) -> Step<S, Dense8<S>> {
        let k = &mut memory.k;
        k[0] = if memory.is_known { k[12] } else { field.derivative(0.0, x0) };
        macro_rules! stages {
            ($($n:literal: $row:ident),+) => {$(
                k[$n] = field.derivative(NODES[$n], &moved(x0, h, k, &$row));
            )+};
        }
        stages!(1: A1, 2: A2, 3: A3, 4: A4, 5: A5, 6: A6, 7: A7, 8: A8, 9: A9, 10: A10, 11: A11);
        let x1 = moved(x0, h, k, &B);
        k[12] = field.derivative(1.0, &x1);
        memory.is_known = true;
        let error = estimate(&weighed(k, &E5), &weighed(k, &E3)).times(h);
        Step::new(Dense8::hermite(x0, &x1, [&k[0], &k[12]], h)).with_error(error)
    }

    fn refine<S: State>(
        &self,
        field: &mut impl Field<S>,
        memory: &Stages<S>,
        dense: &mut Dense8<S>,
        h: f64,
    ) {
        dense.refine(field, &memory.k, h);
    }
}

#[inline]
fn weighed<S: State, const N: usize, const K: usize>(k: &[S; K], row: &TableauRow<N>) -> S {
    row.iter().fold(S::ZERO, |sum, (stage, weight)| sum.plus(*weight, &k[*stage]))
}

#[inline]
fn moved<S: State, const N: usize, const K: usize>(
    x0: &S,
    h: f64,
    k: &[S; K],
    row: &TableauRow<N>,
) -> S {
    x0.plus(h, &weighed(k, row))
}

/// Both estimates as one: e5² / √(e5² + e3²/100), entry by entry. `[HNW93]` II.10
#[inline]
fn estimate<S: State>(e5: &S, e3: &S) -> S {
    let mut error = S::ZERO;
    for (index, (five, three)) in e5.entries().iter().zip(e3.entries()).enumerate() {
        let (five, three) = (five * five, three * three);
        let length = sqrt(five + 0.01 * three);
        error = error.with_entry(index, if length > 0.0 { five / length } else { five });
    }
    error
}
