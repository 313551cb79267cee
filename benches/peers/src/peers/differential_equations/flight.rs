//! A problem behind the crate's trait; the mode is in a cell, since the trait passes `&self`.

use std::cell::Cell;

use differential_equations::prelude::ODE;

use crate::problem::Problem;

pub(super) struct Flight<'a, const N: usize, const G: usize, P: Problem<N, G>> {
    pub(super) problem: &'a P,
    pub(super) mode: &'a Cell<P::Mode>,
}

impl<const N: usize, const G: usize, P: Problem<N, G>> ODE<f64, [f64; N]> for Flight<'_, N, G, P> {
    #[inline]
    fn diff(&self, t: f64, x: &[f64; N], dx: &mut [f64; N]) {
        *dx = self.problem.derivative(self.mode.get(), t, x);
    }
}
