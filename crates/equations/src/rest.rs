//! Where a model rests: the equilibrium of its rest mode, and constraints met by Newton's method.

use pode::{Matrix as _, Model as _, Motion, State};

use crate::jacobian_bound::matrix;
use crate::mode_number::ModeNumber;
use crate::model::EquationModel;
use crate::table::{FunctionId, Functions, ModeTable};

/// From a guess a tenth off Newton needs 4 to 6 rounds; 40 leave room for soft felts.
const ROUNDS: usize = 40;
/// A step that moves each entry by less than this part of it is rounding.
const ROUNDING: f64 = 4e-16;

impl<F: Functions + Copy, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Returns mode and state at rest under a constant input, or where the table says that it
    /// starts.
    ///
    /// # Real-time
    /// Bounded: Newton's method stops after 40 rounds. A mode that has no equilibrium near the
    /// table's guess rests at the guess.
    pub fn at_rest(&self, input: &Motion) -> (ModeNumber, [f64; N]) {
        let rest = self.table().rest;
        let mode = ModeNumber(rest.mode);
        let still = Motion { position: input.position, ..Motion::default() };
        let mut guess = [0.0; N];
        self.call(rest.state, &[0.0; N], &still, &mut guess);
        let guess = self.constrain(mode, &guess, &still);
        let x = if rest.is_improved { self.balanced(mode, guess, &still) } else { guess };
        (mode, self.constrain(mode, &x, input))
    }

    /// The equilibrium near `guess`, or `guess`.
    fn balanced(&self, mode: ModeNumber, guess: [f64; N], input: &Motion) -> [f64; N] {
        let table = self.mode(mode);
        let moving = table.parts.iter().fold(0, |all, part| all | part.entries);
        let mut x = guess;
        for _ in 0..ROUNDS {
            let Some(step) = self.newton_step(table, moving, &x, input) else { return guess };
            x = self.constrain(mode, &x.plus(1.0, &step), input);
            if step.iter().zip(&x).all(|(step, x)| step.abs() <= ROUNDING * x.abs().max(0.01)) {
                break;
            }
        }
        if x.iter().all(|entry| entry.is_finite()) { x } else { guess }
    }

    /// A step of Newton's method towards a zero of the derivative's entries that move.
    fn newton_step(
        &self,
        table: &ModeTable,
        moving: u64,
        x: &[f64; N],
        input: &Motion,
    ) -> Option<[f64; N]> {
        let has = |index: usize| index < self.table().states.len() && moving >> index & 1 == 1;
        let (rates, rows) = self.held_up(table, x, input);
        let imbalance = core::array::from_fn(|i| if has(i) { rates[i] } else { 0.0 });
        // 1 − M is minus the Jacobian where something moves, and 1 elsewhere.
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let entry = |i, j| if has(i) && has(j) { unit(i, j) + rows[i][j] } else { 0.0 };
        let shifted = core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)));
        let shifted: <[f64; N] as State>::Matrix = matrix(&shifted);
        let factored = shifted.factor(1.0);
        <[f64; N] as State>::Matrix::solve(&factored, &imbalance)
            .filter(|step| step.iter().all(|entry| entry.is_finite()))
    }

    /// The derivative with all contacts whose surfaces touch, and its derivative by the state.
    fn held_up(
        &self,
        table: &ModeTable,
        x: &[f64; N],
        input: &Motion,
    ) -> ([f64; N], [[f64; N]; N]) {
        let mut rates = [0.0; N];
        self.call(table.derivative, x, input, &mut rates);
        let mut rows = self.jacobian_rows(table.jacobian, x, input);
        for contact in table.contacts {
            let Some(gap) = contact.gap else { continue };
            let [gap, _]: [f64; 2] = self.values(gap, x, input);
            if gap <= 0.0 {
                self.add_normal(contact.normal, x, input, &mut rates);
                add_rows(&mut rows, &self.contact_rows(contact.jacobian, x, input));
            }
        }
        (rates, rows)
    }

    /// Adds what a closed contact adds to the derivative.
    #[inline]
    pub(crate) fn add_normal(
        &self,
        normal: Option<FunctionId>,
        x: &[f64; N],
        input: &Motion,
        rates: &mut [f64; N],
    ) {
        let Some(normal) = normal else { return };
        let mut added = [0.0; N];
        self.call(normal, x, input, &mut added);
        *rates = rates.plus(1.0, &added);
    }

    /// What it adds to the derivative's derivative.
    pub(crate) fn contact_rows(
        &self,
        jacobian: Option<FunctionId>,
        x: &[f64; N],
        input: &Motion,
    ) -> [[f64; N]; N] {
        jacobian.map_or([[0.0; N]; N], |jacobian| self.jacobian_rows(jacobian, x, input))
    }

    /// The state on the constraints that are not solved in closed form, by a few Newton steps.
    #[cold]
    pub(crate) fn projected(
        &self,
        projection: FunctionId,
        mode: &ModeTable,
        x: [f64; N],
        input: &Motion,
    ) -> [f64; N] {
        /// Along an orbit one is enough; after an event a few.
        const STEPS: usize = 8;
        /// What is left of a constraint (m or rad).
        const NOTHING: f64 = 1e-14;
        let (count, drifts) = (self.table().states.len(), mode.projected);
        let mut x = x;
        for _ in 0..STEPS {
            let mut out = [[0.0; N]; 3];
            self.call(projection, &x, input, out.as_flattened_mut());
            let flat = out.as_flattened();
            let drift = flat.iter().skip(count).take(drifts);
            let most = drift.fold(0.0, |most: f64, drift| most.max(drift.abs()));
            if !most.is_finite() || most <= NOTHING {
                break;
            }
            x = core::array::from_fn(|i| if i < count { flat[i] } else { 0.0 });
        }
        x
    }
}

/// Adds matrices entry by entry.
pub(crate) fn add_rows<const N: usize>(rows: &mut [[f64; N]; N], more: &[[f64; N]; N]) {
    for (row, more) in rows.iter_mut().zip(more) {
        *row = row.plus(1.0, more);
    }
}
