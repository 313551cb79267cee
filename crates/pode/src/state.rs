//! The vector operations that a stepper needs.

use core::fmt::Debug;

/// A state vector of fixed size: coordinates first, speeds after.
pub trait State: Copy + PartialEq + Debug + Send {
    /// The zero vector.
    const ZERO: Self;

    /// Returns `self + a * x`.
    #[must_use]
    fn plus(&self, a: f64, x: &Self) -> Self;

    /// Returns `a * self`.
    #[must_use]
    fn times(&self, a: f64) -> Self;

    /// Returns the first `n` entries of `self` followed by the rest of `tail`.
    #[must_use]
    fn head_of(&self, n: usize, tail: &Self) -> Self;

    /// The entries.
    fn entries(&self) -> &[f64];
}

impl<const N: usize> State for [f64; N] {
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
    fn head_of(&self, n: usize, tail: &Self) -> Self {
        core::array::from_fn(|i| if i < n { self[i] } else { tail[i] })
    }

    #[inline]
    fn entries(&self) -> &[f64] {
        self
    }
}

/// Whether every entry is a finite number.
#[inline]
pub(crate) fn is_finite<S: State>(x: &S) -> bool {
    x.entries().iter().all(|entry| entry.is_finite())
}
