//! Square matrices over a state: Jacobians, propagators, and one LU.

use core::fmt::Debug;

use nalgebra::{ArrayStorage, Const, DimMin, LU, SMatrix, SVector};

use crate::state::State;

/// A square matrix that maps states of type `S` to states.
pub trait Matrix<S>: Copy + PartialEq + Debug + Send + 'static {
    /// The matrix, factored for solving.
    type Factored: Debug;

    /// The unit matrix.
    const ONE: Self;

    /// The matrix whose columns `column` returns.
    fn from_columns(column: impl FnMut(usize) -> S) -> Self;

    /// Returns `self · x`.
    fn apply(&self, x: &S) -> S;

    /// Returns `self · other`.
    #[must_use]
    fn product(&self, other: &Self) -> Self;

    /// Returns `self + a * other`.
    #[must_use]
    fn plus(&self, a: f64, other: &Self) -> Self;

    /// The largest sum of magnitudes in a row: the norm that goes with the largest entry.
    fn norm(&self) -> f64;

    /// Factors `1 − a · self`, with partial pivoting.
    fn factor(&self, a: f64) -> Self::Factored;

    /// Solves for `b`; `None` if the matrix is singular.
    fn solve(factored: &Self::Factored, b: &S) -> Option<S>;
}

impl<const N: usize> Matrix<[f64; N]> for SMatrix<f64, N, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
    [f64; N]: State,
{
    type Factored = LU<f64, Const<N>, Const<N>>;

    const ONE: Self = unit();

    #[inline]
    fn from_columns(mut column: impl FnMut(usize) -> [f64; N]) -> Self {
        let columns: [[f64; N]; N] = core::array::from_fn(&mut column);
        Self::from_fn(|row, index| columns[index][row])
    }

    #[inline]
    fn apply(&self, x: &[f64; N]) -> [f64; N] {
        let columns = &self.data.0;
        let mut sum = [0.0; N];
        for (column, factor) in columns.iter().zip(x) {
            for (entry, part) in sum.iter_mut().zip(column) {
                *entry += factor * part;
            }
        }
        sum
    }

    fn product(&self, other: &Self) -> Self {
        self * other
    }

    #[inline]
    fn plus(&self, a: f64, other: &Self) -> Self {
        self + other * a
    }

    #[inline]
    fn norm(&self) -> f64 {
        self.row_iter().fold(0.0, |most: f64, row| most.max(row.abs().sum()))
    }

    #[inline]
    fn factor(&self, a: f64) -> Self::Factored {
        (Self::identity() - self * a).lu()
    }

    #[inline]
    fn solve(factored: &Self::Factored, b: &[f64; N]) -> Option<[f64; N]> {
        let mut x = SVector::<f64, N>::from(*b);
        // Written out: without std nothing but the bounds on this impl tells the shapes.
        let is_regular = factored.solve_mut::<Const<N>, Const<1>, ArrayStorage<f64, N, 1>>(&mut x);
        is_regular.then(|| x.into())
    }
}

/// The unit matrix, at compile time.
const fn unit<const N: usize>() -> SMatrix<f64, N, N> {
    let mut columns = [[0.0; N]; N];
    let mut index = 0;
    while index < N {
        columns[index][index] = 1.0;
        index += 1;
    }
    SMatrix::from_array_storage(ArrayStorage(columns))
}
