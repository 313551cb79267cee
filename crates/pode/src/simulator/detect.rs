//! The first crossing of a step.

use core::cell::Cell;

use super::field::ModeField;
use super::{Simulator, TakenStep};
use crate::crossing::{Crossing, GuardSpan};
use crate::dense::Dense as _;
use crate::epoch::Stand;
use crate::forecast::GuardSlot;
use crate::guard::{GuardSet, GuardSpec, GuardValue, MAX_GUARDS};
use crate::input::Signal;
use crate::locate::{locate, most_evaluations};
use crate::model::Resets;
use crate::outcome::{Cap, Fault, StepCertainty};
use crate::run::TickRun;
use crate::stepper::Stepper;

/// The first crossing of a step: which guard, where in the step, and who else is there.
#[derive(Clone, Copy)]
pub(super) struct First {
    pub(super) index: usize,
    pub(super) tau: f64,
    /// All guards that cross there, this one included.
    pub(super) crossed: GuardSet,
}

/// Where in the step a guard crosses: `tau` ± `radius`.
#[derive(Clone, Copy)]
struct CrossingTime {
    tau: f64,
    radius: f64,
}

impl CrossingTime {
    const NOWHERE: Self = Self { tau: f64::INFINITY, radius: 0.0 };
}

/// The guards that may cross in a step, by their place among the mode's guards.
pub(super) type Candidates = [Option<GuardSpan<'static>>; MAX_GUARDS];

impl<M: Resets, T: Stepper> Simulator<M, T> {
    /// Evaluates the guards at the end of a step, and says whether any of them may have crossed:
    /// these are the `candidates`.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    pub(super) fn may_cross<S: Signal<M::Input>, W>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
        candidates: &mut Candidates,
    ) -> Result<bool, Fault> {
        let (mut any, mut verdict) = (false, StepCertainty::Certified);
        let uncertain = self.uncertain(taken.h);
        for (index, spec) in self.model.guards(self.mode).iter().enumerate().take(MAX_GUARDS) {
            let slot = &mut self.guards[index];
            if run.limits.forecast && slot.is_asleep(taken.h) {
                slot.later(taken.h);
                continue;
            }
            let Some(span) = self.span(run, taken, index, spec)? else { return Ok(false) };
            verdict =
                verdict.max(if span.is_certain() { StepCertainty::Certified } else { uncertain });
            if !span.is_quiet && span.may_cross() {
                candidates[index] = Some(span);
                any = true;
            }
        }
        run.work.judge(verdict);
        Ok(any)
    }

    /// The earliest crossing of the candidates within the step; ties go to the lower priority
    /// number.
    pub(super) fn first_crossing<S: Signal<M::Input>, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        taken: &mut TakenStep<M, T>,
        candidates: &Candidates,
    ) -> Result<Option<First>, Fault> {
        self.refine(run, taken);
        let mut places = [CrossingTime::NOWHERE; MAX_GUARDS];
        for (place, span) in places.iter_mut().zip(candidates) {
            if let Some(span) = span {
                *place = self.crossing_place(run, taken, span)?;
            }
        }
        Ok(match self.model.guards(self.mode) {
            [only] => alone(only, places[0]),
            specs => earliest(specs, &places),
        })
    }

    /// A guard's values at both ends of a step, and from there what it will do next; `None` if
    /// the tick has no more evaluations.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    fn span<S: Signal<M::Input>, W>(
        &mut self,
        run: &mut TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
        index: usize,
        spec: &'static GuardSpec,
    ) -> Result<Option<GuardSpan<'static>>, Fault> {
        let slot = self.guards[index];
        let is_quiet = run.limits.forecast && slot.is_quiet(taken.h);
        if !run.spend_guards(1 + u32::from(!slot.is_fresh && !is_quiet)) {
            return Ok(None);
        }
        let guard = |x: &M::State, input: &M::Input| self.model.guard(self.mode, spec.id, x, input);
        let end = guard(&taken.end, &taken.input);
        // After a sleep the value at the start is not known, and not needed either.
        let is_enough = slot.is_fresh || is_quiet;
        let start = if is_enough { slot.value } else { guard(&self.state, &run.input()) };
        if ![end.value, end.rate, start.value, start.rate].iter().all(|it| it.is_finite()) {
            return Err(Fault::Guard);
        }
        let bound = self.model.curvature_bound(self.mode, spec.id);
        let mut next = GuardSlot::new(slot.stand, spec, end, bound);
        if self.stepper.aims() {
            next.curvature = (end.rate - start.rate) / taken.h;
        }
        self.guards[index] = next;
        let sinks =
            slot.stand == Stand::Spent && self.would_turn(run, (taken.end, taken.input), spec, end);
        let stand = if sinks { Stand::Sinking } else { slot.stand };
        Ok(Some(GuardSpan { spec, stand, start, end, h: taken.h, bound, is_quiet }))
    }

    /// Whether the reset map of a guard that has sunk to `end` would bring it back up.
    #[cold]
    fn would_turn<S, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        (x, input): (M::State, M::Input),
        spec: &GuardSpec,
        end: GuardValue,
    ) -> bool {
        if end.value >= -spec.band() || end.rate >= 0.0 || !run.spend_guards(1) {
            return false;
        }
        let reset = self.model.reset(self.mode, spec.id, &x, &input);
        let after = self.model.guard(self.mode, spec.id, &reset.state, &input);
        reset.mode != self.mode || after.rate >= 0.0
    }

    /// What is known of a step of `h` (s) over which a guard is not positive for certain.
    #[inline]
    fn uncertain(&self, h: f64) -> StepCertainty {
        let nature = self.model.nature(self.mode);
        // Without a rate a linear mode is a polynomial in the time; others then go by their step.
        let is_resolved = if nature.is_linear() || nature.rate > 0.0 {
            nature.rate * h <= 1.0
        } else {
            let own = self.model.longest_step(self.mode);
            h <= own && own < f64::INFINITY
        };
        if is_resolved { StepCertainty::Likely } else { StepCertainty::Unknown }
    }

    /// Has the stepper bring the step's dense output to its full order.
    #[inline]
    pub(super) fn refine<S: Signal<M::Input>, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        taken: &mut TakenStep<M, T>,
    ) {
        if taken.is_refined {
            return;
        }
        taken.is_refined = true;
        let part = (run.theta, taken.theta_end - run.theta);
        let mut field = ModeField::new(&self.model, self.mode, run.signal, part);
        self.stepper.refine(&mut field, &self.memory, &mut taken.step.dense, taken.h);
        field.count(&mut run.work);
    }

    /// Where in the step one guard crosses, if it does.
    #[inline]
    fn crossing_place<S: Signal<M::Input>, W>(
        &self,
        run: &mut TickRun<'_, S, W>,
        taken: &TakenStep<M, T>,
        span: &GuardSpan<'_>,
    ) -> Result<CrossingTime, Fault> {
        let (dense, theta_end) = (&taken.step.dense, taken.theta_end);
        // The tolerance is a fraction of the tick; the step is a part of it.
        let tolerance = (run.limits.event_tolerance / (theta_end - run.theta)).min(0.5);
        if !run.affords_guards(GuardSpan::LOOKS + most_evaluations(tolerance)) {
            run.cap(Cap::Guards);
            return Ok(CrossingTime::NOWHERE);
        }
        let (model, mode, signal, start) = (&self.model, self.mode, run.signal, run.theta);
        let (looks, is_finite) = (Cell::new(0), Cell::new(true));
        let guard = |tau: f64| {
            let input = signal.at(start + tau * (theta_end - start));
            let x = model.constrain(mode, &dense.at(tau), &input);
            model.guard(mode, span.spec.id, &x, &input).value
        };
        let counted = |tau: f64| {
            let value = guard(tau);
            looks.set(looks.get() + 1);
            is_finite.set(is_finite.get() && value.is_finite());
            value
        };
        let place = match span.crossing(counted) {
            Crossing::None => CrossingTime::NOWHERE,
            Crossing::AtStart => CrossingTime { tau: 0.0, radius: 0.5 * tolerance },
            Crossing::Within { bracket, level, seed } => {
                let located = locate(|tau| guard(tau) - level, bracket, seed, tolerance);
                looks.set(looks.get() + located.evaluations);
                is_finite.set(is_finite.get() && !located.not_finite);
                let slope = seed.map_or(bracket.at_hi - bracket.at_lo, |(_, slope)| slope);
                let radius = 0.5 * tolerance + slack(span.spec, slope);
                CrossingTime { tau: located.tau, radius }
            }
        };
        run.work.guards += looks.get();
        if is_finite.get() { Ok(place) } else { Err(Fault::Guard) }
    }
}

