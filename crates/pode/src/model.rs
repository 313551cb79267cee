//! What a modeller implements: equations, guards, reset maps.

use core::fmt::Debug;

use crate::enclosure::{Enclosure, GuardBound};
use crate::guard::{GuardId, GuardSpec, GuardValue};
use crate::mechanical::Mechanical;
use crate::nature::Nature;
use crate::part::Part;
use crate::state::State;
use crate::stepper::{differences, unit_differences};

/// Equations of motion and readout, one set per mode; what changes is in the state and the mode.
pub trait Model {
    type Mode: Copy + Eq + Debug + Send;
    type State: State;
    type Input: Copy + PartialEq + Debug + Send;

    const COORDS: usize;

    /// Returns the number of leading coordinates, which may depend on values of the model.
    #[inline]
    fn coordinates(&self) -> usize {
        Self::COORDS
    }

    /// Returns the derivative of `x` in `mode`. `[GC93]` eq. 6.
    fn derivative(&self, mode: Self::Mode, x: &Self::State, input: &Self::Input) -> Self::State;

    /// Parts of the state that move by equations in `mode` and do not touch each other, at most
    /// [`MAX_PARTS`](crate::MAX_PARTS). What is in no part is slaved: [`Guarded::constrain`] puts
    /// it in place, and no method integrates it. A mode without parts takes no derivative.
    #[inline]
    fn parts(&self, _mode: Self::Mode) -> &[Part] {
        &[Part::WHOLE]
    }

    /// Returns the derivative of the part `index` in `mode`; other entries may be anything.
    #[inline]
    fn derivative_of(
        &self,
        mode: Self::Mode,
        _index: usize,
        x: &Self::State,
        input: &Self::Input,
    ) -> Self::State {
        self.derivative(mode, x, input)
    }

    /// Returns the generalised force on what drives the input, if anything does. `[GC93]` eq. 7.
    fn readout(&self, _mode: Self::Mode, _x: &Self::State, _input: &Self::Input) -> f64 {
        0.0
    }

    /// Returns the Jacobian by the state for implicit methods; by differences unless overridden.
    fn jacobian(
        &self,
        mode: Self::Mode,
        x: &Self::State,
        input: &Self::Input,
    ) -> <Self::State as State>::Matrix {
        if self.nature(mode).is_linear() {
            return unit_differences(|x| self.derivative(mode, x, input));
        }
        differences(x, |x| self.derivative(mode, x, input))
    }

    /// Returns what is constant in `mode`, so that a method and a step can be chosen by need.
    fn nature(&self, _mode: Self::Mode) -> Nature {
        Nature::default()
    }
}

/// Conditions of a mode: constraints on the state, and guards that end it, in reach of a step.
///
/// A model that is always valid has none: `impl Guarded for X {}`.
pub trait Guarded: Model {
    /// Returns `x` with the coordinates that `mode` slaves to the input put in place.
    fn constrain(&self, _mode: Self::Mode, x: &Self::State, _input: &Self::Input) -> Self::State {
        *x
    }

    /// Longest step (s) from `x` on, where that depends on the state: a felt that is pressed hard
    /// is stiffer than the mode's usual motion shows. At most [`Nature::longest_step`].
    #[inline]
    fn longest_step_at(&self, mode: Self::Mode, _x: &Self::State, _input: &Self::Input) -> f64 {
        self.nature(mode).longest_step
    }

    /// The guards of `mode`, at most [`MAX_GUARDS`](crate::MAX_GUARDS), in any order.
    fn guards(&self, _mode: Self::Mode) -> &[GuardSpec] {
        &[]
    }

    /// Whether a guard of the list is watched in `mode`; one that is not is never evaluated there.
    fn is_watched(&self, _mode: Self::Mode, _guard: GuardId) -> bool {
        true
    }

    /// Returns the modes in mechanical form, for methods that use the mass matrix.
    #[inline]
    fn mechanical(&self) -> Option<&dyn Mechanical<Self::Mode, Self::State, Self::Input>> {
        None
    }

