use crate::state::Matrix;
use crate::state::State;

/// 1 − a J, factored.
#[derive(Debug)]
pub(super) struct Shifted<S: State>(<S::Matrix as Matrix<S>>::Factored);

impl<S: State> Shifted<S> {
    #[inline]
    pub(super) fn new(jacobian: &S::Matrix, a: f64) -> Self {
        Self(jacobian.factor(a))
    }

    /// Solves for `b`; NaN in every entry if the matrix is singular, so that the step fails.
    #[inline]
    pub(super) fn solve(&self, b: &S) -> S {
        S::Matrix::solve(&self.0, b).unwrap_or_else(|| b.times(f64::NAN))
    }
}
