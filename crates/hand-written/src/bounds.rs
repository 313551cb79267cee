//! Bounds of a guard's terms over one step, put together from bounds of what they are made of.
//!
//! A model knows how its guards follow from the state and the input; an [`Enclosure`] knows how
//! far both go in a step. The chain and product rules do the rest, with every slope replaced by
//! the largest one over the step.

use core::ops::{Add, Mul};

use pode::{Enclosure, GuardBound, Motion, State};

/// Bounds of a term over one step, as the fraction τ of the step goes from 0 to 1.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct TermBound {
    /// Bound of the magnitude |f| over the step.
    pub(crate) size: f64,
    /// Bound of |f(τ) − f(0)|.
    pub(crate) moves: f64,
    /// Bound of |df/dτ|.
    pub(crate) speed: f64,
    /// Bound of |d²f/dτ²|.
    pub(crate) bend: f64,
}

impl TermBound {
    /// The bound of a constant.
    #[inline]
    pub(crate) const fn constant(value: f64) -> Self {
        Self { size: value.abs(), moves: 0.0, speed: 0.0, bend: 0.0 }
    }

    /// The bound of the entry `I` of the state.
    #[inline]
    pub(crate) fn entry<const I: usize, const N: usize, U>(over: &Enclosure<[f64; N], U>) -> Self {
        const { assert!(I < N, "an entry of the state") };
        let moves = over.moves[I];
        Self {
            size: over.start[I].abs() + moves,
            moves,
            speed: over.speeds[I],
            bend: over.bends[I],
        }
    }

    /// The bound of the input's position.
    #[inline]
    pub(crate) fn position<S: State>(over: &Enclosure<S, Motion>) -> Self {
        let size = over.input.map_or(f64::INFINITY, |most| most.position);
        Self::of_input(size, over.position())
    }

    /// The bound of the input's rate.
    #[inline]
    pub(crate) fn rate<S: State>(over: &Enclosure<S, Motion>) -> Self {
        Self::of_input(over.input.map_or(f64::INFINITY, |most| most.rate), over.rate())
    }

    /// An input that moves at the most at one speed.
    #[inline]
    const fn of_input(size: f64, bound: GuardBound) -> Self {
        Self { size, moves: bound.moves, speed: bound.moves, bend: bound.bend }
    }

    /// The bound of φ(f), where |φ| ≤ `size`, |φ'| ≤ `slope` and |φ''| ≤ `bend` over the step.
    #[inline]
    pub(crate) fn through(&self, size: f64, slope: f64, bend: f64) -> Self {
        Self {
            size,
            moves: slope * self.moves,
            speed: slope * self.speed,
            bend: slope * self.bend + bend * self.speed * self.speed,
        }
    }

    /// The bound of the term times a constant.
    #[inline]
    pub(crate) fn times(&self, factor: f64) -> Self {
        self.through(factor.abs() * self.size, factor.abs(), 0.0)
    }

    /// The bound of the term's square.
    #[inline]
    pub(crate) fn square(&self) -> Self {
        self.through(self.size * self.size, 2.0 * self.size, 2.0)
    }

    /// The bound as that of a guard.
    #[inline]
    pub(crate) const fn as_guard(&self) -> GuardBound {
        GuardBound::new(self.moves, self.bend)
    }
}

impl Add for TermBound {
    type Output = Self;

    /// The bound of the sum.
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            size: self.size + other.size,
            moves: self.moves + other.moves,
            speed: self.speed + other.speed,
            bend: self.bend + other.bend,
        }
    }
}

impl Mul for TermBound {
    type Output = Self;

    /// The bound of the product.
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            size: self.size * other.size,
            moves: self.moves * other.size + self.size * other.moves,
            speed: self.speed * other.size + self.size * other.speed,
            bend: self.bend * other.size + 2.0 * self.speed * other.speed + self.size * other.bend,
        }
    }
}
