//! Any method by its name, with Taylor's, which needs the series of a model.

use pode::stepper::{Any, Taylor, Tolerance};
use pode::{Nature, Stepper as _};

/// A method of simulations.
///
/// Taylor's is not part of [`Any`]: it holds expansions too large for a keyboard's voices.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum StudiedMethod {
    OneOfMany(Any),
    Taylor(Taylor),
}

/// An operation on a method of its own type.
pub trait MethodVisitor {
    type Output;

    /// Applies the operation to the stepper of a method.
    fn visit<T: pode::Stepper>(self, stepper: T) -> Self::Output;
}

impl Default for StudiedMethod {
    fn default() -> Self {
        Self::OneOfMany(Any::default())
    }
}

impl StudiedMethod {
    pub fn names() -> impl Iterator<Item = &'static str> + Clone {
        Any::NAMES.iter().copied().chain([Taylor::NAME])
    }

    /// Returns the names of the methods with error control.
    pub fn tolerant() -> impl Iterator<Item = &'static str> + Clone {
        Any::TOLERANT.iter().copied().chain([Taylor::NAME])
    }

    pub fn named(name: &str) -> Option<Self> {
        if name == Taylor::NAME {
            return Some(Self::Taylor(Taylor::default()));
        }
        Any::named(name).map(Self::OneOfMany)
    }

    pub const fn name(&self) -> &'static str {
        match self {
            Self::OneOfMany(method) => method.name(),
            Self::Taylor(_) => Taylor::NAME,
        }
    }

    /// Returns the name of the method for a mode of this `nature`.
    pub fn name_in(&self, nature: &Nature) -> &'static str {
        match self {
            Self::OneOfMany(method) => method.name_in(nature),
            Self::Taylor(_) => Taylor::NAME,
        }
    }

    /// Returns the order of convergence of the method, or its highest.
    pub const fn order(&self) -> u32 {
        match self {
            Self::OneOfMany(method) => method.order(),
            Self::Taylor(_) => Taylor::ORDER,
        }
    }

    /// Sets the `tolerance`, for ticks of `tick` (s); `None` for a method without error control.
    pub fn with_tolerance(self, tolerance: f64, tick: f64) -> Option<Self> {
        Some(match self {
            Self::OneOfMany(method) => Self::OneOfMany(method.with_tolerance(tolerance, tick)?),
            Self::Taylor(_) => Self::Taylor(Taylor::to(Tolerance::both(tolerance))),
        })
    }

    pub fn visit<V: MethodVisitor>(self, visitor: V) -> V::Output {
        match self {
            Self::OneOfMany(method) => visitor.visit(method),
            Self::Taylor(method) => visitor.visit(method),
        }
    }
}
