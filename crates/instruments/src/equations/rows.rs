//! Contribution of a closed contact to the derivative and to its Jacobian.

use pode::{Motion, State as _};

use crate::equations::model::EquationModel;
use crate::equations::table::{Equations, FunctionId, ModeTable};

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
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

    /// Returns the Jacobian of a mode's derivative: its function's, or by central differences.
    pub(crate) fn mode_rows(
        &self,
        mode: &ModeTable,
        x: &[f64; N],
        input: &Motion,
    ) -> [[f64; N]; N] {
        match mode.jacobian {
            Some(jacobian) => self.jacobian_rows(jacobian, x, input),
            None => self.differenced(mode, x, input),
        }
    }

    /// Returns the central differences of a mode's derivative, along the constraints.
    #[cold]
    pub(crate) fn differenced(
        &self,
        mode: &ModeTable,
        x: &[f64; N],
        input: &Motion,
    ) -> [[f64; N]; N] {
        /// Step where rounding and curvature weigh the same: the cube root of ε. `[PTVF07]` 5.7
        const PART: f64 = 1.0 / 131_072.0;
        let moving = mode.parts.iter().fold(0, |all, part| all | part.entries);
        let mut rows = [[0.0; N]; N];
        for column in (0..N).filter(|column| moving >> column & 1 == 1) {
            let size = PART * x[column].abs().max(1.0);
            let [up, down] = [size, -size].map(|by| x[column] + by);
            let [above, below] = [up, down].map(|value| {
                let (mut x, mut rates) = (x.with_entry(column, value), [0.0; N]);
                self.put_in_place(mode, &mut x, input);
                self.call(mode.derivative, &x, input, &mut rates);
                rates
            });
            for ((entries, above), below) in rows.iter_mut().zip(above).zip(below) {
                entries[column] = (above - below) / (up - down);
            }
        }
        rows
    }

    pub(crate) fn contact_rows(
        &self,
        jacobian: Option<FunctionId>,
        x: &[f64; N],
        input: &Motion,
    ) -> [[f64; N]; N] {
        jacobian.map_or([[0.0; N]; N], |jacobian| self.jacobian_rows(jacobian, x, input))
    }
}

pub(crate) fn add_rows<const N: usize>(rows: &mut [[f64; N]; N], more: &[[f64; N]; N]) {
    for (row, more) in rows.iter_mut().zip(more) {
        *row = row.plus(1.0, more);
    }
}
