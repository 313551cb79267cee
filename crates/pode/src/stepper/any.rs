use crate::dense::{Cubic, Dense, DenseBounds, Polynomial};
use crate::mechanical::{MAX_SPEEDS, MechanicalOutcome, MechanicalStep};
use crate::nature::Nature;
use crate::part::Part;
use crate::state::State;
use crate::stepper::{
    AdamsBashforth2, AdamsBashforth3, BogackiShampine, ByNeed, Controlled, Dense8, Dop853, Exact,
    ExplicitEuler, Field, Flow, FlowOrCubic, Heun, LinearImplicitMidpoint, Memory, Newmark, Rk4,
    Rodas3, SemiImplicitEuler, Step, Stepper, Tolerance, Tsitouras5, VelocityVerlet,
};

/// Dense output of any method.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum AnyDense<S> {
    Cubic(Cubic<S>),
    Quartic(Polynomial<S, 5>),
    Flow(Flow<S>),
    Eighth(Dense8<S>),
}

impl<S: State> AnyDense<S> {
    fn series(&self) -> Option<Flow<S>> {
        match self {
            Self::Cubic(dense) => Some(dense.lengthened()),
            Self::Quartic(dense) => Some(dense.lengthened()),
            Self::Flow(dense) => Some(*dense),
            Self::Eighth(_) => None,
        }
    }
}

impl<S: State> Dense<S> for AnyDense<S> {
    fn still(x: &S) -> Self {
        Self::Cubic(Cubic::still(x))
    }

    fn merged(&self, other: &Self, part: &Part) -> Self {
        match (self, other) {
            (Self::Cubic(mine), Self::Cubic(other)) => Self::Cubic(mine.merged(other, part)),
            (Self::Quartic(mine), Self::Quartic(other)) => Self::Quartic(mine.merged(other, part)),
            (Self::Eighth(mine), Self::Eighth(other)) => Self::Eighth(mine.merged(other, part)),
            // A solution without motion is a cubic, whatever the method.
            (_, Self::Eighth(other)) => {
                Self::Eighth(Dense8::still(&self.at(0.0)).merged(other, part))
            }
            _ => self
                .series()
                .zip(other.series())
                .map_or(*self, |(mine, other)| Self::Flow(mine.merged(&other, part))),
        }
    }

    fn within(&self, from: f64, to: f64) -> Option<Self> {
        match self {
            Self::Cubic(dense) => dense.within(from, to).map(Self::Cubic),
            Self::Quartic(dense) => dense.within(from, to).map(Self::Quartic),
            Self::Flow(dense) => dense.within(from, to).map(Self::Flow),
            Self::Eighth(_) => None,
        }
    }

    fn at(&self, tau: f64) -> S {
        match self {
            Self::Cubic(dense) => dense.at(tau),
            Self::Quartic(dense) => dense.at(tau),
            Self::Flow(dense) => dense.at(tau),
            Self::Eighth(dense) => dense.at(tau),
        }
    }

    fn end(&self) -> &S {
        match self {
            Self::Cubic(dense) => dense.end(),
            Self::Quartic(dense) => dense.end(),
            Self::Flow(dense) => dense.end(),
            Self::Eighth(dense) => dense.end(),
        }
    }

    fn bounds(&self) -> Option<DenseBounds<S>> {
        match self {
            Self::Cubic(dense) => dense.bounds(),
            Self::Quartic(dense) => dense.bounds(),
            Self::Flow(dense) => dense.bounds(),
            Self::Eighth(dense) => dense.bounds(),
        }
    }
}

/// A dense output that [`AnyDense`] can hold.
pub trait Fits<S>: Sized {
    fn wide(self) -> AnyDense<S>;

    fn narrow(any: &mut AnyDense<S>) -> Option<&mut Self>;
}

macro_rules! fits {
    ($($kind:ident($dense:ty)),+) => {$(
        impl<S: State> Fits<S> for $dense {
            fn wide(self) -> AnyDense<S> {
                AnyDense::$kind(self)
            }

            fn narrow(any: &mut AnyDense<S>) -> Option<&mut Self> {
                if let AnyDense::$kind(dense) = any { Some(dense) } else { None }
            }
        }
    )+};
}

fits!(Cubic(Cubic<S>), Quartic(Polynomial<S, 5>), Flow(Flow<S>), Eighth(Dense8<S>));

impl<S: State> Fits<S> for FlowOrCubic<S> {
    fn wide(self) -> AnyDense<S> {
        match self {
            Self::Flow(dense) => AnyDense::Flow(dense),
            Self::Cubic(dense) => AnyDense::Cubic(dense),
        }
    }

