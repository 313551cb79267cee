//! One tick: [`detect`] finds a step's first crossing, [`transition`] fires what is due.

mod accumulation;
mod detect;
mod field;
mod parts;
mod run;
mod step_end;
mod transition;

use detect::{First, Suspicion};
use parts::{Memories, ModeStep, PartMemory};

pub use run::RunOutcome;

use crate::dense::Dense as _;
use crate::epoch::stand_after;
use crate::forecast::GuardSlot;
use crate::guard::{MAX_GUARDS, Reads};
use crate::impacts::Impacts;
use crate::input::Signal;
use crate::limits::{Limits, WorkLimit};
use crate::model::{Model, Resets};
use crate::outcome::{Advance, Cap, Fault, Tick};
use crate::quadrature::{LOBATTO, SIMPSON};
use crate::run::TickRun;
use crate::state::{is_finite, largest};
use crate::stepper::{Step, Stepper};
use crate::watch::{Piece, Watch};

/// A model in motion.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Simulator<M: Resets, T: Stepper> {
    model: M,
    stepper: T,
    limits: Limits,
    tick: u64,
    mode: M::Mode,
    state: M::State,
    guards: [GuardSlot; MAX_GUARDS],
    /// Input at the end of the last tick: guards are evaluated again where it jumped.
    last_input: Option<M::Input>,
    /// Width (s) to which an event at the very end of the last tick was located, or 0.
    since_event: f64,
    memory: Memories<M, T>,
    impacts: Impacts<M::Mode>,
    is_read: bool,
}

struct TakenStep<M: Model, T: Stepper> {
    step: Step<M::State, T::Dense<M::State>>,
    theta_end: f64,
    /// Length (s).
    h: f64,
    input_start: M::Input,
    end: M::State,
    input: M::Input,
    is_refined: bool,
}