/// How far rounding alone can move a crossing with `slope` (1/step), as a part of the step.
fn slack(spec: &GuardSpec, slope: f64) -> f64 {
    /// 1 ns at 1 ms; a touch without a slope is as sharp as that.
    const MOST: f64 = 1.0 / 1_048_576.0;
    // A slope of zero gives infinity, or NaN without a band, and `min` takes the other.
    (spec.band() / slope.abs()).min(MOST)
}

/// The crossing of a mode's only guard.
#[inline]
fn alone(spec: &GuardSpec, place: CrossingTime) -> Option<First> {
    let mut crossed = GuardSet::EMPTY;
    crossed.insert(spec.id);
    place.tau.is_finite().then_some(First { index: 0, tau: place.tau, crossed })
}

/// The earliest crossing; among those that cannot be told from it, the lowest priority.
///
/// Depends on the set of guards only, not on their order.
fn earliest(specs: &[GuardSpec], places: &[CrossingTime; MAX_GUARDS]) -> Option<First> {
    let limit = specs
        .iter()
        .zip(places)
        .map(|(_, place)| place.tau + place.radius)
        .fold(f64::INFINITY, f64::min);
    if limit.is_infinite() {
        return None;
    }
    let meets = |place: &CrossingTime| place.tau - place.radius <= limit;
    let mut crossed = GuardSet::EMPTY;
    for (spec, _) in specs.iter().zip(places).filter(|(_, place)| meets(place)) {
        crossed.insert(spec.id);
    }
    let simultaneous = specs.iter().zip(places).enumerate().filter(|(_, (_, place))| meets(place));
    simultaneous
        .min_by_key(|(_, (spec, _))| (spec.priority, spec.id.0))
        .map(|(index, (_, place))| First { index, tau: place.tau, crossed })
}