    fn narrow(_any: &mut AnyDense<S>) -> Option<&mut Self> {
        None
    }
}

/// A field with its type erased, so that each method is compiled once per state, not per model.
struct Erased<'a, S>(&'a mut dyn Field<S>);

impl<S: State> Field<S> for Erased<'_, S> {
    fn coords(&self) -> usize {
        self.0.coords()
    }

    fn nature(&self) -> Nature {
        self.0.nature()
    }

    fn derivative(&mut self, tau: f64, x: &S) -> S {
        self.0.derivative(tau, x)
    }

    fn jacobian(&mut self, tau: f64, x: &S) -> S::Matrix {
        self.0.jacobian(tau, x)
    }

    fn mechanical_acceleration(&mut self, x: &S) -> Option<[f64; MAX_SPEEDS]> {
        self.0.mechanical_acceleration(x)
    }

    fn mechanical_step(&mut self, x: &S, step: &MechanicalStep) -> Option<MechanicalOutcome<S>> {
        self.0.mechanical_step(x, step)
    }
}

macro_rules! any {
    (
        named { $($(#[$doc:meta])* $name:ident($stepper:ty)),+ $(,)? }
        controlled { $($(#[$of:meta])* $controlled:ident($how:ty)),+ $(,)? }
    ) => {
        impl Any {
            pub const NAMES: &[&str] = &[$(<$stepper>::NAME),+];
        }

        any! { @all $($(#[$doc])* $name($stepper),)+ $($(#[$of])* $controlled($how)),+ }
    };
    (@all $($(#[$doc:meta])* $name:ident($stepper:ty)),+) => {
        /// Any of the methods, chosen at run time, for simulations set up by name where a
        /// nanosecond does not count. Steps are the method's own to the last bit, as are orders,
        /// dense output and memory.
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub enum Any {
            $($(#[$doc])* $name($stepper)),+
        }

        /// Memory of the chosen method.
        #[derive(Clone, Copy, PartialEq, Debug, Default)]
        pub enum AnyMemory<S: State> {
            #[default]
            None,
            $($(#[$doc])* $name(<$stepper as Stepper>::Memory<S>)),+
        }

        impl<S: State> Memory for AnyMemory<S> {
            fn restart(&mut self) {
                match self {
                    Self::None => {}
                    $(Self::$name(memory) => memory.restart()),+
                }
            }

            fn begin_tick(&mut self) {
                match self {
                    Self::None => {}
                    $(Self::$name(memory) => memory.begin_tick()),+
                }
            }

            fn jump(&mut self) {
                match self {
                    Self::None => {}
                    $(Self::$name(memory) => memory.jump()),+
                }
            }

            fn refuse(&mut self) {
                match self {
                    Self::None => {}
                    $(Self::$name(memory) => memory.refuse()),+
                }
            }

            fn reach(&self, stretch: f64) -> f64 {
                match self {
                    Self::None => f64::INFINITY,
                    $(Self::$name(memory) => memory.reach(stretch)),+
                }
            }

            fn sets_steps(&self) -> bool {
                match self {
                    Self::None => false,
                    $(Self::$name(memory) => memory.sets_steps()),+
                }
            }
        }

        impl Any {
            /// Returns the method called `name` with its defaults; the first of several.
            pub fn named(name: &str) -> Option<Self> {
                $(if name == <$stepper>::NAME {
                    return Some(Self::$name(<$stepper>::default()));
                })+
                None
            }

            /// Returns its name on the command line.
            pub const fn name(&self) -> &'static str {
                match self {
                    $(Self::$name(_) => <$stepper>::NAME),+
                }
            }

            pub const fn order(&self) -> u32 {
                match self {
                    $(Self::$name(_) => <$stepper>::ORDER),+
                }
            }
        }

        impl Stepper for Any {
            /// Order of the coarsest method.
            const ORDER: u32 = 1;
            /// Order of the smoothest dense output, which bounds the work of a tick.
            const DENSE: u32 = 23;
            const EVALUATIONS: u32 = Dop853::EVALUATIONS;
            const REFINEMENT: u32 = Dop853::REFINEMENT;
            const JACOBIANS: u32 = 1;
            const NAME: &'static str = "any";

            type Memory<S: State> = AnyMemory<S>;
            type Dense<S: State> = AnyDense<S>;

            fn step<S: State>(
                &self,
                field: &mut impl Field<S>,
                x0: &S,
                memory: &mut AnyMemory<S>,
                h: f64,
            ) -> Step<S, AnyDense<S>> {
                self.step_erased(&mut Erased(field), x0, memory, h)
            }

            fn refine<S: State>(
                &self,
                field: &mut impl Field<S>,
                memory: &AnyMemory<S>,
                dense: &mut AnyDense<S>,
                h: f64,
            ) {
                self.refine_erased(&mut Erased(field), memory, dense, h);
            }

            fn longest_step(&self, nature: &Nature, own: f64) -> f64 {
                match self {
                    $(Self::$name(stepper) => stepper.longest_step(nature, own)),+
                }
            }

            fn steps_apart(&self, entries: usize) -> bool {
                match self {
                    $(Self::$name(stepper) => stepper.steps_apart(entries)),+
                }
            }

            fn is_mechanical(&self) -> bool {
                match self {
                    $(Self::$name(stepper) => stepper.is_mechanical()),+
                }
            }

            fn aims(&self, nature: &Nature) -> bool {
                match self {
                    $(Self::$name(stepper) => stepper.aims(nature)),+
                }
            }

            fn is_smooth_inside(&self) -> bool {
                match self {
                    $(Self::$name(stepper) => stepper.is_smooth_inside()),+
                }
            }
        }

        impl Any {
            fn step_erased<S: State>(
                &self,
                field: &mut Erased<'_, S>,
                x0: &S,
                memory: &mut AnyMemory<S>,
                h: f64,
            ) -> Step<S, AnyDense<S>> {
                match self {
                    $(Self::$name(stepper) => {
                        if !matches!(memory, AnyMemory::$name(_)) {
                            *memory = AnyMemory::$name(Default::default());
                        }
                        let AnyMemory::$name(memory) = memory else { unreachable!("just put there") };
                        stepper.step(field, x0, memory, h).map(Fits::wide)
                    })+
                }
            }

            fn refine_erased<S: State>(
                &self,
                field: &mut Erased<'_, S>,
                memory: &AnyMemory<S>,
                dense: &mut AnyDense<S>,
                h: f64,
            ) {
                match (self, memory) {
                    $((Self::$name(stepper), AnyMemory::$name(memory)) => {
                        if let Some(dense) = Fits::narrow(dense) {
                            stepper.refine(field, memory, dense, h);
                        }
                    })+
                    _ => {}
                }
            }
        }
    };
}

any! {
    named {
        ByNeed(ByNeed),
        ExplicitEuler(ExplicitEuler),
        SemiImplicitEuler(SemiImplicitEuler),
        Heun(Heun),
        VelocityVerlet(VelocityVerlet),
        AdamsBashforth2(AdamsBashforth2),
        AdamsBashforth3(AdamsBashforth3),
        BogackiShampine(BogackiShampine),
        Rk4(Rk4),
        Tsitouras5(Tsitouras5),
        Dop853(Dop853),
        LinearImplicitMidpoint(LinearImplicitMidpoint),
        Rodas3(Rodas3),
        Exact(Exact),
        Newmark(Newmark),
    }
    controlled {
        ControlledBogackiShampine(Controlled<BogackiShampine>),
        ControlledTsitouras5(Controlled<Tsitouras5>),
        ControlledDop853(Controlled<Dop853>),
    }
}

impl Any {
    /// Names of the methods that accept a tolerance.
    pub const TOLERANT: &[&str] =
        &[ByNeed::NAME, BogackiShampine::NAME, Tsitouras5::NAME, Dop853::NAME];

    /// Returns the name of the method that steps in a mode of this `nature`, after delegation.
    pub fn name_in(&self, nature: &Nature) -> &'static str {
        if let Self::ByNeed(method) = self {
            method.choice(nature, f64::INFINITY).method.name()
        } else if matches!(self, Self::Exact(_)) && !nature.is_linear() {
            Rk4::NAME
        } else {
            self.name()
        }
    }

    /// Returns the method with `tolerance`, in ticks of `tick` (s); `None` without error control.
    #[must_use]
    pub fn with_tolerance(self, tolerance: f64, tick: f64) -> Option<Self> {
        let both = Tolerance::both(tolerance);
        #[expect(clippy::wildcard_enum_match_arm, reason = "all others have no estimate")]
        Some(match self {
            Self::ByNeed(_) => Self::ByNeed(ByNeed::new(tolerance, tick)),
            Self::BogackiShampine(method) => {
                Self::ControlledBogackiShampine(Controlled { method, tolerance: both })
            }
            Self::Tsitouras5(method) => {
                Self::ControlledTsitouras5(Controlled { method, tolerance: both })
            }
            Self::Dop853(method) => Self::ControlledDop853(Controlled { method, tolerance: both }),
            _ => return None,
        })
    }
}

impl Default for Any {
    fn default() -> Self {
        Self::Rk4(Rk4)
    }
}
