//! The cheapest method that meets an error budget, mode by mode.

use crate::math::{ceil, powf};
use crate::nature::{EquationKind, Nature};
use crate::state::State;
use crate::stepper::exact::{Exact, FlowOrCubic, RoundingCarry};
use crate::stepper::{Field, Heun, Rk4, Rodas3, Step, Stepper, VelocityVerlet};

/// Chooses for each mode, by what the model says of it, the method and the step that meet an
/// error budget at the least cost.
///
/// Linear modes get their exact flow, stiff ones RODAS3 at the model's own step, the others
/// the cheapest of the [`MENU`] by evaluations per tick. Order, evaluations and dense output
/// are those of the method; what is carried is the exact flow's, and void after a reset.
/// [`ByNeed::choice`] says what is taken and why.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ByNeed {
    /// Length of the tick (s).
    tick: f64,
    /// Longest step that meets the budget (rad), for each line of the menu.
    reaches: [f64; MENU.len()],
}

/// A method that `ByNeed` may take.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NeededMethod {
    Exact,
    Heun,
    VelocityVerlet,
    Rk4,
    Rodas3,
}

impl NeededMethod {
    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => Exact::NAME,
            Self::Heun => Heun::NAME,
            Self::VelocityVerlet => VelocityVerlet::NAME,
            Self::Rk4 => Rk4::NAME,
            Self::Rodas3 => Rodas3::NAME,
        }
    }
}

/// What is taken in a mode.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Choice {
    pub method: NeededMethod,
    /// Longest step (s); infinite where the method sets no limit.
    pub step: f64,
    /// Relative error to be expected per radian of the mode's fastest motion; NaN where the
    /// model does not say how fast that is.
    pub error: f64,
}

/// A method with its error: the relative error per radian of an oscillator in steps of r
/// radians is `constant` r^`order`.
#[derive(Clone, Copy, Debug)]
pub struct Offer {
    pub method: NeededMethod,
    /// What its error is proportional to.
    pub constant: f64,
    pub order: f64,
    /// Evaluations of the derivative per step.
    pub evaluations: f64,
    /// Whether it keeps its order with forces that depend on the speed.
    pub is_for_damped: bool,
}

/// What there is to choose from in smooth modes; the constants are those of the phase.
/// `[HNW93]` II.1, `[HLW06]` I.1.
pub const MENU: [Offer; 3] = [
    Offer {
        method: NeededMethod::Heun,
        constant: 1.0 / 6.0,
        order: 2.0,
        evaluations: 2.0,
        is_for_damped: true,
    },
    Offer {
        method: NeededMethod::VelocityVerlet,
        constant: 1.0 / 24.0,
        order: 2.0,
        evaluations: 2.0,
        is_for_damped: false,
    },
    Offer {
        method: NeededMethod::Rk4,
        constant: 1.0 / 120.0,
        order: 4.0,
        evaluations: 4.0,
        is_for_damped: true,
    },
];

impl Default for ByNeed {
    /// [`ByNeed::BUDGET`] in ticks of 1 ms.
    fn default() -> Self {
        Self::new(Self::BUDGET, 1e-3)
    }
}

impl ByNeed {
    /// A relative error per radian that no finger feels.
    pub const BUDGET: f64 = 1e-4;

    /// Meets `budget`, a relative error per radian, in ticks of `tick` (s).
    pub fn new(budget: f64, tick: f64) -> Self {
        /// Guards are seen, and all of the menu is stable, up to this (rad).
        const MOST: f64 = 1.0;
        let reach = |it: Offer| powf(budget / it.constant, 1.0 / it.order).min(MOST);
        Self { tick, reaches: MENU.map(reach) }
    }

    /// What is taken in a mode of this `nature`, where the model asks for steps of `own` (s).
    pub fn choice(&self, nature: &Nature, own: f64) -> Choice {
        match nature.kind {
            EquationKind::Affine | EquationKind::Linear => {
                let step = Exact.longest_step(nature, own);
                Choice { method: NeededMethod::Exact, step, error: 0.0 }
            }
            EquationKind::Stiff => {
                Choice { method: NeededMethod::Rodas3, step: own, error: f64::NAN }
            }
            EquationKind::Smooth | EquationKind::Conservative if nature.rate > 0.0 => {
                self.cheapest(nature, own)
            }
            EquationKind::Smooth | EquationKind::Conservative => {
                Choice { method: NeededMethod::Rk4, step: own, error: f64::NAN }
            }
        }
    }

    /// The line of the menu that meets the budget with the fewest evaluations per tick; of two
    /// that cost the same, the one with the smaller error.
    ///
    /// Neither the model's own step nor the one that is taken has a say in which line it is: who
    /// takes shorter steps to check a result gets the same method, with a smaller error.
    #[inline]
    fn cheapest(&self, nature: &Nature, own: f64) -> Choice {
        let radians = nature.rate * self.tick;
        let may_be = |it: &Offer| it.is_for_damped || nature.kind == EquationKind::Conservative;
        let mut best = (f64::INFINITY, f64::INFINITY, &MENU[MENU.len() - 1], 0.0);
        for (offer, reach) in MENU.iter().zip(self.reaches).filter(|(it, _)| may_be(it)) {
            let steps = ceil(radians / reach).max(1.0);
            let error = offer.error(radians / steps);
            let cost = steps * offer.evaluations;
            if cost < best.0 || (cost <= best.0 && error < best.1) {
                best = (cost, error, offer, reach / nature.rate);
            }
        }
        let (_, _, offer, step) = best;
        let step = step.min(own);
        let steps = ceil(self.tick / step).max(1.0);
        Choice { method: offer.method, step, error: offer.error(radians / steps) }
    }
}

impl Offer {
    /// The relative error per radian in steps of `radians`.
    fn error(&self, radians: f64) -> f64 {
        self.constant * powi(radians, self.order)
    }
}

/// `x` to the power of an even order.
fn powi(x: f64, order: f64) -> f64 {
    let square = x * x;
    if order > 3.0 { square * square } else { square }
}

impl Stepper for ByNeed {
    const ORDER: u32 = 2;
    const DENSE: u32 = 2;
    const EVALUATIONS: u32 = Rodas3::EVALUATIONS;
    const JACOBIANS: u32 = Rodas3::JACOBIANS;
    const NAME: &'static str = "by-need";

    type Memory<S: State> = RoundingCarry<S>;
    type Dense<S: State> = FlowOrCubic<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut Self::Memory<S>,
        h: f64,
    ) -> Step<S, Self::Dense<S>> {
        let none = &mut ();
        match self.choice(&field.nature(), h).method {
            NeededMethod::Exact => Exact.step(field, x0, memory, h),
            NeededMethod::Heun => Heun.step(field, x0, none, h).map(FlowOrCubic::Cubic),
            NeededMethod::VelocityVerlet => {
                VelocityVerlet.step(field, x0, none, h).map(FlowOrCubic::Cubic)
            }
            NeededMethod::Rk4 => Rk4.step(field, x0, none, h).map(FlowOrCubic::Cubic),
            NeededMethod::Rodas3 => Rodas3.step(field, x0, none, h).map(FlowOrCubic::Cubic),
        }
    }

    /// Each part gets the method that its nature asks for.
    #[inline]
    fn steps_apart(&self, _entries: usize) -> bool {
        true
    }

    #[inline]
    fn aims(&self, nature: &Nature) -> bool {
        self.choice(nature, f64::INFINITY).method == NeededMethod::Rk4
    }

    #[inline]
    fn longest_step(&self, nature: &Nature, own: f64) -> f64 {
        self.choice(nature, own).step
    }
}
