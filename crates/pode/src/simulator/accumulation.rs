//! Accumulating impacts (Zeno) in one move: to their rest, or over all that one tick holds.
//!
//! A model declares such a sequence in closed form ([`Settling`]), or names the mode of its rest
//! ([`Reset::rests`]); the intervals then give the sequence.

use super::Simulator;
use super::parts::{Memories, ModeStep, PartMemory};
use super::transition::EventReport;
use crate::dense::Dense as _;
use crate::guard::GuardId;
use crate::impacts::{Accumulation, Impacts};
use crate::input::Signal;
use crate::math;
use crate::model::{Reset, Resets, Settling};
use crate::run::TickRun;
use crate::state::State as _;
use crate::stepper::Stepper;
use crate::watch::{EventCause, Watch};

/// Multiple of the rounding above which a hop must rise to be detected.
const SEEN: f64 = 64.0;

/// Multiple above which a hop can be measured: where it rises to H, rounding by δ is an error of
/// δ/H in its speed, and in all that follows from it.
const MEASURED: f64 = 1_048_576.0;

struct Move {
    /// Fraction of the sequence's time, 0 ..= 1.
    part: f64,
    /// Fraction of the motion left after it.
    left: f64,
    cause: EventCause<'static>,
    /// Error of the sequence's end (s).
    error: f64,
}

impl Move {
    /// Takes the whole sequence if it ends within `rest` (s), otherwise the impacts that do.
    fn within(rest: f64, (after, ratio): (f64, f64), error: f64) -> Self {
        if after <= rest {
            return Self { part: 1.0, left: 0.0, cause: EventCause::Settled, error };
        }
        let n = impacts_within(rest, after, ratio);
        let left = math::powf(ratio, n);
        Self { part: 1.0 - left, left, cause: EventCause::Impacts(n), error }
    }
}

