//! What happens at one instant: guards fire until none must leave.

use super::Simulator;
use crate::epoch::{Stand, stand};
use crate::guard::{GuardId, MAX_GUARDS};
use crate::input::Signal;
use crate::math;
use crate::model::{Reset, Resets, Settling};
use crate::outcome::{Cap, Fault};
use crate::run::Run;
use crate::state::State as _;
use crate::stepper::{Memory as _, Stepper};
use crate::watch::{Cause, Event, Watch};

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// Fires guards until none must leave at this instant; at most `limits.cascade`.
    pub(super) fn settle<S, W>(&mut self, run: &mut Run<'_, S, W>)
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        for _ in 0..=run.limits.cascade {
            let specs = self.model.guards(self.mode);
            let leaving = (0..specs.len().min(MAX_GUARDS))
                .filter(|index| self.guards[*index].0 == Stand::Leaving)
                .min_by_key(|index| (specs[*index].priority, specs[*index].id.0));
            let Some(index) = leaving else { return };
            if !self.fire(run, index) {
                return;
            }
        }
    }

    /// Applies one reset map and takes the guards anew; `false` if the tick ends here.
    pub(super) fn fire<S, W>(&mut self, run: &mut Run<'_, S, W>, index: usize) -> bool
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
        run.cascade += 1;
        let spec = &self.model.guards(self.mode)[index];
        run.due.remove(spec.id);
        let input = run.input();
        let reset = self.model.reset(self.mode, spec.id, &self.state, &input);
        let from = self.mode;
        if !self.land(run, Cause::Guard(spec), &reset, &input) {
            return false;
        }
        if let Some(settling) = reset.settles.filter(|it| is_due(run, it)) {
            return self.accumulate(run, &settling) && self.take_guards(run, None);
        }
        let taken = self.take_guards(run, Some(from));
        self.disarm_if_spent(from, spec.id);
        taken
    }

    /// Takes a declared Zeno sequence in one move: to its end if that lies within the
    /// tick, otherwise over all the impacts that do.
    fn accumulate<S, W>(&mut self, run: &mut Run<'_, S, W>, settling: &Settling<M>) -> bool
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        let rest = (1.0 - run.theta) * run.h;
        let (part, mode, cause) = if settling.after <= rest {
            (1.0, settling.mode, Cause::Settled)
        } else {
            let n = settling.impacts_within(rest);
            (1.0 - math::powf(settling.ratio, n), self.mode, Cause::Impacts(n))
        };
        let way = settling.state.plus(-1.0, &self.state);
        let reset = Reset::to(mode, self.state.plus(part, &way));
        let theta = (run.theta + part * settling.after / run.h).max(run.theta).min(1.0);
        let duration = (theta - run.theta) * run.h;
        // Between the impacts the readout goes its way, nearly straight.
        let start = self.model.readout(self.mode, &self.state, &run.input());
        run.move_to(theta);
        run.since_event = run.resolution();
        let input = run.input();
        let end = self.model.readout(self.mode, &reset.state, &input);
        run.integral += 0.5 * duration * (start + end);
        run.work.readouts += 2;
        self.land(run, cause, &reset.with_impulse(part * settling.impulse), &input)
    }

    /// Takes over what a reset map gave, and tells the watch; `false` if it is not finite.
    fn land<S, W>(
        &mut self,
        run: &mut Run<'_, S, W>,
        cause: Cause<'_>,
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
        let (before, after) = ((self.mode, self.state), (reset.mode, state));
        let event = Event {
            tick: self.tick,
            theta: run.theta,
            cause,
            before,
            after,
            input: *input,
            impulse: reset.impulse,
        };
        run.watch.event(&self.model, &event);
        run.work.events += 1;
        run.impulse += reset.impulse;
        run.readout = None;
        (self.mode, self.state) = after;
        self.memory.restart();
        true
    }

    /// Notes that every guard that was positive crosses if the input's jump makes it negative.
    pub(super) fn expect_jumps<S, W>(&self, run: &mut Run<'_, S, W>) {
        for (slot, spec) in self.guards.iter().zip(self.model.guards(self.mode)) {
            if slot.0 == Stand::Armed {
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
        run: &mut Run<'_, S, W>,
        from: Option<M::Mode>,
    ) -> bool
    where
        S: Signal<M::Input>,
    {
        let input = run.input();
        let specs = self.model.guards(self.mode);
        debug_assert!(specs.len() <= MAX_GUARDS, "a mode has too many guards");
        for (slot, spec) in self.guards.iter_mut().zip(specs) {
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
                Some(mode) if mode == self.mode => now.again(slot.0),
                _ => now,
            };
            *slot = (stands, value);
            if stands != Stand::Leaving {
                run.due.remove(spec.id);
            }
        }
        true
    }

    /// A guard that its own reset map left where it was has done its work.
    fn disarm_if_spent(&mut self, from: M::Mode, fired: GuardId) {
        if from != self.mode {
            return;
        }
        for (slot, spec) in self.guards.iter_mut().zip(self.model.guards(self.mode)) {
            if spec.id == fired && matches!(slot.0, Stand::Leaving | Stand::Resting) {
                slot.0 = Stand::Disarmed;
            }
        }
    }
}

/// Whether a declared Zeno sequence is taken in one move: when enough of its impacts
/// were followed one by one in this tick, or they are too close to tell apart.
fn is_due<M: Resets, S, W>(run: &Run<'_, S, W>, settling: &Settling<M>) -> bool {
    let is_soon = run.work.events >= run.limits.followed || settling.after <= run.resolution();
    let rest = (1.0 - run.theta) * run.h;
    is_soon
        && run.work.events < run.limits.events
        && (settling.after <= rest || settling.impacts_within(rest) >= 1.0)
}
