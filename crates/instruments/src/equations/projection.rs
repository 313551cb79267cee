//! Projection of the state on the constraints that no coordinate is solved from.

use pode::Motion;

use crate::equations::model::EquationModel;
use crate::equations::table::{Equations, FunctionId, ModeTable};

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    #[inline(never)]
    pub(super) fn put_in_place(&self, mode: &ModeTable, x: &mut [f64; N], input: &Motion) {
        if let Some(slaved) = mode.constraints.slaved {
            let before = *x;
            self.call(slaved, &before, input, x);
        }
        if let Some(projection) = mode.constraints.projection {
            *x = self.projected(projection, mode, *x, input);
        }
    }

    /// Projects the state on the constraints without closed form, by a few Newton steps.
    #[cold]
    pub(crate) fn projected(
        &self,
        projection: FunctionId,
        mode: &ModeTable,
        x: [f64; N],
        input: &Motion,
    ) -> [f64; N] {
        /// Number of Newton steps: along an orbit one is enough; an event needs a few.
        const STEPS: usize = 8;
        /// Accepted rest of a constraint (m or rad), or of its rate.
        const NOTHING: f64 = 1e-14;
        /// Rest below which one that no longer shrinks is rounding.
        const ROUNDING: f64 = 1e-10;
        let (count, drifts) = (self.table().states.len(), mode.constraints.projected);
        let (mut x, mut last) = (x, f64::INFINITY);
        for _ in 0..STEPS {
            let mut out = [[0.0; N]; 3];
            self.call(projection, &x, input, out.as_flattened_mut());
            let flat = out.as_flattened();
            let drift = flat.iter().skip(count).take(drifts);
            let most = drift.fold(0.0, |most: f64, drift| most.max(drift.abs()));
            let is_rounding = most <= NOTHING || (most <= ROUNDING && most >= last);
            if !most.is_finite() || is_rounding {
                break;
            }
            last = most;
            x = core::array::from_fn(|i| if i < count { flat[i] } else { 0.0 });
        }
        x
    }
}
