//! One LU: what linearly implicit methods solve with.

use crate::state::Matrix;
use crate::state::State;

/// 1 − a J, factored.
#[derive(Debug)]
pub(super) struct Shifted<S: State>(<S::Matrix as Matrix<S>>::Factored);

impl<S: State> Shifted<S> {
    /// Factors 1 − `a` · `jacobian`.
    #[inline]
    pub(super) fn new(jacobian: &S::Matrix, a: f64) -> Self {
        Self(jacobian.factor(a))
    }

    /// Solves for `b`; not a number in any entry if the matrix is singular, so that the step
    /// ends in a state that is not finite.
    #[inline]
    pub(super) fn solve(&self, b: &S) -> S {
        S::Matrix::solve(&self.0, b).unwrap_or_else(|| b.times(f64::NAN))
    }
}
