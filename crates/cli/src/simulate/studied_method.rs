//! Any method by its name, Taylor's included, which knows the series of a model.

use pode::stepper::{Any, Taylor, Tolerance};
use pode::{Nature, Stepper as _};

/// A method of which simulations are made.
///
/// Taylor's stands apart from [`Any`]: it carries whole expansions, for which the voices of a
/// keyboard have no room.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum StudiedMethod {
    OneOfMany(Any),
    Taylor(Taylor),
}

/// Does something with a method of its own type.
pub trait MethodVisitor {
    type Output;

    /// Does it with the stepper of a method.
    fn visit<T: pode::Stepper>(self, stepper: T) -> Self::Output;
}

impl Default for StudiedMethod {
    fn default() -> Self {
        Self::OneOfMany(Any::default())
    }
}

impl StudiedMethod {
    /// Names of all methods.
    pub fn names() -> impl Iterator<Item = &'static str> + Clone {
        Any::NAMES.iter().copied().chain([Taylor::NAME])
    }

    /// Names of the methods that heed a tolerance.
    pub fn tolerant() -> impl Iterator<Item = &'static str> + Clone {
        Any::TOLERANT.iter().copied().chain([Taylor::NAME])
    }

    /// Returns the method called `name` with its defaults.
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

    /// Returns the name of the method that is taken in a mode of this `nature`.
    pub fn name_in(&self, nature: &Nature) -> &'static str {
        match self {
            Self::OneOfMany(method) => method.name_in(nature),
            Self::Taylor(method) => method.name_in(nature),
        }
    }

    /// Returns the order of convergence of the method, or its highest.
    pub const fn order(&self) -> u32 {
        match self {
            Self::OneOfMany(method) => method.order(),
            Self::Taylor(_) => Taylor::ORDER,
        }
    }

    /// Returns the method as precise as `tolerance` says, in ticks of `tick` (s); `None` for one
    /// that has no say in its error.
    pub fn with_tolerance(self, tolerance: f64, tick: f64) -> Option<Self> {
        Some(match self {
            Self::OneOfMany(method) => Self::OneOfMany(method.with_tolerance(tolerance, tick)?),
            Self::Taylor(_) => Self::Taylor(Taylor::to(Tolerance::both(tolerance))),
        })
    }

    /// Does something with the method.
    pub fn visit<V: MethodVisitor>(self, visitor: V) -> V::Output {
        match self {
            Self::OneOfMany(method) => visitor.visit(method),
            Self::Taylor(method) => visitor.visit(method),
        }
    }
}
