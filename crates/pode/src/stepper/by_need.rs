use crate::math::{ceil, powf};
use crate::nature::{EquationKind, Nature};
use crate::state::State;
use crate::stepper::exact::{Exact, FlowOrCubic, RoundingCarry};
use crate::stepper::{Field, Heun, Rk4, Rodas3, Step, Stepper, VelocityVerlet};

/// Chooses the cheapest method and step for each mode, by its nature, within an error budget.
///
/// Linear modes get their exact flow, stiff ones RODAS3 at the model's own step, the others the
/// cheapest of the [`MENU`] by evaluations per tick. The exact flow's memory is carried, and void
/// after a reset. [`ByNeed::choice`] returns the choice.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ByNeed {
    /// Length of the tick (s).
    tick: f64,
    /// Longest step that meets the budget (rad), for each line of the menu.
    reaches: [f64; MENU.len()],
}

/// A method available to [`ByNeed`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NeededMethod {
    Exact,
    Heun,
    VelocityVerlet,
    Rk4,
    Rodas3,
}

impl NeededMethod {
    /// Returns its name on the command line.
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

/// Method and step of a mode.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Choice {
    pub method: NeededMethod,
    /// Longest step (s); infinite if the method sets no limit.
    pub step: f64,
    /// Expected relative error per radian of the mode's fastest motion; NaN for an unknown rate.
    pub error: f64,
}

/// A method with its error: the relative error per radian of an oscillator in steps of r
/// radians is `constant` r^`order`.
#[derive(Clone, Copy, Debug)]
pub struct Offer {
    pub method: NeededMethod,
    pub constant: f64,
    pub order: f64,
    pub evaluations: f64,
    /// `true` if it keeps its order with forces that depend on the speed.
    pub is_for_damped: bool,
}

/// Methods for smooth modes; the constants are those of the phase. `[HNW93]` II.1, `[HLW06]` I.1.
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
    /// Relative error per radian below what a finger feels.
    pub const BUDGET: f64 = 1e-4;

    /// Builds a method that meets `budget`, a relative error per radian, in ticks of `tick` (s).
    pub fn new(budget: f64, tick: f64) -> Self {
        /// Limit of the menu's stability and of guard detection (rad).
        const MOST: f64 = 1.0;
        let reach = |it: Offer| powf(budget / it.constant, 1.0 / it.order).min(MOST);
        Self { tick, reaches: MENU.map(reach) }
    }

    /// Returns the choice for a mode of this `nature`; the model asks for steps of `own` (s).
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

    /// Returns the line of the menu that meets the budget with the fewest evaluations per tick; of
    /// equals, the one with the smaller error. Shorter steps keep the method.
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
    fn error(&self, radians: f64) -> f64 {
        self.constant * powi(radians, self.order)
    }
}

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
