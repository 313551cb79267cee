//! Advancing a model over a tick: step, watch guards, locate, reset, go on.

use core::cell::Cell;

use crate::crossing::{Crossing, Span};
use crate::epoch::{Stand, stand, stand_after};
use crate::guard::{GuardId, GuardSpec, GuardValue, MAX_GUARDS};
use crate::input::Signal;
use crate::limits::Limits;
use crate::locate::{locate, most_evaluations};
use crate::math;
use crate::model::{Reset, Resets, Settling};
use crate::outcome::{Cap, Fault, Tick};
use crate::run::Run;
use crate::state::{State, is_finite};
use crate::stepper::{Step, Stepper};
use crate::watch::{Cause, Event, Piece, Watch};

/// A model in motion.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Simulator<M: Resets, T> {
    /// The model; a change takes effect with the next tick.
    pub model: M,
    stepper: T,
    limits: Limits,
    tick: u64,
    mode: M::Mode,
    state: M::State,
    guards: [(Stand, GuardValue); MAX_GUARDS],
    /// The input at the end of the last tick: guards are taken anew where it jumped.
    last_input: Option<M::Input>,
    /// The derivative at the present state, where the stepper left it.
    carried: Option<M::State>,
}

/// The first crossing of a step: which guard, and where in the step.
#[derive(Clone, Copy)]
struct First {
    index: usize,
    tau: f64,
}

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// A model at rest in `mode` and `state` at the start of tick 0.
    pub fn new(model: M, stepper: T, limits: Limits, mode: M::Mode, state: M::State) -> Self {
        Self {
            model,
            stepper,
            limits,
            tick: 0,
            mode,
            state,
            guards: [(Stand::Resting, GuardValue::default()); MAX_GUARDS],
            last_input: None,
            carried: None,
        }
    }

    /// The present mode.
    pub const fn mode(&self) -> M::Mode {
        self.mode
    }

    /// The present state.
    pub const fn state(&self) -> &M::State {
        &self.state
    }

    /// Ticks advanced since the start.
    pub const fn tick(&self) -> u64 {
        self.tick
    }

    /// Puts the model into `mode` and `state` at the start of the next tick.
    pub fn place(&mut self, mode: M::Mode, state: M::State) {
        (self.mode, self.state) = (mode, state);
        (self.last_input, self.carried) = (None, None);
    }

    /// Advances one tick of `h` [s] under the input `signal`.
    ///
    /// # Real-time
    /// Bounded by [`Limits`]; at a maximum, or when something is not finite, the last
    /// good state is held for the rest of the tick and the tick says so.
    pub fn advance<S, W>(&mut self, h: f64, signal: &S, watch: &mut W) -> Tick
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        let mut run = Run::new(h, signal, watch, self.limits);
        if h > 0.0 && h.is_finite() {
            self.begin(&mut run);
            for _ in 0..=run.limits.pieces {
                if !run.is_going() {
                    break;
                }
                self.advance_piece(&mut run);
            }
        } else {
            run.fail(Fault::Period);
        }
        self.finish(run)
    }

    /// Takes the guards at the start of the tick, and settles what is due at once.
    fn begin<S: Signal<M::Input>, W: Watch<M>>(&mut self, run: &mut Run<'_, S, W>) {
        let input = run.input();
        if self.last_input == Some(input) {
            return;
        }
        self.carried = None;
        self.state = self.model.constrain(self.mode, &self.state, &input);
        let fresh = self.last_input.is_none();
        if self.take_guards(run, if fresh { None } else { Some(self.mode) }) {
            self.settle(run);
        }
    }

    /// Advances one step, or the part of it up to the first crossing.
    fn advance_piece<S: Signal<M::Input>, W: Watch<M>>(&mut self, run: &mut Run<'_, S, W>) {
        if run.work.pieces >= run.limits.pieces {
            return run.cap(Cap::Pieces);
        }
        run.work.pieces += 1;
        let theta_end = self.step_end(run);
        let span = theta_end - run.theta;
        let (h, theta) = (span * run.h, run.theta);
        let (model, mode, signal) = (&self.model, self.mode, run.signal);
        let step = self.stepper.step(
            |tau, x| model.derivative(mode, x, &signal.at(theta + tau * span)),
            &self.state,
            self.carried.as_ref(),
            h,
            M::COORDS,
        );
        run.work.derivatives += step.evaluations;
        if !is_finite(step.dense.end()) {
            return run.fail(Fault::State);
        }
        match self.first_crossing(run, &step, theta_end) {
            Err(fault) => run.fail(fault),
            Ok(_) if !run.is_going() => {}
            Ok(None) => self.accept(run, &step, theta_end, 1.0),
            Ok(Some(first)) => {
                if first.tau > 0.0 {
                    self.accept(run, &step, theta_end, first.tau);
                    run.since_event = run.resolution();
                }
                self.fire_and_settle(run, first.index);
            }
        }
    }

    /// Where the step that begins now ends: on the next line of the mode's grid.
    fn step_end<S, W>(&self, run: &Run<'_, S, W>) -> f64 {
        /// A rest shorter than this part of a step joins the next one.
        const CRUMB: f64 = 1e-9;
        let longest = self.model.longest_step(self.mode).min(run.limits.longest_step);
        let n = math::ceil(run.h / longest * (1.0 - CRUMB)).max(1.0);
        let k = math::floor(run.theta * n + CRUMB) + 1.0;
        if k >= n { 1.0 } else { k / n }
    }

    /// The earliest crossing within the step; ties go to the lower priority number.
    fn first_crossing<S: Signal<M::Input>, W>(
        &mut self,
        run: &mut Run<'_, S, W>,
        step: &Step<M::State>,
        theta_end: f64,
    ) -> Result<Option<First>, Fault> {
        let specs = self.model.guards(self.mode);
        let end_input = run.signal.at(theta_end);
        let end_state = self.model.constrain(self.mode, step.dense.end(), &end_input);
        let h = (theta_end - run.theta) * run.h;
        let tie = run.resolution() / h;
        let mut crossed = [f64::INFINITY; MAX_GUARDS];
        for (index, spec) in specs.iter().enumerate().take(MAX_GUARDS) {
            if !run.spend_guards(1) {
                return Ok(None);
            }
            let end = self.model.guard(self.mode, spec.id, &end_state, &end_input);
            if !end.value.is_finite() || !end.rate.is_finite() {
                return Err(Fault::Guard);
            }
            let (stand, start) = self.guards[index];
            let span = Span { spec, stand, start, end, h };
            let tau = self.locate_crossing(run, step, theta_end, &span)?;
            self.guards[index] = (stand, end);
            crossed[index] = tau.unwrap_or(f64::INFINITY);
        }
        Ok(earliest(specs, &crossed, tie))
    }

    /// Where in the step one guard crosses, if it does.
    fn locate_crossing<S: Signal<M::Input>, W>(
        &self,
        run: &mut Run<'_, S, W>,
        step: &Step<M::State>,
        theta_end: f64,
        span: &Span<'_>,
    ) -> Result<Option<f64>, Fault> {
        let (model, mode, signal, start) = (&self.model, self.mode, run.signal, run.theta);
        let looks = Cell::new(0);
        let mut guard = |tau: f64| {
            looks.set(looks.get() + 1);
            let input = signal.at(start + tau * (theta_end - start));
            let x = model.constrain(mode, &step.dense.at(tau), &input);
            model.guard(mode, span.spec.id, &x, &input).value
        };
        let crossing = span.crossing(&mut guard);
        let tau = match crossing {
            Crossing::None => None,
            Crossing::AtStart => Some(0.0),
            Crossing::Within { bracket, level, seed } => {
                // The tolerance is a fraction of the tick; the step is a part of it.
                let tolerance = (run.limits.event_tolerance / (theta_end - start)).min(0.5);
                if run.work.guards + looks.get() + most_evaluations(tolerance) > run.limits.guards {
                    run.cap(Cap::Guards);
                    return Ok(None);
                }
                let located = locate(|tau| guard(tau) - level, bracket, seed, tolerance);
                if located.not_finite {
                    return Err(Fault::Guard);
                }
                Some(located.tau)
            }
        };
        run.spend_guards(looks.get());
        Ok(tau)
    }

    /// Keeps the step up to `tau` of it.
    fn accept<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut Run<'_, S, W>,
        step: &Step<M::State>,
        theta_end: f64,
        tau: f64,
    ) {
        let theta = if tau < 1.0 { run.theta + tau * (theta_end - run.theta) } else { theta_end };
        let span = theta_end - run.theta;
        let input = run.signal.at(theta);
        let end = self.model.constrain(self.mode, &step.dense.at(tau), &input);
        let piece = Piece {
            mode: self.mode,
            dense: &step.dense,
            h: span * run.h,
            tau,
            end,
            theta: (run.theta, theta_end),
            tick: self.tick,
            signal: run.signal,
        };
        self.sum_readout(run, &piece, &input);
        run.watch.piece(&self.model, &piece);
        run.local_error = run.local_error.max(step.error);
        self.state = end;
        self.carried = if tau < 1.0 { None } else { step.last };
        if tau >= 1.0 {
            let h = span * run.h;
            for (slot, spec) in self.guards.iter_mut().zip(self.model.guards(self.mode)) {
                slot.0 = stand_after(slot.0, spec, slot.1, h);
            }
        }
        run.move_to(theta);
    }

    /// Adds a piece's readout to the tick's mean, by Simpson's rule.
    fn sum_readout<S: Signal<M::Input>, W>(
        &self,
        run: &mut Run<'_, S, W>,
        piece: &Piece<'_, M, S>,
        end_input: &M::Input,
    ) {
        let readout = |(x, input): (M::State, M::Input)| self.model.readout(self.mode, &x, &input);
        let start = run.readout.unwrap_or_else(|| readout(piece.at(0.0)));
        let middle = readout(piece.at(0.5));
        let end = self.model.readout(self.mode, &piece.end, end_input);
        run.work.readouts += 2 + u32::from(run.readout.is_none());
        run.integral += piece.duration() * (start + 4.0 * middle + end) / 6.0;
        run.readout = Some(end);
    }

    /// Fires the guard at `index`, then whatever must leave at the same instant.
    fn fire_and_settle<S, W>(&mut self, run: &mut Run<'_, S, W>, index: usize)
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        if self.fire(run, index) {
            self.settle(run);
        }
    }

    /// Fires guards until none must leave at this instant; at most `limits.cascade`.
    fn settle<S, W>(&mut self, run: &mut Run<'_, S, W>)
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        for _ in 0..=run.limits.cascade {
            let specs = self.model.guards(self.mode);
            let leaving = (0..specs.len().min(MAX_GUARDS))
                .filter(|index| self.guards[*index].0 == Stand::Leaving)
                .min_by_key(|index| specs[*index].priority);
            let Some(index) = leaving else { return };
            if !self.fire(run, index) {
                return;
            }
        }
    }

    /// Applies one reset map and takes the guards anew; `false` if the tick ends here.
    fn fire<S, W>(&mut self, run: &mut Run<'_, S, W>, index: usize) -> bool
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
        let input = run.input();
        let reset = self.model.reset(self.mode, spec.id, &self.state, &input);
        if !is_finite(&reset.state) || !reset.impulse.is_finite() {
            run.fail(Fault::State);
            return false;
        }
        let from = self.mode;
        self.land(run, Cause::Guard(spec), &reset, &input);
        if let Some(settling) = reset.settles.filter(|it| is_due(run, it)) {
            self.accumulate(run, &settling);
            return self.take_guards(run, None);
        }
        let taken = self.take_guards(run, Some(from));
        self.disarm_if_spent(from, spec.id);
        taken
    }

    /// Takes a declared Zeno sequence in one move: to its end if that lies within the
    /// tick, otherwise over all the impacts that do.
    fn accumulate<S, W>(&mut self, run: &mut Run<'_, S, W>, settling: &Settling<M>)
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
        run.move_to((run.theta + part * settling.after / run.h).min(1.0));
        run.since_event = run.resolution();
        let input = run.input();
        self.land(run, cause, &reset.with_impulse(part * settling.impulse), &input);
    }

    /// Takes over what a reset map gave, and tells the watch.
    fn land<S, W>(
        &mut self,
        run: &mut Run<'_, S, W>,
        cause: Cause<'_>,
        reset: &Reset<M>,
        input: &M::Input,
    ) where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        let before = (self.mode, self.state);
        let after = (reset.mode, self.model.constrain(reset.mode, &reset.state, input));
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
        self.carried = None;
    }

    /// Evaluates all guards at the present instant and says how each stands.
    ///
    /// A guard that was disarmed in the same mode `from` stays so until it is positive.
    /// Returns `false` when the tick ends here.
    fn take_guards<S, W>(&mut self, run: &mut Run<'_, S, W>, from: Option<M::Mode>) -> bool
    where
        S: Signal<M::Input>,
    {
        let input = run.input();
        let specs = self.model.guards(self.mode);
        debug_assert!(specs.len() <= MAX_GUARDS, "a mode has too many guards");
        if !run.spend_guards(specs.len() as u32) {
            return false;
        }
        for (slot, spec) in self.guards.iter_mut().zip(specs) {
            let value = self.model.guard(self.mode, spec.id, &self.state, &input);
            if !value.value.is_finite() || !value.rate.is_finite() {
                run.fail(Fault::Guard);
                return false;
            }
            let stands = stand(spec, value, run.h, run.since_event);
            let was_disarmed = from == Some(self.mode) && slot.0 == Stand::Disarmed;
            let stays = was_disarmed && stands != Stand::Armed;
            *slot = (if stays { Stand::Disarmed } else { stands }, value);
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

    fn finish<S: Signal<M::Input>, W>(&mut self, mut run: Run<'_, S, W>) -> Tick {
        let input = run.signal.at(1.0);
        if !run.is_going() && run.theta < 1.0 {
            // Held: the rest of the tick keeps the last good state.
            self.state = self.model.constrain(self.mode, &self.state, &input);
            run.readout = None;
        }
        self.last_input = (run.theta >= 1.0).then_some(input);
        let end = run
            .readout
            .unwrap_or_else(|| self.model.readout(self.mode, &self.state, &input));
        self.tick += 1;
        let mut tick = run.into_tick(end);
        if !tick.mean_readout.is_finite() || !tick.end_readout.is_finite() {
            tick.advance = crate::outcome::Advance::Faulty(Fault::Readout);
        }
        tick
    }
}

/// The earliest crossing; among those within `tie` of it, the lowest priority number.
///
/// Depends on the set of guards only, not on their order.
fn earliest(specs: &[GuardSpec], crossed: &[f64; MAX_GUARDS], tie: f64) -> Option<First> {
    let soonest = crossed.iter().copied().fold(f64::INFINITY, f64::min);
    if soonest.is_infinite() {
        return None;
    }
    let simultaneous = crossed.iter().zip(specs).enumerate();
    simultaneous
        .filter(|(_, (tau, _))| **tau <= soonest + tie)
        .min_by_key(|(_, (_, spec))| spec.priority)
        .map(|(index, (tau, _))| First { index, tau: *tau })
}

/// Whether a declared Zeno sequence is taken in one move: when enough of its impacts
/// were followed one by one in this tick, or they are too close to tell apart.
fn is_due<M: Resets, S, W>(run: &Run<'_, S, W>, settling: &Settling<M>) -> bool {
    run.work.events >= run.limits.followed || settling.after <= run.resolution()
}
