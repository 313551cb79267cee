use pode::stepper::Any;
use pode::{Limits, Signal, Silent, Simulator, Tick, Watch};

use super::stepped::{Stepped, Stepping};
use crate::scenario::{InputOf, Scenario};

/// Scenario, method and tick of a run, which can be repeated any number of times.
#[derive(Debug)]
pub(super) struct RunJob<'a, S> {
    pub(super) scenario: &'a S,
    pub(super) stepper: Any,
    pub(super) limits: Limits,
    pub(super) stepping: Stepping,
    /// Length of a tick (s).
    pub(super) tick: f64,
}

impl<S: Scenario> RunJob<'_, S> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count far below 2^53"
    )]
    pub(super) fn ticks(&self) -> u64 {
        (self.scenario.plan().until / self.tick).round() as u64
    }

    pub(super) fn simulator(&self) -> Simulator<Stepped<S::Model>, Any> {
        let (model, mode, state) = self.scenario.start();
        let model = Stepped { model, stepping: self.stepping };
        Simulator::new(model, self.stepper, self.limits, mode, state)
    }

    #[inline]
    pub(super) fn advance<W: Watch<Stepped<S::Model>>>(
        &self,
        simulator: &mut Simulator<Stepped<S::Model>, Any>,
        watch: &mut W,
    ) -> Tick {
        let (start, h) = (simulator.tick() as f64, self.tick);
        let signal = ScenarioSignal { scenario: self.scenario, start, h };
        simulator.advance(h, &signal, watch)
    }

    /// Advances by one tick without a watch; this function is timed.
    #[inline(never)]
    pub(super) fn advance_alone(&self, simulator: &mut Simulator<Stepped<S::Model>, Any>) -> Tick {
        self.advance(simulator, &mut Silent)
    }
}

struct ScenarioSignal<'a, S> {
    scenario: &'a S,
    start: f64,
    h: f64,
}

impl<S: Scenario> Signal<InputOf<S>> for ScenarioSignal<'_, S> {
    #[inline]
    fn at(&self, theta: f64) -> InputOf<S> {
        self.scenario.input((self.start + theta) * self.h)
    }
}
