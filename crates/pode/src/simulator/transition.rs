//! What happens at one instant: guards fire until none must leave.

use super::Simulator;
use crate::epoch::{Stand, stand};
use crate::forecast::GuardSlot;
use crate::guard::MAX_GUARDS;
use crate::input::Signal;
use crate::model::{Reset, Resets};
use crate::outcome::{Cap, Fault};
use crate::run::TickRun;
use crate::stepper::{Memory as _, Stepper};
use crate::watch::{Event, EventCause, Watch};

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// Fires guards until none must leave at this instant; at most `limits.cascade`.
    pub(super) fn settle<S, W>(&mut self, run: &mut TickRun<'_, S, W>)
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        for _ in 0..=run.limits.cascade {
            let specs = self.model.guards(self.mode);
            let leaving = (0..specs.len().min(MAX_GUARDS))
                .filter(|index| self.guards[*index].stand == Stand::Leaving)
                .min_by_key(|index| (specs[*index].priority, specs[*index].id.0));
            let Some(index) = leaving else { return };
            if !self.fire(run, index) {
                return;
            }
        }
    }

    /// Applies one reset map and takes the guards anew; `false` if the tick ends here.
    pub(super) fn fire<S, W>(&mut self, run: &mut TickRun<'_, S, W>, index: usize) -> bool
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        if run.cascade >= run.limits.cascade {
            run.cap(Cap::Cascade);
            return false;
        }
        if run.work.events >= run.limits.events {
            run.cap(Cap::Events);
            return false;
        }
        let Some(spec) = self.model.guards(self.mode).get(index).copied() else {
            run.fail(Fault::Guard);
            return false;
        };
        run.cascade += 1;
        run.has_aimed = false;
        let fired = spec.id;
        run.due.remove(fired);
        // What it stood like before is over.
        self.guards[index].stand = Stand::Leaving;
        let input = run.input();
        let reset = self.model.reset(self.mode, spec.id, &self.state, &input);
        let from = self.mode;
        if !self.land(run, EventCause::Guard(&spec), &reset, &input) {
            return false;
        }
        if !self.take_guards(run, Some(from)) {
            return false;
        }
        match self.accumulates(run, &reset, fired) {
            None => {
                if from == self.mode {
                    self.disarm_if_spent(index);
                }
                true
            }
            Some(goes_on) => goes_on && self.take_guards(run, None),
        }
    }

    /// Takes over what a reset map gave, and tells the watch; `false` if it is not finite.
    pub(super) fn land<S, W>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        cause: EventCause<'_>,
        reset: &Reset<M>,
        input: &M::Input,
    ) -> bool
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        if !reset.impulse.is_finite() {
            run.fail(Fault::Readout);
            return false;
        }
        let Some(state) = self.constrained(reset.mode, &reset.state, input) else {
            run.fail(Fault::State);
            return false;
        };
        let event = Event {
            tick: self.tick,
            theta: run.theta,
            cause,
            before: (self.mode, self.state),
            after: (reset.mode, state),
            input: *input,
            impulse: reset.impulse,
        };
        run.watch.event(&self.model, &event);
        run.work.events += 1;
        run.impulse += reset.impulse;
        run.readout = None;
        (self.mode, self.state) = (reset.mode, state);
        self.memory.restart();
        true
    }

    /// Notes that every guard that was positive crosses if the input's jump makes it negative.
    pub(super) fn expect_jumps<S, W>(&self, run: &mut TickRun<'_, S, W>) {
        for (slot, spec) in self.guards.iter().zip(self.model.guards(self.mode)) {
            if slot.stand == Stand::Armed {
                run.due.insert(spec.id);
            }
        }
    }

    /// Evaluates all guards at the present instant and says how each stands.
    ///
    /// A guard that was disarmed in the same mode `from` stays so until it is positive.
    /// Returns `false` when the tick ends here.
    pub(super) fn take_guards<S, W>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        from: Option<M::Mode>,
    ) -> bool
    where
        S: Signal<M::Input>,
    {
        let input = run.input();
        let specs = self.model.guards(self.mode);
        if specs.len() > MAX_GUARDS {
            run.fail(Fault::Guard);
            return false;
        }
        for (slot, spec) in self.guards.iter_mut().zip(specs) {
            if !self.model.is_watched(self.mode, spec.id) {
                *slot = GuardSlot::UNWATCHED;
                continue;
            }
            if !run.spend_guards(1) {
                return false;
            }
            let value = self.model.guard(self.mode, spec.id, &self.state, &input);
            if !value.value.is_finite() || !value.rate.is_finite() {
                run.fail(Fault::Guard);
                return false;
            }
            let is_due = run.due.contains(spec.id);
            let now = stand(spec, value, run.h, run.since_event);
            let stands = match from {
                _ if is_due => now.crossed(),
                Some(mode) if mode == self.mode => now.again(slot.stand),
                _ => now,
            };
            *slot = GuardSlot::new(stands, spec, value);
            if stands != Stand::Leaving {
                run.due.remove(spec.id);
            }
        }
        true
    }

    /// A guard that its own reset map left where it was has done its work.
    fn disarm_if_spent(&mut self, index: usize) {
        let slot = &mut self.guards[index];
        if matches!(slot.stand, Stand::Leaving | Stand::Resting) {
            slot.stand = Stand::Spent;
        }
    }
}
