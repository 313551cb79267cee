use crate::dense::{Cubic, Dense as _};
use crate::mechanical::{MAX_SPEEDS, MechanicalOutcome, MechanicalStep};
use crate::nature::Nature;
use crate::state::State;
use crate::stepper::{Field, Memory, PowerRule, Rk4, Step, Stepper};

/// Order 2, linearly implicit, for modes in mechanical form M u' = Q: one evaluation, one LDLᵀ.
///
/// The acceleration a of the last step predicts; Δ corrects it with the slopes K = −∂Q/∂q and
/// D = −∂Q/∂u of the compliant elements:
///
/// ```text
/// q = q0 + h u0 + h²/2 a,   u = u0 + h a
/// (M + h/2 D + β h² K) Δ = Q(q, u) − M a
/// a + Δ,   u + h/2 Δ,   q + β h² Δ
/// ```
///
/// With β = 1/12 an oscillator's frequency is exact to (hω)⁴/480, and steps are stable for
/// hω < √6: where M − h²/6 K is positive definite, by the pivots of its LDLᵀ. Elsewhere β = 1/4,
/// which is stable at any rate. Internal states, such as a wound-up friction, follow their linear
/// rates in closed form, with the speeds in the middle of the step.
///
/// Steps take 0.5 ms, and 0.25 ms where the correction moves an element's force by more than the
/// tolerance. A step with eight times as much is repeated once. A contact that is struck is followed
/// apart, in small parts of the step, and ends a step where it opens. While another one is closed
/// that does not rest, steps are at most 62.5 µs and half a radian of the fastest rate.
///
/// Dense output: h u0, h²/2 a and β h² Δ are the terms of τ, τ² and τ³. A cubic through the rates at
/// both ends would first move against Δ, since β is not 1/6. The acceleration is void after a reset,
/// and where the input jumps between two ticks, and then costs one evaluation of the derivative. An
/// old one would delay the input by half a step. Modes without a mechanical form, and slow ones, are
/// stepped by [`Rk4`]. `[New59]`, `[Hug87]` 9.1; `[FG49]` for β = 1/12.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Newmark {
    /// Force (N) by which the correction may move an element.
    pub tolerance: f64,
}

impl Default for Newmark {
    /// 0.02 N, below what a finger feels.
    fn default() -> Self {
        Self { tolerance: 0.02 }
    }
}

/// Longest and shortest step (s) without closed contacts.
const LONG: f64 = 5e-4;
const SHORT: f64 = 2.5e-4;

/// Step of a closed contact in terms of its rate (rad), and its limits (s). The longest one is also
/// the first step after an event, when the rate to come is unknown.
const CONTACT_RADIANS: f64 = 0.5;
const CONTACT_STEPS: (f64, f64) = (2e-5, 6.25e-5);

/// Fraction of the tolerance below which steps grow, and below which long ones may be stretched.
const RELAXED: f64 = 1.0 / 16.0;
const CALM: f64 = 0.25;

/// Relative difference of lengths that are the same.
const ROUNDING: f64 = 1e-9;

/// A last step that there was not.
const UNKNOWN: (f64, f64) = (0.0, f64::INFINITY);

/// Memory of [`Newmark`]: the last acceleration, and the next step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NewmarkMemory {
    acceleration: Option<[f64; MAX_SPEEDS]>,
    /// Length of the next step (s).
    next: f64,
    /// Time until a contact opens that is followed apart (s): the next step ends there.
    opens: Option<f64>,
    /// Time since the begin of the tick (s), without closed contacts.
    elapsed: f64,
    /// Length (s) and error of the last step without closed contacts, as a part of the tolerance.
    last: (f64, f64),
    is_repeated: bool,
    is_mechanical: bool,
}

impl Default for NewmarkMemory {
    fn default() -> Self {
        Self {
            acceleration: None,
            next: LONG,
            opens: None,
            elapsed: 0.0,
            last: UNKNOWN,
            is_repeated: false,
            is_mechanical: false,
        }
    }
}

impl Memory for NewmarkMemory {
    #[inline]
    fn restart(&mut self) {
        self.acceleration = None;
        (self.next, self.opens) = (CONTACT_STEPS.1, None);
        (self.last, self.is_repeated) = (UNKNOWN, false);
    }

