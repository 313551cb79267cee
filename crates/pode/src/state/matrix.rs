//! Square matrices over a state: Jacobians, propagators, and one LU.

use core::fmt::Debug;

use nalgebra::{ArrayStorage, SMatrix};

/// A square matrix that maps states of type `S` to states.
pub trait Matrix<S>: Copy + PartialEq + Debug + Send + 'static {
    type Factored: Debug;

    const ONE: Self;

    fn from_columns(column: impl FnMut(usize) -> S) -> Self;

    /// Returns `self · x`.
    fn apply(&self, x: &S) -> S;

    /// Returns `self · other`.
    #[must_use]
    fn product(&self, other: &Self) -> Self;

    /// Returns `self + a * other`.
    #[must_use]
    fn plus(&self, a: f64, other: &Self) -> Self;

    /// Returns the largest row sum of magnitudes: the norm that belongs to the largest entry.
    fn norm(&self) -> f64;

    /// Factors `1 − a · self`, with partial pivoting.
    fn factor(&self, a: f64) -> Self::Factored;

    /// Solves for `b`; `None` if the matrix is singular.
    fn solve(factored: &Self::Factored, b: &S) -> Option<S>;
}

/// A square matrix as the product of a lower and an upper triangle, with interchanged rows.
/// nalgebra's needs a bound on every size, which each generic model would have to repeat.
#[derive(Clone, Copy, Debug)]
pub struct Factors<const N: usize> {
    /// Row by row: the upper triangle with the diagonal, and below it the factors of elimination.
    rows: [[f64; N]; N],
    /// Row of the matrix at each index.
    order: [usize; N],
}

impl<const N: usize> Factors<N> {
    #[inline]
    fn new(mut rows: [[f64; N]; N]) -> Self {
        let mut order = core::array::from_fn(|index| index);
        for step in 0..N {
            let size = |row: usize| rows[row][step].abs();
            let pivot =
                (step..N).fold(step, |best, row| if size(row) > size(best) { row } else { best });
            rows.swap(step, pivot);
            order.swap(step, pivot);
            let top = rows[step];
            for row in rows.iter_mut().skip(step + 1) {
                let factor = row[step] / top[step];
                row[step] = factor;
                row.iter_mut()
                    .zip(&top)
                    .skip(step + 1)
                    .for_each(|(it, upper)| *it -= factor * upper);
            }
        }
        Self { rows, order }
    }

    #[inline]
    fn solve(&self, b: &[f64; N]) -> Option<[f64; N]> {
        let mut x = self.order.map(|row| b[row]);
        for index in 0..N {
            let known: f64 = self.rows[index].iter().zip(&x).take(index).map(|(a, x)| a * x).sum();
            x[index] -= known;
        }
        for index in (0..N).rev() {
            let (row, pivot) = (&self.rows[index], self.rows[index][index]);
            let known: f64 = row.iter().zip(&x).skip(index + 1).map(|(a, x)| a * x).sum();
            x[index] = (x[index] - known) / pivot;
            if pivot == 0.0 {
                return None;
            }
        }
        Some(x)
    }
}

impl<const N: usize> Matrix<[f64; N]> for SMatrix<f64, N, N> {
    type Factored = Factors<N>;

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
    fn factor(&self, a: f64) -> Factors<N> {
        let unit = |row, column| if row == column { 1.0 } else { 0.0 };
        let entry = |row, column| unit(row, column) - a * self[(row, column)];
        Factors::new(core::array::from_fn(|row| core::array::from_fn(|column| entry(row, column))))
    }

    #[inline]
    fn solve(factored: &Factors<N>, b: &[f64; N]) -> Option<[f64; N]> {
        factored.solve(b)
    }
}

const fn unit<const N: usize>() -> SMatrix<f64, N, N> {
    let mut columns = [[0.0; N]; N];
    let mut index = 0;
    while index < N {
        columns[index][index] = 1.0;
        index += 1;
    }
    SMatrix::from_array_storage(ArrayStorage(columns))
}
