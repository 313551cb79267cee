//! A model whose steps are those of the study.
//!
//! A model's own longest step cuts ticks: a study of 5 ms would really be one of 1 ms. All other
//! methods of the traits are forwarded, also those with a default.

use pode::{
    Enclosure, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Mechanical, Model, Nature,
};
use pode::{Energetic, Part, Reset, Resets, Settling, State};

/// Rule that cuts a tick into steps.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Stepping {
    Ticks,
    Models,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Stepped<M> {
    pub(super) model: M,
    pub(super) stepping: Stepping,
}

impl<M: Model> Model for Stepped<M> {
    type Mode = M::Mode;
    type State = M::State;
    type Input = M::Input;
    const COORDS: usize = M::COORDS;

    #[inline]
    fn coordinates(&self) -> usize {
        self.model.coordinates()
    }

    #[inline]
    fn parts(&self, mode: M::Mode) -> &[Part] {
        self.model.parts(mode)
    }

    #[inline]
    fn derivative_of(
        &self,
        mode: M::Mode,
        index: usize,
        x: &M::State,
        input: &M::Input,
    ) -> M::State {
        self.model.derivative_of(mode, index, x, input)
    }

    #[inline]
    fn derivative(&self, mode: M::Mode, x: &M::State, input: &M::Input) -> M::State {
        self.model.derivative(mode, x, input)
    }

    #[inline]
    fn readout(&self, mode: M::Mode, x: &M::State, input: &M::Input) -> f64 {
        self.model.readout(mode, x, input)
    }

    #[inline]
    fn jacobian(
        &self,
        mode: M::Mode,
        x: &M::State,
        input: &M::Input,
    ) -> <M::State as State>::Matrix {
        self.model.jacobian(mode, x, input)
    }

    #[inline]
    fn nature(&self, mode: M::Mode) -> Nature {
        let nature = self.model.nature(mode);
        match self.stepping {
            Stepping::Ticks => nature.with_longest_step(f64::INFINITY),
            Stepping::Models => nature,
        }
    }
}

impl<M: Guarded> Guarded for Stepped<M> {
    #[inline]
    fn constrain(&self, mode: M::Mode, x: &M::State, input: &M::Input) -> M::State {
        self.model.constrain(mode, x, input)
    }

    #[inline]
    fn longest_step_at(&self, mode: M::Mode, x: &M::State, input: &M::Input) -> f64 {
        match self.stepping {
            Stepping::Ticks => f64::INFINITY,
            Stepping::Models => self.model.longest_step_at(mode, x, input),
        }
    }

    #[inline]
    fn mechanical(&self) -> Option<&dyn Mechanical<M::Mode, M::State, M::Input>> {
        self.model.mechanical()
    }

    #[inline]
    fn guards(&self, mode: M::Mode) -> &[GuardSpec] {
        self.model.guards(mode)
    }

    #[inline]
    fn is_watched(&self, mode: M::Mode, guard: GuardId) -> bool {
        self.model.is_watched(mode, guard)
    }

    #[inline]
    fn guard_bound(
        &self,
        mode: M::Mode,
        guard: GuardId,
        over: &Enclosure<M::State, M::Input>,
    ) -> GuardBound {
        self.model.guard_bound(mode, guard, over)
    }

    #[inline]
    fn guard(&self, mode: M::Mode, guard: GuardId, x: &M::State, input: &M::Input) -> GuardValue {
        self.model.guard(mode, guard, x, input)
    }
}

impl<M: Resets> Resets for Stepped<M> {
    #[inline]
    fn reset(&self, mode: M::Mode, guard: GuardId, x: &M::State, input: &M::Input) -> Reset<Self> {
        let Reset { mode, state, impulse, settles, rests, released } =
            self.model.reset(mode, guard, x, input);
        let settles = settles.as_ref().map(settling);
        Reset { mode, state, impulse, settles, rests, released }
    }
}

fn settling<M: Model>(it: &Settling<M>) -> Settling<Stepped<M>> {
    let Settling { after, ratio, mode, state, impulse } = *it;
    Settling { after, ratio, mode, state, impulse }
}

impl<M: Energetic> Energetic for Stepped<M> {
    fn energy(&self, mode: M::Mode, x: &M::State, input: &M::Input) -> f64 {
        self.model.energy(mode, x, input)
    }

    fn supplied(&self, mode: M::Mode, x: &M::State, input: &M::Input) -> f64 {
        self.model.supplied(mode, x, input)
    }

    fn dissipated(&self, mode: M::Mode, x: &M::State, input: &M::Input) -> f64 {
        self.model.dissipated(mode, x, input)
    }
}