    #[inline]
    fn begin_tick(&mut self) {
        self.elapsed = 0.0;
        if self.is_relaxed() {
            self.next = LONG.min(2.0 * self.next);
        }
    }

    #[inline]
    fn jump(&mut self) {
        self.acceleration = None;
    }

    #[inline]
    fn reach(&self, stretch: f64) -> f64 {
        if !self.is_mechanical {
            return f64::INFINITY;
        }
        let usual = if self.is_calm() { stretch * self.next } else { self.next };
        self.opens.unwrap_or(usual)
    }

    #[inline]
    fn sets_steps(&self) -> bool {
        self.is_mechanical
    }
}

impl NewmarkMemory {
    fn is_relaxed(&self) -> bool {
        self.last.1 < RELAXED
    }

    /// Returns `true` if the next step may be stretched under overload.
    fn is_calm(&self) -> bool {
        let (h, error) = self.last;
        error < CALM && h > LONG * (1.0 - ROUNDING)
    }

    /// Chooses the next step after one of `h` (s) with closed contacts, by their relative error and the
    /// fastest rate (rad/s).
    fn touch(&mut self, h: f64, error: f64, rate: f64) {
        let (least, most) = CONTACT_STEPS;
        let is_at_rest = error < RELAXED;
        self.next = if is_at_rest { LONG.min(2.0 * h) } else { CONTACT_RADIANS / rate };
        self.next = self.next.clamp(least, if is_at_rest { LONG } else { most });
        (self.last, self.is_repeated) = (UNKNOWN, false);
    }

    /// Chooses the next step after one of `h` (s) with this relative `error`; returns `false` if
    /// that step must be repeated.
    fn judge(&mut self, h: f64, error: f64) -> bool {
        const REPEATED: f64 = 8.0;
        let is_repeated = error > REPEATED && h > SHORT * (1.0 + ROUNDING) && !self.is_repeated;
        self.is_repeated = is_repeated;
        if is_repeated {
            self.next = 0.5 * h;
            return false;
        }
        self.elapsed += h;
        // The error grows with the third power of the step; even steps cancel each other's.
        let pairs = 0.5 * self.elapsed / h;
        self.last = (h, error);
        let may_grow =
            self.is_relaxed() && (pairs - crate::math::floor(pairs + 0.25)).abs() < ROUNDING;
        let by = if error > 1.0 {
            0.5
        } else if may_grow {
            2.0
        } else {
            1.0
        };
        self.next = (by * h).clamp(SHORT, LONG);
        true
    }
}

impl Stepper for Newmark {
    const ORDER: u32 = 2;
    const DENSE: u32 = 3;
    const EVALUATIONS: u32 = Rk4::EVALUATIONS;
    const NAME: &'static str = "newmark";

    type Memory<S: State> = NewmarkMemory;
    type Dense<S: State> = Cubic<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut NewmarkMemory,
        h: f64,
    ) -> Step<S, Cubic<S>> {
        let start = memory.acceleration.or_else(|| field.mechanical_acceleration(x0));
        let step = start.map(|acceleration| MechanicalStep { h, acceleration });
        let Some((step, end)) = step.and_then(|it| Some((it, field.mechanical_step(x0, &it)?)))
        else {
            *memory = NewmarkMemory::default();
            return Rk4.step(field, x0, &mut (), h);
        };
        memory.is_mechanical = true;
        memory.opens = None;
        memory.acceleration = Some(step.acceleration);
        let refused = Step { is_accepted: false, ..Step::new(Cubic::still(x0)) };
        let end = match end {
            MechanicalOutcome::End(end) => end,
            MechanicalOutcome::Opens { after } => {
                memory.opens = Some(after);
                return refused;
            }
        };
        if let Some(contact) = end.contact {
            memory.touch(h, contact.error / self.tolerance, contact.rate);
        } else if !memory.judge(h, end.error / self.tolerance) {
            return refused;
        }
        memory.acceleration = Some(end.acceleration);
        Step { powers: PowerRule::Trapezoid { absorbed: end.absorbed }, ..Step::new(end.dense) }
    }

    /// As RK4 does, which takes the steps whose length it does not set.
    #[inline]
    fn aims(&self, nature: &Nature) -> bool {
        Rk4.aims(nature)
    }

    #[inline]
    fn is_mechanical(&self) -> bool {
        true
    }
}
