//! Advancing a model over a tick: step, watch guards, locate, reset, go on.
//!
//! Here is the tick itself; [`detect`] looks for the first crossing of a step, and
//! [`transition`] fires guards until the present instant is over.

mod detect;
mod transition;

use detect::First;

use crate::epoch::{Stand, stand_after};
use crate::guard::{GuardValue, MAX_GUARDS, Reads};
use crate::input::Signal;
use crate::limits::Limits;
use crate::math;
use crate::model::Resets;
use crate::outcome::{Advance, Cap, Fault, Tick};
use crate::run::Run;
use crate::state::is_finite;
use crate::stepper::{Step, Stepper};
use crate::watch::{Piece, Watch};

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
    /// Width [s] to which an event at the very end of the last tick was located, or 0.
    since_event: f64,
    /// The derivative at the present state, where the stepper left it in this tick.
    carried: Option<M::State>,
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
            carried: None,
        }
    }

    /// The same at the start of `tick`.
    #[must_use]
    pub fn with_tick(self, tick: u64) -> Self {
        Self { tick, ..self }
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
        // The model may have been changed since the last tick, and its derivative with it.
        self.carried = None;
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
            Ok(None) => _ = self.accept(run, &step, theta_end, 1.0),
            Ok(Some(first)) => self.leave(run, &step, theta_end, &first),
        }
    }

    /// Keeps the step up to the first crossing, and fires what crosses there.
    #[cold]
    fn leave<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut Run<'_, S, W>,
        step: &Step<M::State>,
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
        let longest = self.model.longest_step(self.mode).min(run.limits.longest_step);
        if longest >= run.h {
            return 1.0;
        }
        let n = math::ceil(run.h / longest * (1.0 - CRUMB)).clamp(1.0, MOST_LINES);
        let rounding = 4.0 * f64::EPSILON * n;
        let k = math::floor(run.theta * n + CRUMB + rounding) + 1.0;
        if k >= n { 1.0 } else { k / n }
    }

    /// Keeps the step up to `tau` of it; `false` if the state there is not finite.
    #[inline]
    fn accept<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut Run<'_, S, W>,
        step: &Step<M::State>,
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
        run.local_error = run.local_error.max(step.error);
        self.state = end;
        self.carried = if tau < 1.0 { None } else { step.last };
        if tau >= 1.0 {
            for (slot, spec) in self.guards.iter_mut().zip(self.model.guards(self.mode)) {
                slot.0 = stand_after(slot.0, spec, slot.1, span * run.h);
            }
        }
        run.move_to(theta);
        true
    }

    /// Adds a piece's readout to the tick's mean, by Simpson's rule.
    #[inline]
    fn sum_readout<S: Signal<M::Input>, W>(
        &self,
        run: &mut Run<'_, S, W>,
        piece: &Piece<'_, M, S>,
        end_input: &M::Input,
    ) {
        run.work.readouts += 2 + u32::from(run.readout.is_none());
        let readout = |x: &M::State, input: &M::Input| self.model.readout(self.mode, x, input);
        let start = run.readout.unwrap_or_else(|| readout(&self.state, &run.input()));
        let (x, input) = piece.at(0.5);
        let middle = readout(&self.model.constrain(self.mode, &x, &input), &input);
        let end = readout(&piece.end, end_input);
        run.integral += piece.duration() * (start + 4.0 * middle + end) / 6.0;
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
