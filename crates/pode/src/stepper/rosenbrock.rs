//! The stages of a Rosenbrock method, whatever its coefficients.

use crate::state::State;
use crate::stepper::Field;
use crate::stepper::shifted::Shifted;

/// Coefficients in the form that needs no product with the Jacobian:
///
/// ```text
/// (1 − γ h J) uᵢ = γ (h f(t0 + nodeᵢ h, x0 + Σ aᵢⱼ uⱼ) + Σ cᵢⱼ uⱼ + dᵢ h² ∂f/∂t)
/// ```
///
/// `[HW96]` IV.7, eq. 7.25, for systems that depend on the time.
pub(super) struct Tableau<const N: usize> {
    pub(super) gamma: f64,
    pub(super) nodes: [f64; N],
    pub(super) a: [[f64; N]; N],
    pub(super) c: [[f64; N]; N],
    pub(super) d: [f64; N],
    /// Number of first stages at the start, which share its derivative.
    pub(super) at_start: usize,
}

impl<const N: usize> Tableau<N> {
    /// Computes the stages of a step of `h` (s) from `x0`, with the derivative `f0` there and
    /// `time_slope` = h ∂f/∂t: one Jacobian, one LU, one solution per stage.
    #[inline]
    pub(super) fn stages<S: State>(
        &self,
        field: &mut impl Field<S>,
        (x0, f0): (&S, &S),
        time_slope: &S,
        h: f64,
    ) -> [S; N] {
        let lu = Shifted::new(&field.jacobian(0.0, x0), self.gamma * h);
        let mut u = [S::ZERO; N];
        for stage in 0..N {
            let f = if stage < self.at_start {
                *f0
            } else {
                field.derivative(self.nodes[stage], &x0.plus(1.0, &weighted(&self.a[stage], &u)))
            };
            let sum = weighted(&self.c[stage], &u).plus(h, &f);
            u[stage] = lu.solve(&sum.plus(self.d[stage] * h, time_slope).times(self.gamma));
        }
        u
    }
}

#[inline]
pub(super) fn weighted<S: State, const N: usize>(weights: &[f64; N], u: &[S; N]) -> S {
    let mut sum = S::ZERO;
    for (weight, u) in weights.iter().zip(u) {
        if weight.abs() > 0.0 {
            sum = sum.plus(*weight, u);
        }
    }
    sum
}
