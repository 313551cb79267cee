//! A method's memory between steps, and its invalidation.

use core::fmt::Debug;

/// A method's knowledge of the steps before.
pub trait Memory: Copy + PartialEq + Default + Debug + Send {
    /// Clears the memory: the state jumped, the mode changed, or the step was cut short.
    #[inline]
    fn restart(&mut self) {}

    /// Notes that the last step is refused; another follows from the same state.
    #[inline]
    fn refuse(&mut self) {
        self.restart();
    }

    /// Begins a tick: the input and the model's parameters may have jumped.
    #[inline]
    fn begin_tick(&mut self) {}

    /// Notes that the input jumps here, which changes derivatives but not the state.
    fn jump(&mut self) {}

    /// Returns the longest step (s) that is worth trying next; methods that set their steps take them
    /// `stretch` times as long as usual.
    #[inline]
    fn reach(&self, _stretch: f64) -> f64 {
        f64::INFINITY
    }

    /// Returns `true` if the method sets its steps in the present mode, so the model's do not count.
    #[inline]
    fn sets_steps(&self) -> bool {
        false
    }
}

impl Memory for () {}

/// The derivative at the end of the last step: the first stage of the next one. Void after a reset,
/// a jump of the input, and a change of the mode or the model.
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