impl<M: Model, T: Stepper> TakenStep<M, T> {
    #[inline]
    fn theta(&self, theta: f64, tau: f64) -> f64 {
        if tau < 1.0 { theta + tau * (self.theta_end - theta) } else { self.theta_end }
    }
}

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// Builds a simulator at rest in `mode` and `state` at the start of tick 0.
    pub fn new(model: M, stepper: T, limits: Limits, mode: M::Mode, state: M::State) -> Self {
        Self {
            model,
            stepper,
            limits,
            tick: 0,
            mode,
            state,
            guards: [GuardSlot::EMPTY; MAX_GUARDS],
            last_input: None,
            since_event: 0.0,
            memory: core::array::from_fn(|_| PartMemory::default()),
            impacts: Impacts::NONE,
            is_read: true,
        }
    }

    #[must_use]
    pub fn with_tick(self, tick: u64) -> Self {
        Self { tick, ..self }
    }

    /// Returns the simulator without the readout: none is evaluated, and a tick reads 0.
    #[must_use]
    pub fn without_readout(self) -> Self {
        Self { is_read: false, ..self }
    }

    pub const fn model(&self) -> &M {
        &self.model
    }

    /// Replaces the model by one of its kind from the next tick on, and evaluates the guards again.
    pub fn set_model(&mut self, model: M) {
        self.model = model;
        self.last_input = None;
        self.restart();
        self.impacts = Impacts::NONE;
    }

    /// Stretches steps from the next tick on, see [`Limits::stretch`].
    pub const fn set_stretch(&mut self, stretch: f64) {
        self.limits.stretch = stretch;
    }

    /// Limits the work of each tick from the next one on, see [`Limits::work`].
    pub const fn limit_work(&mut self, work: WorkLimit) {
        self.limits.work = work;
    }

    fn restart(&mut self) {
        self.memory.iter_mut().for_each(PartMemory::restart);
    }

    pub const fn mode(&self) -> M::Mode {
        self.mode
    }

    pub const fn state(&self) -> &M::State {
        &self.state
    }

    /// Returns the ticks advanced since the start.
    pub const fn tick(&self) -> u64 {
        self.tick
    }

    /// Sets `mode` and `state` at the start of the next tick.
    pub fn place(&mut self, mode: M::Mode, state: M::State) {
        (self.mode, self.state) = (mode, state);
        self.last_input = None;
        self.restart();
        self.impacts = Impacts::NONE;
    }

    /// Advances one tick of `h` (s) under the input `signal`.
    ///
    /// # Real-time
    /// Bounded by [`Limits`]. At a maximum, or at a number that is not finite, the last good state
    /// is held for the rest of the tick, and the tick reports it.
    pub fn advance<S, W>(&mut self, h: f64, signal: &S, watch: &mut W) -> Tick
    where
        S: Signal<M::Input>,
        W: Watch<M>,
    {
        let mut run = TickRun::new(h, signal, watch, self.limits);
        let mut input = run.input();
        if h > 0.0 && h < f64::INFINITY {
            self.begin(&mut run, &mut input);
        } else {
            run.fail(Fault::Period);
        }
        while run.is_going() {
            self.advance_piece(&mut run, &mut input);
        }
        self.finish(run, input)
    }

    #[inline]
    fn begin<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        input: &mut M::Input,
    ) {
        self.memory.iter_mut().for_each(PartMemory::begin_tick);
        if self.last_input == Some(*input) {
            return;
        }
        self.memory.iter_mut().for_each(PartMemory::jump);
        let Some(state) = self.constrained(self.mode, &self.state, input) else {
            return run.fail(Fault::State);
        };
        self.state = state;
        let from = self.last_input.map(|_| self.mode);
        if from.is_some() {
            run.since_event = self.since_event;
            let specs = self.model.guards(self.mode);
            if specs.iter().all(|spec| spec.reads == Reads::State) {
                return;
            }
            self.expect_jumps(run);
        }
        if self.take_guards(run, from) {
            self.settle(run);
            *input = run.input();
        }
    }

    /// Advances one step, or up to its first crossing; `input` is that of the present instant.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    fn advance_piece<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        input: &mut M::Input,
    ) {
        if run.work.pieces >= run.limits.pieces {
            return run.cap(Cap::Pieces);
        }
        if !run.affords_work(T::EVALUATIONS + T::REFINEMENT) {
            return;
        }
        run.work.pieces += 1;
        let Some(mut taken) = self.take_step(run, input) else { return };
        if self.is_read || W::LOOKS_INSIDE {
            self.refine(run, &mut taken);
        }
        match self.suspicion(run, &taken) {
            Err(fault) => run.fail(fault),
            Ok(_) if !run.is_going() => {}
            Ok(Suspicion { candidates: 0, certainty }) => {
                run.work.judge(certainty);
                self.keep(run, &taken, input);
                *input = taken.input;
            }
            // By value, so that a step that is kept never has to be in memory.
            Ok(found) => *input = self.cross(run, taken, found, *input),
        }
    }

    /// Ends a step that began with `input` at its first crossing, if any; returns the input there.
    #[cold]
    #[inline(never)]
    fn cross<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        mut taken: TakenStep<M, T>,
        found: Suspicion,
        input: M::Input,
    ) -> M::Input {
        match self.first_crossing(run, &mut taken, found) {
            Err(fault) => run.fail(fault),
            Ok(_) if !run.is_going() => {}
            Ok((first, certainty)) => {
                run.work.judge(certainty);
                match first {
                    None => self.keep(run, &taken, &input),
                    Some(first) => self.leave(run, &taken, &first, &input),
                }
            }
        }
        run.input()
    }

    /// Computes a step from `input`; `None` if the method refuses it, or its end is not finite.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    fn take_step<S: Signal<M::Input>, W>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        input: &M::Input,
    ) -> Option<TakenStep<M, T>> {
        let (theta_end, excess) = self.step_end(run, input);
        let h = (theta_end - run.theta) * run.h;
        let mode_step = ModeStep {
            model: &self.model,
            stepper: &self.stepper,
            mode: self.mode,
            signal: run.signal,
            theta: (run.theta, theta_end),
            input: *input,
            excess,
            h,
            rest: run.rest(),
            longest: run.limits.longest_step,
        };
        let input_start = *input;
        let (step, input) = mode_step.take(&self.state, &mut self.memory, &mut run.work);
        if !step.is_accepted {
            return None;
        }
        let Some(end) = self.constrained(self.mode, step.dense.end(), &input) else {
            run.fail(Fault::State);
            return None;
        };
        Some(TakenStep { step, theta_end, h, input_start, end, input, is_refined: false })
    }

    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    fn keep<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
        input: &M::Input,
    ) {
        self.accept(run, taken, (1.0, taken.end), [*input, taken.input]);
        for (slot, spec) in self.guards.iter_mut().zip(self.model.guards(self.mode)) {
            if slot.is_fresh {
                slot.stand = stand_after(slot.stand, spec, slot.value, taken.h);
                slot.room = slot.room_of(spec);
            }
        }
        run.move_to(taken.theta_end);
    }

    #[cold]
    fn leave<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
        first: &First,
        from: &M::Input,
    ) {
        if first.tau > 0.0 {
            let theta = taken.theta(run.theta, first.tau);
            let input = run.signal.at(theta);
            let Some(end) = self.constrained(self.mode, &taken.step.dense.at(first.tau), &input)
            else {
                return run.fail(Fault::State);
            };
            self.accept(run, taken, (first.tau, end), [*from, input]);
            self.restart();
            run.move_to(theta);
            run.since_event = run.resolution();
        }
        run.due = first.crossed;
        if self.fire(run, first.index) {
            self.settle(run);
        }
    }

    /// Moves to the state at `tau` of a step, adds its readout and notifies the watch.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    fn accept<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
        (tau, end): (f64, M::State),
        inputs: [M::Input; 2],
    ) {
        let mut piece = Piece {
            mode: self.mode,
            dense: &taken.step.dense,
            h: taken.h,
            tau,
            start: self.state,
            end,
            inputs,
            middle: None,
            powers: taken.step.powers,
            theta: (run.theta, taken.theta_end),
            tick: self.tick,
            signal: run.signal,
        };
        if self.is_read {
            self.sum_readout(run, &taken.step.dense, &mut piece);
        }
        run.watch.piece(&self.model, &piece);
        run.errors.local = run.errors.local.max(largest(&taken.step.error));
        self.impacts.pass(tau * taken.h);
        self.state = end;
    }

    /// Adds a piece's readout to the tick's mean, by a rule that fits the dense output.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    fn sum_readout<S: Signal<M::Input>, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        dense: &T::Dense<M::State>,
        piece: &mut Piece<'_, M, S>,
    ) {
        let readout = |x: &M::State, input: &M::Input| self.model.readout(self.mode, x, input);
        let start = run.readout.unwrap_or_else(|| readout(&piece.start, &piece.inputs[0]));
        let end = readout(&piece.end, &piece.inputs[1]);
        let inside = |part: f64| {
            let (x, input) = piece.at_in(dense, part);
            (self.model.constrain(self.mode, &x, &input), input)
        };
        let ends = [start, end];
        let (mean, looks) = if self.stepper.is_smooth_inside() {
            let value = |part: f64| {
                let (x, input) = inside(part);
                readout(&x, &input)
            };
            (LOBATTO.mean(ends, value), LOBATTO.looks())
        } else {
            let (x, input) = inside(0.5);
            piece.middle = Some((x, input));
            (SIMPSON.mean(ends, |_middle| readout(&x, &input)), SIMPSON.looks())
        };
        run.work.readouts += 1 + looks + u32::from(run.readout.is_none());
        run.integral += piece.duration() * mean;
        run.readout = Some(end);
    }

    #[inline]
    fn constrained(&self, mode: M::Mode, x: &M::State, input: &M::Input) -> Option<M::State> {
        Some(self.model.constrain(mode, x, input)).filter(is_finite)
    }

    #[inline]
    fn finish<S: Signal<M::Input>, W>(
        &mut self,
        mut run: TickRun<'_, S, W>,
        now: M::Input,
    ) -> Tick {
        let is_complete = run.advance == Advance::Completed;
        let is_at_end = is_complete && run.theta <= 1.0;
        let input = if is_at_end { now } else { run.signal.at(1.0) };
        if !is_complete {
            // Held: the rest of the tick keeps the last good state.
            self.state = self.constrained(self.mode, &self.state, &input).unwrap_or(self.state);
            self.restart();
            self.impacts = Impacts::NONE;
            run.readout = None;
        }
        self.last_input = is_complete.then_some(input);
        self.since_event = run.since_event;
        let end = match run.readout {
            Some(end) => end,
            None if self.is_read => {
                run.work.readouts += 1;
                self.model.readout(self.mode, &self.state, &input)
            }
            None => 0.0,
        };
        self.tick = self.tick.wrapping_add(1);
        let mut tick = run.into_tick(end);
        let is_finite = tick.mean_readout.is_finite() && tick.end_readout.is_finite();
        if !is_finite && !matches!(tick.advance, Advance::Faulty(_)) {
            tick.advance = Advance::Faulty(Fault::Readout);
        }
        tick
    }
}