    /// Bounds what the guard does along a computed orbit, with the enclosure of one step. With a
    /// bound a far guard is left alone until the orbit can have reached it, and a step is certain
    /// where no guard can have come to zero. The bound is about the guard as a function of state
    /// and input; one that is too low hides crossings.
    fn guard_bound(
        &self,
        _mode: Self::Mode,
        _guard: GuardId,
        _over: &Enclosure<Self::State, Self::Input>,
    ) -> GuardBound {
        GuardBound::UNKNOWN
    }

    /// Returns the guard and its rate along the motion in `mode`. `[GC93]` eq. 8. A guard that is
    /// listed and not defined here is no number, which is a fault.
    fn guard(
        &self,
        _mode: Self::Mode,
        _guard: GuardId,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> GuardValue {
        GuardValue::new(f64::NAN, f64::NAN)
    }
}

/// Where the state lands, and in which mode, when a guard fires.
///
/// A model whose guards only tell when they are crossed needs no more than `impl Resets for X {}`.
pub trait Resets: Guarded + Sized {
    /// Applies the reset map x⁺ = H(x⁻, u), by default the identity. `[GC93]` eq. 12.
    fn reset(
        &self,
        mode: Self::Mode,
        _guard: GuardId,
        x: &Self::State,
        _input: &Self::Input,
    ) -> Reset<Self> {
        Reset::to(mode, *x)
    }
}

/// What a reset map gives.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Reset<M: Model> {
    pub mode: M::Mode,
    pub state: M::State,
    /// Impulse on what drives the input (readout × s).
    pub impulse: f64,
    /// Where the impacts that follow accumulate, if the model knows that they do.
    pub settles: Option<Settling<M>>,
    /// The contact mode in which such impacts come to rest, and the state in it right now, if
    /// the model leaves it to the intervals to tell whether they accumulate.
    pub rests: Option<(M::Mode, M::State)>,
    /// Guard of a contact that opened since its force vanished: rounding alone cannot close it
    /// again at this instant.
    pub released: Option<GuardId>,
}

impl<M: Model> Reset<M> {
    /// A transition without an impulse.
    pub const fn to(mode: M::Mode, state: M::State) -> Self {
        Self { mode, state, impulse: 0.0, settles: None, rests: None, released: None }
    }

    /// The same with an impulse on the input (readout × s).
    #[must_use]
    pub const fn with_impulse(self, impulse: f64) -> Self {
        Self { impulse, ..self }
    }

    /// The same where impacts may come to rest in `mode`, whose state right now is `state`:
    /// whether and when is measured by the intervals between them.
    #[must_use]
    pub const fn resting(self, mode: M::Mode, state: M::State) -> Self {
        Self { rests: Some((mode, state)), ..self }
    }

    /// The same where a contact with this guard opened since its force vanished.
    #[must_use]
    pub fn releasing(self, released: Option<GuardId>) -> Self {
        Self { released, ..self }
    }

    /// The same with a declared accumulation point.
    #[must_use]
    pub fn settling(self, settling: Settling<M>) -> Self {
        Self { settles: Some(settling), ..self }
    }
}

/// A Zeno sequence in closed form: impacts that accumulate at a known time.
///
/// After an impact with post speed g'⁺ under the closing acceleration a, restitution e
/// lets them accumulate after `T_Z = 2 g'⁺ / (a (1 − e))`, with the impulse
/// `m g'⁺ (1 + e) / (1 − e)`. After n of them `T_Z (1 − eⁿ)` has passed, and the state
/// has come the same part of the way to the settled one.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Settling<M: Model> {
    /// Time from the impact to the accumulation point (s).
    pub after: f64,
    /// Ratio of each interval to the one before: the restitution e, in 0 .. 1.
    pub ratio: f64,
    pub mode: M::Mode,
    pub state: M::State,
    /// Impulse of all the impacts until then (readout × s).
    pub impulse: f64,
}
