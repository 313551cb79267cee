//! What a method carries from one step to the next, and when it must let go of it.

use core::fmt::Debug;

use crate::series::GuardSeries;

/// What a method knows from the steps before.
pub trait Memory: Copy + PartialEq + Default + Debug + Send {
    /// The state has jumped, or the mode has changed, or the step was cut short:
    /// what was known of the motion is void.
    #[inline]
    fn restart(&mut self) {}

    /// The step just taken is refused, and another will be taken from the same state.
    #[inline]
    fn refuse(&mut self) {
        self.restart();
    }

    /// A new tick begins: the input may have jumped, and the model's parameters with it.
    #[inline]
    fn begin_tick(&mut self) {}

    /// Longest step (s) that is worth trying next.
    #[inline]
    fn reach(&self) -> f64 {
        f64::INFINITY
    }

    /// About how long (s) the next step will be, for a method that looks ahead; infinite where
    /// that is not known.
    #[inline]
    fn scale(&self) -> f64 {
        f64::INFINITY
    }

    /// The mode's guards along the step just taken, where the method knows them.
    #[inline]
    fn guards(&self) -> Option<GuardSeries<'_>> {
        None
    }
}

impl Memory for () {}

/// The derivative at the end of the last step: the first stage of the next one.
///
/// Void after a reset, a jump of the input, and a change of the mode or the model.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct EndDerivative<S>(pub Option<S>);

impl<S> Default for EndDerivative<S> {
    fn default() -> Self {
        Self(None)
    }
}

impl<S: Copy + PartialEq + Debug + Send> Memory for EndDerivative<S> {
    #[inline]
    fn restart(&mut self) {
        self.0 = None;
    }

    #[inline]
    fn begin_tick(&mut self) {
        self.0 = None;
    }
}
