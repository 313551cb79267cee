//! One mode's equations over one step, with its evaluations counted.

use crate::input::Signal;
use crate::model::Model;
use crate::nature::Nature;
use crate::outcome::Work;
use crate::part::Part;
use crate::state::{Matrix as _, State};
use crate::stepper::{Field, differences, unit_differences};

/// The right-hand side of one part of a mode over a part of the tick.
pub(super) struct ModeField<'a, M: Model, S> {
    model: &'a M,
    mode: M::Mode,
    /// The part of the mode, and its place among them.
    part: Part,
    index: usize,
    signal: &'a S,
    /// Where the step begins in the tick.
    theta: f64,
    /// Which part of the tick it is.
    span: f64,
    derivatives: u32,
    jacobians: u32,
}

impl<'a, M: Model, S: Signal<M::Input>> ModeField<'a, M, S> {
    /// The equations of a part of `mode` over the part of the tick that begins at θ and has the
    /// length.
    #[inline]
    pub(super) const fn new(
        model: &'a M,
        (mode, index, part): (M::Mode, usize, Part),
        signal: &'a S,
        (theta, span): (f64, f64),
    ) -> Self {
        Self { model, mode, part, index, signal, theta, span, derivatives: 0, jacobians: 0 }
    }

    /// Adds the evaluations to the tick's.
    #[inline]
    pub(super) fn count(&self, work: &mut Work) {
        work.derivatives += self.derivatives;
        work.rates += self.derivatives * self.part.count(M::State::ZERO.entries().len());
        work.jacobians += self.jacobians;
    }

    /// The derivative of the part's entries, zero for the others.
    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn rates(&self, x: &M::State, input: &M::Input) -> M::State {
        if self.part.is_whole() {
            self.model.derivative(self.mode, x, input)
        } else {
            self.part.only(&self.model.derivative_of(self.mode, self.index, x, input))
        }
    }

    /// The derivative of the part's entries by themselves, zero for the others.
    fn jacobian_of_part(&self, x: &M::State, input: &M::Input) -> <M::State as State>::Matrix {
        let rates = |x: &M::State| self.rates(x, input);
        let matrix: <M::State as State>::Matrix =
            if self.nature().is_linear() { unit_differences(rates) } else { differences(x, rates) };
        let unit = |index| M::State::ZERO.with_entry(index, 1.0);
        <M::State as State>::Matrix::from_columns(|index| {
            if self.part.has(index) { matrix.apply(&unit(index)) } else { M::State::ZERO }
        })
    }
}

impl<M: Model, S: Signal<M::Input>> Field<M::State> for ModeField<'_, M, S> {
    #[inline]
    fn coords(&self) -> usize {
        M::COORDS
    }

    #[inline]
    fn nature(&self) -> Nature {
        self.part.nature(self.model.nature(self.mode))
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn derivative(&mut self, tau: f64, x: &M::State) -> M::State {
        self.derivatives += 1;
        self.rates(x, &self.signal.at(self.theta + tau * self.span))
    }

    #[inline]
    fn jacobian(&mut self, tau: f64, x: &M::State) -> <M::State as State>::Matrix {
        self.jacobians += 1;
        let input = self.signal.at(self.theta + tau * self.span);
        if self.part.is_whole() {
            self.model.jacobian(self.mode, x, &input)
        } else {
            self.jacobian_of_part(x, &input)
        }
    }
}
