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

/// The constants of one mode.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Nature {
    pub kind: EquationKind,
    /// Largest magnitude of the Jacobian's eigenvalues (rad/s); 0 where it is not known.
    pub rate: f64,
    /// Longest step that resolves the motion (s); a tick is cut to fit.
    pub longest_step: f64,
    /// Distance by which an event that leads to the mode may move a coordinate onto a constraint,
    /// in the unit of the coordinate; farther is a fault. Switching to a constraint that the state
    /// does not meet is where rigid models become unstable. `[GC93]` §6
    pub longest_projection: f64,
}

impl Default for Nature {
    fn default() -> Self {
        Self::new(EquationKind::default(), 0.0)
    }
}

impl Nature {
    /// A `kind` whose fastest motion has `rate` (rad/s), with steps and projections of any length.
    pub const fn new(kind: EquationKind, rate: f64) -> Self {
        Self { kind, rate, longest_step: f64::INFINITY, longest_projection: f64::INFINITY }
    }

    /// Returns the nature with a longest step (s).
    #[must_use]
    pub const fn with_longest_step(self, longest_step: f64) -> Self {
        Self { longest_step, ..self }
    }

    /// Whether the mode has an exact flow.
    #[inline]
    pub const fn is_linear(&self) -> bool {
        matches!(self.kind, EquationKind::Linear | EquationKind::Affine)
    }
}
