/// Kind of a mode's equations.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum EquationKind {
    /// x' = A x + c with constant A and c, whatever the input: gravity and springs.
    Affine,
    /// x' = A x + r(t) with a constant A and r by the input.
    Linear,
    #[default]
    Smooth,
    /// Smooth, and its energy is stored, not lost.
    Conservative,
    /// A part of the motion dies out much faster than the rest.
    Stiff,
}

/// Constants of one mode: its kind of equations, rate and limits.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Nature {
    pub kind: EquationKind,
    /// Largest magnitude of the Jacobian's eigenvalues (rad/s); 0 if unknown.
    pub rate: f64,
    /// Longest step that resolves the motion (s); a tick is cut to fit.
    pub longest_step: f64,
    /// Largest move of a coordinate onto a constraint by an event that leads to the mode, in the
    /// coordinate's unit; beyond is a fault. Rigid models become unstable when they switch to a
    /// constraint that the state does not meet. `[GC93]` §6
    pub longest_projection: f64,
}

impl Default for Nature {
    fn default() -> Self {
        Self::new(EquationKind::default(), 0.0)
    }
}

impl Nature {
    /// Builds a nature with a fastest motion of `rate` (rad/s), without limits.
    pub const fn new(kind: EquationKind, rate: f64) -> Self {
        Self { kind, rate, longest_step: f64::INFINITY, longest_projection: f64::INFINITY }
    }

    /// Returns the nature with a longest step (s).
    #[must_use]
    pub const fn with_longest_step(self, longest_step: f64) -> Self {
        Self { longest_step, ..self }
    }

    /// Returns how many times faster than its rate the motion is where the model asks for steps of
    /// `own` (s): as of a contact that the rate does not contain.
    #[inline]
    pub fn excess(&self, own: f64) -> f64 {
        let ratio = self.longest_step / own;
        if ratio > 1.0 && ratio.is_finite() { ratio } else { 1.0 }
    }

    /// Returns the nature of a motion that is `times` as fast.
    #[inline]
    #[must_use]
    pub const fn faster(self, times: f64) -> Self {
        Self { rate: self.rate * times, longest_step: self.longest_step / times, ..self }
    }

    /// Returns `true` if the mode has an exact flow.
    #[inline]
    pub const fn is_linear(&self) -> bool {
        matches!(self.kind, EquationKind::Linear | EquationKind::Affine)
    }
}
