//! Advancing a model over a tick: step, watch guards, locate, reset, go on.
//!
//! Here is the tick itself; [`detect`] looks for the first crossing of a step, and
//! [`transition`] fires guards until the present instant is over.

mod detect;
mod field;
mod transition;

use detect::First;
use field::ModeField;

use crate::dense::Dense as _;
use crate::epoch::{Stand, stand_after};
use crate::guard::{GuardValue, MAX_GUARDS, Reads};
use crate::input::Signal;
use crate::limits::Limits;
use crate::math;
use crate::model::Resets;
use crate::outcome::{Advance, Cap, Fault, Tick};
use crate::quadrature::{LOBATTO, SIMPSON};
use crate::run::Run;
use crate::state::{is_finite, largest};
use crate::stepper::{Memory as _, Step, Stepper};
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
    guards: [(Stand, GuardValue); MAX_GUARDS],
    /// The input at the end of the last tick: guards are taken anew where it jumped.
    last_input: Option<M::Input>,
    /// Width [s] to which an event at the very end of the last tick was located, or 0.
    since_event: f64,
    /// What the stepper carries from one step to the next.
    memory: T::Memory<M::State>,
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
            since_event: 0.0,
            memory: T::Memory::default(),
        }
    }

    /// The same at the start of `tick`.
    #[must_use]
    pub fn with_tick(self, tick: u64) -> Self {
        Self { tick, ..self }
    }

    /// The model.
    pub const fn model(&self) -> &M {
        &self.model
    }

    /// Puts another model of the same kind in its place, from the next tick on: the guards are
    /// taken anew, since its parameters may have moved them.
    pub fn set_model(&mut self, model: M) {
        self.model = model;
        self.last_input = None;
        self.memory.restart();
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
        self.last_input = None;
        self.memory.restart();
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
        } else {
            run.fail(Fault::Period);
        }
        for _ in 0..=run.limits.pieces {
            if !run.is_going() {
                break;
            }
            self.advance_piece(&mut run);
        }
        self.finish(run)
    }

    /// Takes the guards at the start of the tick, and settles what is due at once.
    #[inline]
    fn begin<S: Signal<M::Input>, W: Watch<M>>(&mut self, run: &mut Run<'_, S, W>) {
        self.memory.begin_tick();
        let input = run.input();
        if self.last_input == Some(input) {
            return;
        }
        let Some(state) = self.constrained(self.mode, &self.state, &input) else {
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
        }
    }

    /// Advances one step, or the part of it up to the first crossing.
    #[inline]
    fn advance_piece<S: Signal<M::Input>, W: Watch<M>>(&mut self, run: &mut Run<'_, S, W>) {
        if run.work.pieces >= run.limits.pieces {
            return run.cap(Cap::Pieces);
        }
        run.work.pieces += 1;
        let theta_end = self.step_end(run);
        let span = theta_end - run.theta;
        let mut field = ModeField::new(&self.model, self.mode, run.signal, (run.theta, span));
        let mut step = self.stepper.step(&mut field, &self.state, &mut self.memory, span * run.h);
        field.count(&mut run.work);
        if !step.is_accepted {
            return;
        }
        if !is_finite(step.dense.end()) {
            return run.fail(Fault::State);
        }
        match self.first_crossing(run, &mut step, theta_end) {
            Err(fault) => run.fail(fault),
            Ok(_) if !run.is_going() => {}
            Ok(None) => _ = self.accept(run, &step, theta_end, 1.0),
            Ok(Some(first)) => self.leave(run, &step, theta_end, &first),
        }
    }

    /// Keeps the step up to the first crossing, and fires what crosses there.
    #[cold]
    fn leave<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut Run<'_, S, W>,
        step: &Step<M::State, T::Dense<M::State>>,
        theta_end: f64,
        first: &First,
    ) {
        if first.tau > 0.0 {
            if !self.accept(run, step, theta_end, first.tau) {
                return;
            }
            run.since_event = run.resolution();
        }
        run.due = first.crossed;
        if self.fire(run, first.index) {
            self.settle(run);
        }
    }

    /// Where the step that begins now ends: on the next line of the mode's grid.
    #[inline]
    fn step_end<S, W>(&self, run: &Run<'_, S, W>) -> f64 {
        /// A rest shorter than this part of a step joins the next one.
        const CRUMB: f64 = 1e-9;
        /// More lines than any tick can have pieces.
        const MOST_LINES: f64 = 1e12;
        let own = self.model.longest_step(self.mode);
        let longest = self
            .stepper
            .longest_step(&self.model.nature(self.mode), own)
            .min(run.limits.longest_step);
        let reach = self.memory.reach() / run.h;
        if reach < 1.0 - run.theta {
            return self.reached(run, reach, longest / run.h);
        }
        if longest >= run.h {
            return 1.0;
        }
        let n = math::ceil(run.h / longest * (1.0 - CRUMB)).clamp(1.0, MOST_LINES);
        let rounding = 4.0 * f64::EPSILON * n;
        let k = math::floor(run.theta * n + CRUMB + rounding) + 1.0;
        if k >= n { 1.0 } else { k / n }
    }

    /// Where a step ends that its method wants no longer than `reach`, a part of the tick.
    fn reached<S, W>(&self, run: &Run<'_, S, W>, reach: f64, longest: f64) -> f64 {
        let reach = reach.min(longest);
        let rest = 1.0 - run.theta;
        // Two even steps rather than a long one and a crumb.
        let part = if reach < rest && 2.0 * reach > rest { 0.5 * rest } else { reach };
        if part < rest { run.theta + part } else { 1.0 }
    }

    /// Keeps the step up to `tau` of it; `false` if the state there is not finite.
    #[inline]
    fn accept<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut Run<'_, S, W>,
        step: &Step<M::State, T::Dense<M::State>>,
        theta_end: f64,
        tau: f64,
    ) -> bool {
        let span = theta_end - run.theta;
        let theta = if tau < 1.0 { run.theta + tau * span } else { theta_end };
        let input = run.signal.at(theta);
        let Some(end) = self.constrained(self.mode, &step.dense.at(tau), &input) else {
            run.fail(Fault::State);
            return false;
        };
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
        run.local_error = run.local_error.max(largest(&step.error));
        self.state = end;
        if tau < 1.0 {
            self.memory.restart();
        } else {
            for (slot, spec) in self.guards.iter_mut().zip(self.model.guards(self.mode)) {
                slot.0 = stand_after(slot.0, spec, slot.1, span * run.h);
            }
        }
        run.move_to(theta);
        true
    }

    /// Adds a piece's readout to the tick's mean, by a rule that fits the dense output.
    #[inline]
    fn sum_readout<S: Signal<M::Input>, W>(
        &self,
        run: &mut Run<'_, S, W>,
        piece: &Piece<'_, M, S>,
        end_input: &M::Input,
    ) {
        /// From this order on, Simpson's rule would lose what the method has gained.
        const HIGH: u32 = 5;
        let readout = |x: &M::State, input: &M::Input| self.model.readout(self.mode, x, input);
        let start = run.readout.unwrap_or_else(|| readout(&self.state, &run.input()));
        let end = readout(&piece.end, end_input);
        let inside = |part: f64| {
            let (x, input) = piece.at(part);
            readout(&self.model.constrain(self.mode, &x, &input), &input)
        };
        let (mean, looks) = if T::DENSE >= HIGH {
            (LOBATTO.mean([start, end], inside), LOBATTO.looks())
        } else {
            (SIMPSON.mean([start, end], inside), SIMPSON.looks())
        };
        run.work.readouts += 1 + looks + u32::from(run.readout.is_none());
        run.integral += piece.duration() * mean;
        run.readout = Some(end);
    }

    /// The state with its slaved coordinates in place, if it is finite.
    #[inline]
    fn constrained(&self, mode: M::Mode, x: &M::State, input: &M::Input) -> Option<M::State> {
        Some(self.model.constrain(mode, x, input)).filter(is_finite)
    }

    #[inline]
    fn finish<S: Signal<M::Input>, W>(&mut self, mut run: Run<'_, S, W>) -> Tick {
        let input = run.signal.at(1.0);
        let is_complete = run.advance == Advance::Completed;
        if !is_complete {
            // Held: the rest of the tick keeps the last good state.
            self.state = self.constrained(self.mode, &self.state, &input).unwrap_or(self.state);
            run.readout = None;
        }
        self.last_input = is_complete.then_some(input);
        self.since_event = run.since_event;
        let end = run.readout.unwrap_or_else(|| self.model.readout(self.mode, &self.state, &input));
        self.tick += 1;
        let mut tick = run.into_tick(end);
        let is_finite = tick.mean_readout.is_finite() && tick.end_readout.is_finite();
        if !is_finite && !matches!(tick.advance, Advance::Faulty(_)) {
            tick.advance = Advance::Faulty(Fault::Readout);
        }
        tick
    }
}
