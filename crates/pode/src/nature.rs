//! What a model says of a mode's equations, as far as choosing a method goes.

/// What kind of equations a mode has.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum EquationKind {
    /// x' = A x + c with constant A and c, whatever the input: gravity and springs.
    Affine,
    /// x' = A x + r(t) with a constant A, r by the input.
    Linear,
    /// Smooth over several steps.
    #[default]
    Smooth,
    /// Smooth, and its energy is stored, not lost.
    Conservative,
    /// Some of the motion dies out much faster than anybody looks.
    Stiff,
}

/// The nature of one mode: its kind, and its fastest rate.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Nature {
    /// What kind of equations.
    pub kind: EquationKind,
    /// Largest magnitude of the Jacobian's eigenvalues (rad/s); 0 where it is not known.
    pub rate: f64,
}

impl Nature {
    /// A `kind` whose fastest motion has `rate` (rad/s).
    pub const fn new(kind: EquationKind, rate: f64) -> Self {
        Self { kind, rate }
    }

    /// Whether the mode has an exact flow.
    #[inline]
    pub const fn is_linear(&self) -> bool {
        matches!(self.kind, EquationKind::Linear | EquationKind::Affine)
    }
}
