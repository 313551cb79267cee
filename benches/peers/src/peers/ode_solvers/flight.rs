//! A problem in one mode behind the crate's trait; stops when a guard has fallen through zero.

use std::cell::Cell;

use ode_solvers::{SVector, System};

use crate::problem::{Problem, armed};

/// One mode of a problem; with M = N + 1 states the last state is the time.
#[derive(Clone, Copy)]
pub(super) struct Flight<'a, const N: usize, const G: usize, const M: usize, P: Problem<N, G>> {
    /// Number of evaluations: the crate does not count those of the event search.
    pub(super) count: &'a Cell<u64>,
    pub(super) problem: P,
    pub(super) mode: P::Mode,
    pub(super) watched: [bool; G],
}

impl<'a, const N: usize, const G: usize, const M: usize, P: Problem<N, G>> Flight<'a, N, G, M, P> {
    pub(super) fn new(problem: P, mode: P::Mode, x: &[f64; N], count: &'a Cell<u64>) -> Self {
        Self { count, problem, mode, watched: armed(&problem, mode, x) }
    }

    pub(super) fn fallen(&mut self, x: &[f64; N]) -> [bool; G] {
        let guards = self.problem.guards(self.mode, x);
        std::array::from_fn(|i| {
            let is_fallen = self.watched[i] && guards[i] <= 0.0;
            self.watched[i] |= guards[i] > 0.0;
            is_fallen
        })
    }
}

impl<const N: usize, const G: usize, const M: usize, P: Problem<N, G>> System<f64, SVector<f64, M>>
    for Flight<'_, N, G, M, P>
{
    #[inline]
    fn system(&self, t: f64, y: &SVector<f64, M>, dy: &mut SVector<f64, M>) {
        self.count.set(self.count.get() + 1);
        let t = if M > N { y[N] } else { t };
        let rates = self.problem.derivative(self.mode, t, &state(y));
        for (slot, rate) in dy.iter_mut().zip(rates) {
            *slot = rate;
        }
        if M > N {
            dy[N] = 1.0;
        }
    }

    fn solout(&mut self, _t: f64, y: &SVector<f64, M>, _dy: &SVector<f64, M>) -> bool {
        self.fallen(&state(y)).contains(&true)
    }
}

#[inline]
pub(super) fn state<const N: usize, const M: usize>(y: &SVector<f64, M>) -> [f64; N] {
    std::array::from_fn(|i| y[i])
}

#[inline]
pub(super) fn vector<const N: usize, const M: usize>(t: f64, x: &[f64; N]) -> SVector<f64, M> {
    SVector::from_fn(|i, _| if i < N { x[i] } else { t })
}
