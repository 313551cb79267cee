//! One mode's equations over one step, with its evaluations counted.

use crate::input::Signal;
use crate::model::Model;
use crate::nature::Nature;
use crate::outcome::Work;
use crate::state::State;
use crate::stepper::Field;

/// The right-hand side of a mode over a part of the tick.
pub(super) struct ModeField<'a, M: Model, S> {
    model: &'a M,
    mode: M::Mode,
    signal: &'a S,
    /// Where the step begins in the tick.
    theta: f64,
    /// Which part of the tick it is.
    span: f64,
    derivatives: u32,
    jacobians: u32,
}

impl<'a, M: Model, S> ModeField<'a, M, S> {
    /// The equations of `mode` over the part of the tick that begins at θ and has the length.
    #[inline]
    pub(super) const fn new(
        model: &'a M,
        mode: M::Mode,
        signal: &'a S,
        (theta, span): (f64, f64),
    ) -> Self {
        Self { model, mode, signal, theta, span, derivatives: 0, jacobians: 0 }
    }

    /// Adds the evaluations to the tick's.
    #[inline]
    pub(super) const fn count(&self, work: &mut Work) {
        work.derivatives += self.derivatives;
        work.jacobians += self.jacobians;
    }
}

impl<M: Model, S: Signal<M::Input>> Field<M::State> for ModeField<'_, M, S> {
    #[inline]
    fn coords(&self) -> usize {
        M::COORDS
    }

    #[inline]
    fn nature(&self) -> Nature {
        self.model.nature(self.mode)
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn derivative(&mut self, tau: f64, x: &M::State) -> M::State {
        self.derivatives += 1;
        self.model.derivative(self.mode, x, &self.signal.at(self.theta + tau * self.span))
    }

    #[inline]
    fn jacobian(&mut self, tau: f64, x: &M::State) -> <M::State as State>::Matrix {
        self.jacobians += 1;
        self.model.jacobian(self.mode, x, &self.signal.at(self.theta + tau * self.span))
    }
}
