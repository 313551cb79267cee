//! The model of a table as a `pode::Model`.

use pode::{Model, Motion, Nature, Part, State};

use crate::equations::jacobian_bound::matrix;
use crate::equations::mode_number::ModeNumber;
use crate::equations::model::{EquationModel, rates_of};
use crate::equations::table::Equations;

impl<F: Equations + Clone, const N: usize, const C: usize> Model for EquationModel<F, N, C> {
    type Mode = ModeNumber;
    type State = [f64; N];
    type Input = Motion;
    /// The table's count is the one that matters: [`Model::coordinates`].
    const COORDS: usize = N / 2;

    #[inline]
    fn coordinates(&self) -> usize {
        self.table().coordinates
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn derivative(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> [f64; N] {
        let mut out = [0.0; N];
        let rates = rates_of(input);
        let arguments = self.arguments(x, &rates, &[]);
        self.functions().call(self.mode_table(mode).derivative, &arguments, &mut out);
        out
    }

    #[inline]
    fn parts(&self, mode: ModeNumber) -> &[Part] {
        self.natures().parts(mode, self.mode_table(mode))
    }

    #[inline]
    fn derivative_of(
        &self,
        mode: ModeNumber,
        index: usize,
        x: &[f64; N],
        input: &Motion,
    ) -> [f64; N] {
        let mode = self.mode_table(mode);
        let mut out = [0.0; N];
        let function = mode.parts.get(index).map_or(mode.derivative, |part| part.derivative);
        self.call(function, x, input, &mut out);
        out
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn readout(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> f64 {
        let (rates, mut out) = (rates_of(input), [f64::NAN]);
        let arguments = self.arguments(x, &rates, &[]);
        self.functions().call(self.mode_table(mode).forces.readout, &arguments, &mut out);
        out[0]
    }

    fn jacobian(
        &self,
        mode: ModeNumber,
        x: &[f64; N],
        input: &Motion,
    ) -> <[f64; N] as State>::Matrix {
        matrix(&self.mode_rows(self.mode_table(mode), x, input))
    }

    #[inline]
    fn nature(&self, mode: ModeNumber) -> Nature {
        self.natures().nature(mode)
    }
}
