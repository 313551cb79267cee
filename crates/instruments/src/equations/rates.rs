//! Longest step of a mode that stiffens, by the current state.

use pode::{Model as _, Motion, State as _};

use crate::equations::jacobian_bound::{RADIANS, fastest};
use crate::equations::mode_number::ModeNumber;
use crate::equations::model::EquationModel;
use crate::equations::table::Equations;

const ROUNDS_AT: usize = 5;

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Returns the longest step (s) from `x`, at most `longest`: by the Jacobian at `x`, and at the
    /// coordinates at the end of that step. Two Jacobians and a derivative, in modes that stiffen.
    #[cold]
    pub(crate) fn step_at(
        &self,
        mode: ModeNumber,
        longest: f64,
        x: &[f64; N],
        input: &Motion,
    ) -> f64 {
        let jacobian = |x: &[f64; N]| self.mode_rows(self.mode_table(mode), x, input);
        let rates = self.derivative(mode, x, input);
        self.step_by(|x| self.fastest_of(&jacobian(x)), (longest, rates), x)
    }

    /// Returns the fastest rate (rad/s) of a Jacobian of the whole state.
    pub(crate) fn fastest_of(&self, rows: &[[f64; N]; N]) -> f64 {
        fastest(rows, all_of(self.table().states.len()), ROUNDS_AT)
    }

    /// Like `step_at`, by any bound of the fastest rate (rad/s), with the rates of the state.
    pub(crate) fn step_by(
        &self,
        fastest: impl Fn(&[f64; N]) -> f64,
        (longest, rates): (f64, [f64; N]),
        x: &[f64; N],
    ) -> f64 {
        /// Look-ahead of a step without a rate of its own (s).
        const AHEAD: f64 = 1e-3;
        let step = |x: &[f64; N]| RADIANS / fastest(x);
        let own = longest.min(step(x));
        let moved = x.plus(own.min(AHEAD), &rates);
        let later = moved_head(x, &moved, self.table().coordinates);
        own.min(step(&later))
    }
}

fn all_of(count: usize) -> u64 {
    u64::MAX.checked_shr(u64::BITS - u32::try_from(count).unwrap_or(u64::BITS)).unwrap_or(0)
}

fn moved_head<const N: usize>(x: &[f64; N], moved: &[f64; N], count: usize) -> [f64; N] {
    moved.head_of(count, x)
}
