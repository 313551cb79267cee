//! One mode's equations over one step, with counted evaluations.

use crate::input::Signal;
use crate::mechanical::{MAX_SPEEDS, MechanicalOutcome, MechanicalStep};
use crate::model::{Guarded, Model};
use crate::nature::Nature;
use crate::outcome::Work;
use crate::part::Part;
use crate::state::{Matrix as _, State};
use crate::stepper::{Field, differences, unit_differences};

/// Index of all parts of a mode taken as one.
pub(super) const TOGETHER: usize = usize::MAX;

pub(super) struct ModeField<'a, M: Model, S> {
    model: &'a M,
    mode: M::Mode,
    part: Part,
    index: usize,
    signal: &'a S,
    theta: (f64, f64),
    /// Place of the last input, and that input: stages share instants, and an input may be costly.
    last: (f64, M::Input),
    derivatives: u32,
    jacobians: u32,
    excess: f64,
}

impl<'a, M: Guarded, S: Signal<M::Input>> ModeField<'a, M, S> {
    /// Builds the equations of a part of `mode` between two θ, with the `input` at the first, in a
    /// motion that is `excess` times as fast as the mode's rate.
    #[inline]
    pub(super) const fn new(
        model: &'a M,
        (mode, index, part): (M::Mode, usize, Part),
        signal: &'a S,
        theta: (f64, f64),
        input: M::Input,
        excess: f64,
    ) -> Self {
        let last = (0.0, input);
        Self { model, mode, part, index, signal, theta, last, derivatives: 0, jacobians: 0, excess }
    }

    #[inline]
    fn input(&mut self, tau: f64) -> M::Input {
        if self.last.0.to_bits() != tau.to_bits() {
            let (start, end) = self.theta;
            let theta = if tau < 1.0 { start + tau * (end - start) } else { end };
            self.last = (tau, self.signal.at(theta));
        }
        self.last.1
    }

    #[inline]
    pub(super) fn known_end_input(&self) -> Option<M::Input> {
        (self.last.0.to_bits() == 1.0_f64.to_bits()).then_some(self.last.1)
    }

    #[inline]
    pub(super) fn end_input(&mut self) -> M::Input {
        self.input(1.0)
    }

    #[inline]
    pub(super) fn count(&self, work: &mut Work) {
        work.derivatives += self.derivatives;
        work.rates += self.derivatives * self.part.count(M::State::ZERO.entries().len());
        work.jacobians += self.jacobians;
    }

    /// Computes the derivative of the part's entries, zero for the others.
    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn rates(&self, x: &M::State, input: &M::Input) -> M::State {
        let rates = if self.index == TOGETHER {
            self.model.derivative(self.mode, x, input)
        } else {
            self.model.derivative_of(self.mode, self.index, x, input)
        };
        if self.part.is_whole() { rates } else { M::State::ZERO.with_entries(&rates, &self.part) }
    }

    /// Computes the model's Jacobian for the entries of all parts, zero for the others.
    fn jacobian_of_all(&self, x: &M::State, input: &M::Input) -> <M::State as State>::Matrix {
        let matrix = self.model.jacobian(self.mode, x, input);
        <M::State as State>::Matrix::from_columns(|index| {
            if !self.part.has(index) {
                return M::State::ZERO;
            }
            let column = matrix.apply(&M::State::ZERO.with_entry(index, 1.0));
            M::State::ZERO.with_entries(&column, &self.part)
        })
    }

    /// Differences the derivative of the part's entries by themselves, zero for the others.
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

impl<M: Guarded, S: Signal<M::Input>> Field<M::State> for ModeField<'_, M, S> {
    #[inline]
    fn coords(&self) -> usize {
        self.model.coordinates()
    }

    #[inline]
    fn nature(&self) -> Nature {
        self.part.nature(self.model.nature(self.mode)).faster(self.excess)
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn derivative(&mut self, tau: f64, x: &M::State) -> M::State {
        self.derivatives += 1;
        let input = self.input(tau);
        self.rates(x, &input)
    }

    #[inline]
    fn mechanical_acceleration(&mut self, x: &M::State) -> Option<[f64; MAX_SPEEDS]> {
        let mechanical = self.model.mechanical()?;
        let input = self.input(0.0);
        let found = mechanical.acceleration(self.mode, x, &input);
        self.derivatives += u32::from(found.is_some());
        found
    }

    #[inline]
    fn mechanical_step(
        &mut self,
        x: &M::State,
        step: &MechanicalStep,
    ) -> Option<MechanicalOutcome<M::State>> {
        let mechanical = self.model.mechanical()?;
        let input = self.input(1.0);
        let end = mechanical.step(self.mode, x, &input, step);
        self.derivatives += u32::from(end.is_some());
        end
    }

    #[inline]
    fn jacobian(&mut self, tau: f64, x: &M::State) -> <M::State as State>::Matrix {
        self.jacobians += 1;
        let input = self.input(tau);
        if self.part.is_whole() {
            self.model.jacobian(self.mode, x, &input)
        } else if self.index == TOGETHER {
            self.jacobian_of_all(x, &input)
        } else {
            self.jacobian_of_part(x, &input)
        }
    }
}
