use core::fmt::Debug;

use crate::state::State;
use crate::stepper::Memory;

/// The derivatives at the starts of at most `N` steps before, the newest first.
///
/// Void after a reset, after a step that was cut short, in another mode and with another model. A
/// new tick does not void it, for the motion continues; where the derivative jumps between two
/// ticks, with the input, the next `N` steps are of order 1 in that jump.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DerivativeHistory<S, const N: usize> {
    past: [Past<S>; N],
    known: usize,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Past<S> {
    pub(super) slope: S,
    /// Its length (s).
    pub(super) h: f64,
}

impl<S: State, const N: usize> Default for DerivativeHistory<S, N> {
    fn default() -> Self {
        Self { past: [Past { slope: S::ZERO, h: 0.0 }; N], known: 0 }
    }
}

impl<S: State, const N: usize> DerivativeHistory<S, N> {
    /// Returns the steps before, newest first, if all are known and none is so short against a step
    /// of `h` (s) that the rounding of its slopes would be extrapolated.
    #[inline]
    pub(super) fn before(&self, h: f64) -> Option<&[Past<S>; N]> {
        /// Longest step as a multiple of one before.
        const STRETCH: f64 = 4.0;
        let is_sound = self.known == N && self.past.iter().all(|past| h <= STRETCH * past.h);
        is_sound.then_some(&self.past)
    }

    #[inline]
    pub(super) fn remember(&mut self, slope: S, h: f64) {
        self.past.rotate_right(1);
        if let Some(newest) = self.past.first_mut() {
            *newest = Past { slope, h };
        }
        self.known = N.min(self.known + 1);
    }
}

impl<S: State, const N: usize> Memory for DerivativeHistory<S, N> {
    #[inline]
    fn restart(&mut self) {
        self.known = 0;
    }
}
