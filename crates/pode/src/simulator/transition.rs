//! Events of one instant: guards fire until all are settled.

use super::Simulator;
use crate::epoch::{Stand, stand};
use crate::forecast::GuardSlot;
use crate::guard::{GuardId, MAX_GUARDS};
use crate::input::Signal;
use crate::model::{Reset, Resets};
use crate::outcome::Fault;
use crate::run::TickRun;
use crate::state::State as _;
use crate::stepper::Stepper;
use crate::watch::{Event, EventCause, Watch};

pub(super) struct EventReport<'a> {
    pub(super) cause: EventCause<'a>,
    /// Error of its time (s).
    pub(super) error: f64,
    pub(super) projection: f64,
}

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// Fires guards until none is due at this instant; at most `limits.cascade`.
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

    /// Applies one reset map and evaluates the guards again; `false` if the tick ends here.
    pub(super) fn fire<S, W>(&mut self, run: &mut TickRun<'_, S, W>, index: usize) -> bool
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        if let Some(cap) = run.most_events() {
            run.cap(cap);
            return false;
        }
        let Some(spec) = self.model.guards(self.mode).get(index).copied() else {
            run.fail(Fault::Guard);
            return false;
        };
        run.cascade += 1;
        run.has_aimed = false;
        run.due.remove(spec.id);
        // The guard has fired, so its earlier stand no longer applies.
        self.guards[index].stand = Stand::Leaving;
        let input = run.input();
        let reset = self.model.reset(self.mode, spec.id, &self.state, &input);
        let from = self.mode;
        let projection = self.projection(reset.mode, &input);
        run.errors.projection = run.errors.projection.max(projection);
        if projection > self.model.nature(reset.mode).longest_projection {
            run.fail(Fault::Projection);
            return false;
        }
        let cause = EventCause::Guard(&spec);
        let told = EventReport { cause, error: run.resolution(), projection };
        if !self.land(run, told, &reset, &input) {
            return false;
        }
        if !self.take_guards(run, Some(from)) {
            return false;
        }
        self.silence(reset.released);
        match self.accumulates(run, &reset, spec.id) {
            None => {
                if from == self.mode {
                    run.work.ineffective += u32::from(self.guards[index].stand == Stand::Leaving);
                    self.disarm_if_spent(index);
                }
                true
            }
            Some(goes_on) => goes_on && self.take_guards(run, None),
        }
    }

    /// Sets the reset's state and notifies the watch; `false` if it is not finite.
    pub(super) fn land<S, W>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        EventReport { cause, error, projection }: EventReport<'_>,
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
            error,
            projection,
        };
        run.watch.event(&self.model, &event);
        run.work.events += 1;
        run.impulse += reset.impulse;
        run.readout = None;
        (self.mode, self.state) = (reset.mode, state);
        self.restart();
        true
    }

    fn projection(&self, mode: M::Mode, input: &M::Input) -> f64 {
        let constrained = self.model.constrain(mode, &self.state, input);
        let pairs =
            self.state.entries().iter().zip(constrained.entries()).take(self.model.coordinates());
        pairs.map(|(is, should_be)| (should_be - is).abs()).fold(0.0, f64::max)
    }

    pub(super) fn expect_jumps<S, W>(&self, run: &mut TickRun<'_, S, W>) {
        for (slot, spec) in self.guards.iter().zip(self.model.guards(self.mode)) {
            if slot.stand == Stand::Armed {
                run.due.insert(spec.id);
            }
        }
    }

    /// Evaluates all guards at the present instant and finds how each stands; `false` if the tick
    /// ends here. A guard disarmed in the same mode `from` stays so until it is positive.
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

    /// Keeps the guard of a contact that has just opened from firing before it has been positive, or
    /// sinks: the state lies on the contact within the error of its constraint.
    fn silence(&mut self, released: Option<GuardId>) {
        let slots = self.guards.iter_mut().zip(self.model.guards(self.mode));
        for (slot, _) in slots.filter(|(_, spec)| Some(spec.id) == released) {
            if slot.stand == Stand::Leaving {
                slot.stand = Stand::Spent;
            }
        }
    }

    fn disarm_if_spent(&mut self, index: usize) {
        let slot = &mut self.guards[index];
        if matches!(slot.stand, Stand::Leaving | Stand::Resting) {
            slot.stand = Stand::Spent;
        }
    }
}
