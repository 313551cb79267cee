//! Contribution of a closed contact to the derivative and to its Jacobian.

use pode::{Motion, State as _};

use crate::equations::model::EquationModel;
use crate::equations::table::{Equations, FunctionId};

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