/// Returns the number of impacts within `rest` < `after` (s); the n-th is at `after (1 − ratioⁿ)`.
fn impacts_within(rest: f64, after: f64, ratio: f64) -> f64 {
    math::floor(math::ln(1.0 - rest / after) / math::ln(ratio))
}

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// Takes the impacts that follow the reset of `fired` in one move if they accumulate and the
    /// move is worth it. Returns then `true` if the tick continues.
    pub(super) fn accumulates<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        reset: &Reset<M>,
        fired: GuardId,
    ) -> Option<bool> {
        if let Some(settling) = &reset.settles {
            let Settling { after, ratio, mode, .. } = *settling;
            let error = self.impacts.declare(mode, after, ratio);
            let is_due = self.is_worth_it(run, (after, ratio), (fired, SEEN));
            let is_last = is_near_the_last(run) || self.is_flat((after, ratio), (fired, SEEN));
            let is_sure = is_last || after <= run.resolution() || is_exact(error, run.h);
            return (is_due && is_sure).then(|| self.accumulate(run, settling, error));
        }
        let rest = reset.rests?;
        self.impacts.strike(rest.0, reset.impulse);
        let end = self.impacts.accumulation()?;
        let is_due = self.is_worth_it(run, (end.after, end.ratio), (fired, MEASURED));
        let is_sure = is_due && self.is_sure(run, rest.0, &end);
        if is_sure { self.come_to_rest(run, rest, &end) } else { None }
    }

    fn accumulate<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        settling: &Settling<M>,
        error: f64,
    ) -> bool {
        let it = Move::within(run.rest(), (settling.after, settling.ratio), error);
        let mode = if it.left > 0.0 { self.mode } else { settling.mode };
        let way = settling.state.plus(-1.0, &self.state);
        let reset = Reset::to(mode, self.state.plus(it.part, &way))
            .with_impulse(it.part * settling.impulse);
        self.jump(run, it.part * settling.after, &it, &reset)
    }

    /// Takes a measured sequence in one move: the resting mode's motion, plus the rest of the
    /// bouncing. It is one step, a piece of the tick; `None` if the method refuses it.
    fn come_to_rest<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        (resting, at_rest): (M::Mode, M::State),
        end: &Accumulation,
    ) -> Option<bool> {
        let it = Move::within(run.rest(), (end.after, end.ratio), end.error);
        let mode = if it.left > 0.0 { self.mode } else { resting };
        let time = it.part * end.after;
        let mode_step = ModeStep {
            model: &self.model,
            stepper: &self.stepper,
            mode: resting,
            signal: run.signal,
            theta: (run.theta, run.theta + time / run.h),
            input: run.input(),
            excess: 1.0,
            h: time,
            rest: time,
            longest: time,
        };
        let mut memory: Memories<M, T> = core::array::from_fn(|_| PartMemory::default());
        let (step, _) = mode_step.take(&at_rest, &mut memory, &mut run.work);
        run.work.pieces += 1;
        if !step.is_accepted {
            return None;
        }
        let bouncing = self.state.plus(-1.0, &at_rest);
        let reset = Reset::to(mode, step.dense.end().plus(it.left, &bouncing))
            .with_impulse(it.part * end.impulse);
        Some(self.jump(run, time, &it, &reset))
    }

    /// Lands `time` (s) from now; the readout between the impacts is nearly straight.
    fn jump<S: Signal<M::Input>, W: Watch<M>>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        time: f64,
        taken: &Move,
        reset: &Reset<M>,
    ) -> bool {
        let theta = (run.theta + time / run.h).max(run.theta).min(1.0);
        let (from, duration) = (run.input(), (theta - run.theta) * run.h);
        run.move_to(theta);
        run.cascade += 1;
        run.since_event = run.resolution();
        let to = run.input();
        if self.is_read {
            let start = self.model.readout(self.mode, &self.state, &from);
            let end = self.model.readout(self.mode, &reset.state, &to);
            run.integral += 0.5 * duration * (start + end);
            run.work.readouts += 2;
        }
        self.impacts = Impacts::NONE;
        let Move { cause, error, .. } = *taken;
        self.land(run, EventReport { cause, error, projection: 0.0 }, reset, &to)
    }

    /// Returns `true` if the end is known to a fraction of the tick, or as well as its events.
    fn is_sure<S: Signal<M::Input>, W>(
        &self,
        run: &TickRun<'_, S, W>,
        resting: M::Mode,
        end: &Accumulation,
    ) -> bool {
        let is_known = is_exact(end.error, run.h) || is_near_the_last(run);
        let own = self.model.longest_step_at(resting, &self.state, &run.input());
        let longest = self.stepper.longest_step(&self.model.nature(resting), own);
        let has_piece = run.work.pieces < run.limits.pieces;
        is_known && has_piece && end.after.min(run.rest()) <= longest
    }

    /// Returns `true` if this tick followed enough impacts one by one, or they are too close to
    /// distinguish, in time or in the guard's rounding; and if the move takes at least one.
    fn is_worth_it<S, W>(
        &self,
        run: &TickRun<'_, S, W>,
        (after, ratio): (f64, f64),
        (fired, bands): (GuardId, f64),
    ) -> bool {
        let is_flat = self.is_flat((after, ratio), (fired, bands));
        let is_soon = is_flat || run.work.events >= run.limits.followed;
        (is_soon || after <= run.resolution())
            && run.work.events < run.limits.events
            && run.cascade < run.limits.cascade
            && (after <= run.rest() || impacts_within(run.rest(), after, ratio) >= 1.0)
    }

    /// Returns `true` if a hop is lost in the rounding of its guard.
    fn is_flat(&self, (after, ratio): (f64, f64), (fired, bands): (GuardId, f64)) -> bool {
        // A hop rises to a quarter of its first rate times its duration.
        self.guards.iter().zip(self.model.guards(self.mode)).any(|(slot, spec)| {
            let rise = 0.25 * slot.value.rate * after * (1.0 - ratio);
            spec.id == fired && rise <= bands * spec.band()
        })
    }
}

fn is_near_the_last<S, W>(run: &TickRun<'_, S, W>) -> bool {
    const SPARE: u32 = 2;
    run.work.events + SPARE >= run.limits.events
}

/// Returns `true` if an error (s) is negligible in a tick of `h` (s): 1 ns at 1 ms.
fn is_exact(error: f64, h: f64) -> bool {
    const PART: f64 = 1.0 / 1_048_576.0;
    error <= PART * h
}
