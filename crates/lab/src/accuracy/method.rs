//! The methods that are compared: the only list of them, one line each.

use pode::Stepper;
use pode::stepper::{
    AdamsBashforth2, AdamsBashforth3, Any, BogackiShampine, ByNeed, Controlled, Dop853, Exact,
    ExplicitEuler, ExponentialRosenbrock, Exprb32, Heun, LinearImplicitMidpoint, Rk4, Rodas3,
    Rodas4, Ros2, SemiImplicitEuler, Tolerance, Tsitouras5, VelocityVerlet,
};

use super::study::Setting;

/// A method by its name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NamedMethod {
    /// Its name on the command line and in reports.
    pub name: &'static str,
    /// Its order of convergence.
    pub order: u32,
    /// Where its steps come from.
    pub kind: MethodKind,
}

/// Where a method's steps come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MethodKind {
    /// One step a tick, up to an event.
    Fixed,
    /// The model's own longest step within a tick, as an instrument is played.
    Played,
    /// An error estimate and a tolerance, in long ticks.
    Controlled,
    /// An error budget, mode by mode, in ticks of 1 ms or less.
    Budgeted,
}

/// Something to be done with a method whose type is known by name only.
pub(super) trait Visit {
    type Output;

    fn visit<T: Stepper + Into<Any>>(self, stepper: T) -> Self::Output;
}

macro_rules! methods {
    (
        fixed: $($fixed:ty),+ $(,)?;
        $($other:ty as $name:literal, $kind:expr, $build:expr;)+
    ) => {
        /// Every method that is compared.
        pub const METHODS: &[NamedMethod] = &[
            $(method::<$fixed>(<$fixed>::NAME, MethodKind::Fixed),)+
            $(method::<$other>($name, $kind),)+
        ];

        /// Does something with the method called `name`, set as `setting` says.
        pub(super) fn visit<V: Visit>(name: &str, setting: &Setting, visitor: V) -> Option<V::Output> {
            $(if name == <$fixed>::NAME {
                return Some(visitor.visit(<$fixed>::default()));
            })+
            $(if name == $name {
                let build: fn(&Setting) -> $other = $build;
                return Some(visitor.visit(build(setting)));
            })+
            None
        }
    };
}

methods! {
    fixed:
        ExplicitEuler,
        SemiImplicitEuler,
        Heun,
        VelocityVerlet,
        AdamsBashforth2,
        AdamsBashforth3,
        BogackiShampine,
        Rk4,
        Tsitouras5,
        Exact,
        LinearImplicitMidpoint,
        Ros2,
        Rodas3,
        Rodas4,
        ExponentialRosenbrock,
        Exprb32;
    Controlled<Dop853> as "dop853-adaptive", MethodKind::Controlled, controlled;
    ByNeed as "by-need", MethodKind::Budgeted, budgeted;
    Rk4 as "as-played", MethodKind::Played, |_setting| Rk4;
}

const fn method<T: Stepper>(name: &'static str, kind: MethodKind) -> NamedMethod {
    NamedMethod { name, order: T::ORDER, kind }
}

/// The choice by need that meets the setting's budget.
fn budgeted(setting: &Setting) -> ByNeed {
    setting.tolerance.map_or_else(ByNeed::default, |budget| ByNeed::new(budget, setting.tick))
}

/// The method with steps by the setting's tolerance.
fn controlled<T: Stepper>(setting: &Setting) -> Controlled<T> {
    let tolerance = setting.tolerance.map_or_else(Tolerance::default, Tolerance::both);
    Controlled { method: T::default(), tolerance }
}
