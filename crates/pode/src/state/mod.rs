//! The vector operations that a stepper needs.

mod matrix;

use core::fmt::Debug;

use nalgebra::SMatrix;

use crate::part::Part;

pub use matrix::{Factors, Matrix};

/// A state vector of fixed size: coordinates first, speeds after.
pub trait State: Copy + PartialEq + Debug + Send + 'static {
    type Matrix: Matrix<Self>;

    const ZERO: Self;

    /// Returns `self + a * x`.
    #[must_use]
    fn plus(&self, a: f64, x: &Self) -> Self;

    /// Returns `a * self`.
    #[must_use]
    fn times(&self, a: f64) -> Self;

    #[must_use]
    fn magnitudes(&self) -> Self;

    /// Returns the first `n` entries of `self` followed by the rest of `tail`.
    #[must_use]
    fn head_of(&self, n: usize, tail: &Self) -> Self;

    /// Returns `self` with `value` for the entry `index`.
    #[must_use]
    fn with_entry(&self, index: usize, value: f64) -> Self;

    /// Returns `self` with the entries of `part` from `other`.
    #[must_use]
    fn with_entries(&self, other: &Self, part: &Part) -> Self;

    fn entries(&self) -> &[f64];
}

impl<const N: usize> State for [f64; N] {
    type Matrix = SMatrix<f64, N, N>;

    const ZERO: Self = [0.0; N];

    #[inline]
    fn plus(&self, a: f64, x: &Self) -> Self {
        core::array::from_fn(|i| self[i] + a * x[i])
    }

    #[inline]
    fn times(&self, a: f64) -> Self {
        core::array::from_fn(|i| a * self[i])
    }

    #[inline]
    fn magnitudes(&self) -> Self {
        self.map(f64::abs)
    }

    #[inline]
    fn head_of(&self, n: usize, tail: &Self) -> Self {
        core::array::from_fn(|i| if i < n { self[i] } else { tail[i] })
    }

    #[inline]
    fn with_entry(&self, index: usize, value: f64) -> Self {
        core::array::from_fn(|i| if i == index { value } else { self[i] })
    }

    #[inline]
    fn with_entries(&self, other: &Self, part: &Part) -> Self {
        core::array::from_fn(|i| if part.has(i) { other[i] } else { self[i] })
    }

    #[inline]
    fn entries(&self) -> &[f64] {
        self
    }
}

#[inline]
pub(crate) fn is_finite<S: State>(x: &S) -> bool {
    x.entries().iter().all(|entry| entry.is_finite())
}

/// Returns the largest magnitude of the entries; NaN entries do not count.
#[inline]
pub(crate) fn largest<S: State>(x: &S) -> f64 {
    x.entries().iter().fold(0.0, |most: f64, entry| most.max(entry.abs()))
}
